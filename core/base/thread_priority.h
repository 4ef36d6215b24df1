/// Threads that must not wait for the rest of the machine.
#pragma once

namespace limbwave {

/// Lets the calling thread run before ordinary ones, as far as the system allows this user: by the lowest real-time
/// priority, else by a better nice value. False when neither is allowed; nothing has changed then. For threads that
/// sleep most of the time.
bool prefer_this_thread();

}  // namespace limbwave

/// Names of rigs, sensors and bones as people read them.
#pragma once

#include <QString>
#include <string>

namespace limbwave::ui {

/// A name or a text from a rig's or a skeleton's file in the user's language where it is one of those that we ship;
/// others are shown as they are. Files, exports and scripts keep the names of the files.
QString shown_name(const std::string& name);

}  // namespace limbwave::ui

/// glTF text files that hold their numbers themselves. Used by the reader alone.
#pragma once

#include <string>

namespace limbwave::interchange {

/// A text file whose one buffer lies inside it as base64, in the binary form, which takes a fraction of the memory to
/// parse. Everything else, broken base64 too, comes back as it is.
std::string gltf_as_binary(std::string file);

}  // namespace limbwave::interchange

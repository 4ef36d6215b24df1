/// Constants of binary FBX 7.4.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace limbwave::interchange {

inline constexpr std::string_view kFbxMagic{"Kaydara FBX Binary  \0\x1a\0", 23};
inline constexpr std::uint32_t kFbxVersion = 7400;
inline constexpr std::array<char, 13> kFbxNullRecord{};

/// File id, creation time and footer id belong together: with any others Autodesk's SDK reads an empty scene.
inline constexpr std::string_view kFbxFileId{"\x28\xb3\x2a\xeb\xb6\x24\xcc\xc2\xbf\xc8\xb0\x2a\xa9\x2b\xfc\xf1", 16};
inline constexpr std::string_view kFbxCreationTime = "1970-01-01 10:00:00:000";
inline constexpr std::string_view kFbxFooterId{"\xfa\xbc\xab\x09\xd0\xc8\xd4\x66\xb1\x76\xfb\x83\x1c\xf7\x26\x7e", 16};
inline constexpr std::string_view kFbxFooterEnd{"\xf8\x5a\x8c\x6a\xde\xf5\xd9\x7e\xec\xe9\x0c\xe3\x75\x8f\x29\x0b", 16};

/// Times are whole numbers of this fraction of a second.
inline constexpr double kFbxTicksPerSecond = 46186158000.0;

/// Bits of a key's attributes: how the curve goes on after it.
inline constexpr std::int32_t kFbxConstant = 0x2;
inline constexpr std::int32_t kFbxLinear = 0x4;
inline constexpr std::int32_t kFbxCubic = 0x8;

/// A property of our own on bones: their length in metres, for which FBX has no place.
inline constexpr std::string_view kFbxLengthProperty = "limbwave_length_m";

/// Between the parts of an object's name.
inline constexpr std::string_view kFbxNameSeparator{"\0\x01", 2};

}  // namespace limbwave::interchange

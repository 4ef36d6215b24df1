/// Parsing of glTF files and checked access to their numbers. Used by the readers alone.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace limbwave::interchange {

/// A glTF file, binary or text, parsed and safe to walk: depth of JSON and sizes of chunks are checked, images are not
/// loaded, and buffers that are files of their own are read only from `folder` and below (empty: not at all).
Result<tinygltf::Model> parse_gltf(std::string_view bytes, const std::string& place,
                                   const std::filesystem::path& folder = {});

/// All numbers of an accessor as floats, row by row; integers that are normalised become -1..1 or 0..1. Nothing when
/// the accessor does not exist, has another type than one of `types` (TINYGLTF_TYPE_...), or reaches outside its
/// buffer.
struct GltfNumbers {
  std::vector<float> values;
  std::size_t width = 0;  ///< Numbers an element.
  [[nodiscard]] std::size_t count() const { return width == 0 ? 0 : values.size() / width; }
};
std::optional<GltfNumbers> gltf_numbers(const tinygltf::Model& model, int index, std::initializer_list<int> types);
/// The same of `count` elements from `first` on; nothing when there are not as many.
std::optional<GltfNumbers> gltf_numbers(const tinygltf::Model& model, int index, std::initializer_list<int> types,
                                        std::size_t first, std::size_t count);
/// Elements that an accessor says it has; 0 when it does not exist.
std::size_t gltf_count(const tinygltf::Model& model, int index);

/// All numbers of an accessor of unsigned integers (indices, joints).
std::optional<std::vector<std::uint32_t>> gltf_integers(const tinygltf::Model& model, int index,
                                                        std::initializer_list<int> types);

}  // namespace limbwave::interchange

/// The binary part of a glTF file that is being made: views and accessors of one buffer.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace limbwave::interchange {

/// Appends numbers to buffer 0 of a model; every accessor has a view of its own, aligned to four bytes.
class GltfBuffer {
 public:
  explicit GltfBuffer(tinygltf::Model& model) : model_(model) { model_.buffers.emplace_back(); }

  /// `width` numbers an element. `target`: TINYGLTF_TARGET_... for vertices and indices, 0 for everything else (the
  /// validator wants none there). `with_bounds` writes min and max, which positions and key times must have.
  template <typename T>
  int add(std::span<const T> values, std::size_t width, int type, int component, int target, bool with_bounds) {
    std::vector<unsigned char>& bytes = model_.buffers[0].data;
    bytes.resize((bytes.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = values.size_bytes();
    view.target = target;
    bytes.resize(bytes.size() + values.size_bytes());
    std::memcpy(bytes.data() + view.byteOffset, values.data(), values.size_bytes());
    model_.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = values.size() / width;
    if (with_bounds && !values.empty()) {
      for (std::size_t c = 0; c < width; ++c) {
        T lowest = values[c];
        T highest = values[c];
        for (std::size_t i = c; i < values.size(); i += width) {
          lowest = values[i] < lowest ? values[i] : lowest;
          highest = values[i] > highest ? values[i] : highest;
        }
        accessor.minValues.push_back(static_cast<double>(lowest));
        accessor.maxValues.push_back(static_cast<double>(highest));
      }
    }
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  int add_floats(const std::vector<float>& values, int type, int target = 0, bool with_bounds = false) {
    const std::size_t width = type == TINYGLTF_TYPE_SCALAR ? 1
                              : type == TINYGLTF_TYPE_VEC3 ? 3
                              : type == TINYGLTF_TYPE_VEC4 ? 4
                                                           : 16;
    return add(std::span<const float>(values), width, type, TINYGLTF_COMPONENT_TYPE_FLOAT, target, with_bounds);
  }

  [[nodiscard]] std::size_t size() const { return model_.buffers[0].data.size(); }

 private:
  tinygltf::Model& model_;
};

}  // namespace limbwave::interchange

/// The binary part of a glTF file that is being made: views and accessors of one buffer.
#pragma once

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/byte_sink.h"
#include "base/progress.h"
#include "base/result.h"

namespace limbwave::interchange {

/// Plans what stands in buffer 0 of a model; every accessor has a view of its own, aligned to four bytes. The keys of
/// tracks are converted when they are written and never held in memory.
class GltfBuffer {
 public:
  explicit GltfBuffer(tinygltf::Model& model) : model_(model) {}

  /// `width` numbers an element. `target`: TINYGLTF_TARGET_... for vertices and indices, 0 for everything else (the
  /// validator wants none there). `with_bounds` writes min and max, which positions and key times must have.
  template <typename T>
  int add(std::span<const T> values, std::size_t width, int type, int component, int target, bool with_bounds) {
    std::string bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    append(values.size_bytes(), target, [bytes = std::move(bytes)](ByteSink& sink) { sink.append(bytes); });
    tinygltf::Accessor accessor;
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
    return add_accessor(std::move(accessor), values.size() / width, type, component);
  }

  int add_floats(const std::vector<float>& values, int type, int target = 0, bool with_bounds = false) {
    const std::size_t width = type == TINYGLTF_TYPE_SCALAR ? 1
                              : type == TINYGLTF_TYPE_VEC3 ? 3
                              : type == TINYGLTF_TYPE_VEC4 ? 4
                                                           : 16;
    return add(std::span<const float>(values), width, type, TINYGLTF_COMPONENT_TYPE_FLOAT, target, with_bounds);
  }

  /// Keys of a track, as gltf_keys.h converts them; `keys` must stay as they are until all is written.
  int add_keys(const std::vector<Eigen::Quaterniond>& keys);
  int add_keys(const std::vector<Eigen::Vector3d>& keys);

  /// Bytes of all, also of what is not written yet.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Writes all. Fails when cancelled.
  Status write(ByteSink& sink, const Progress& progress) const;

 private:
  struct Piece {
    std::size_t padding = 0;  // zero bytes before it
    std::function<void(ByteSink&)> write;
  };
  void append(std::size_t bytes, int target, std::function<void(ByteSink&)> write);
  int add_accessor(tinygltf::Accessor accessor, std::size_t count, int type, int component);

  tinygltf::Model& model_;
  std::vector<Piece> pieces_;
  std::uint64_t size_ = 0;
};

/// Writes a glTF file: the JSON of `model` and the buffer, as a binary file or inside the text. Fails when a size does
/// not fit into 32 bits, when the model cannot be written, or when cancelled.
Status write_gltf_file(tinygltf::Model& model, const GltfBuffer& buffer, bool binary, ByteSink& sink,
                       const std::string& place, const Progress& progress = {});

}  // namespace limbwave::interchange

#include "interchange/gltf_buffer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "interchange/gltf_keys.h"

namespace limbwave::interchange {
namespace {

// Keys that are converted at once: as floats they fill what a file takes without copying.
constexpr std::size_t kKeysAtOnce = std::size_t{1} << 16;
// Sizes are 32 bits; room for the JSON is left.
constexpr std::uint64_t kLargestBuffer = std::numeric_limits<std::uint32_t>::max() - (std::uint64_t{1} << 24);

/// Base64 (RFC 4648) of what is appended.
class Base64Sink final : public ByteSink {
 public:
  explicit Base64Sink(ByteSink& out) : out_(out) {}

  void append(std::string_view bytes) override {
    size_ += bytes.size();
    std::string text;
    text.reserve(bytes.size() / 3 * 4 + 8);
    for (const char byte : bytes) {
      rest_[count_++] = static_cast<unsigned char>(byte);
      if (count_ == 3) {
        put(text);
      }
    }
    out_.append(text);
  }
  void finish() {
    if (count_ > 0) {
      std::string text;
      const std::size_t used = count_;
      std::fill(rest_.begin() + static_cast<std::ptrdiff_t>(used), rest_.end(), static_cast<unsigned char>(0));
      put(text);
      text.replace(used + 1, 3 - used, 3 - used, '=');
      out_.append(text);
    }
  }
  void overwrite(std::uint64_t /*offset*/, std::string_view /*bytes*/) override { assert(false); }
  [[nodiscard]] std::uint64_t size() const override { return size_; }

 private:
  void put(std::string& text) {
    static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::array<char, 4> four = {kDigits[rest_[0] >> 2U], kDigits[(rest_[0] & 3U) << 4U | rest_[1] >> 4U],
                                      kDigits[(rest_[1] & 15U) << 2U | rest_[2] >> 6U], kDigits[rest_[2] & 63U]};
    text.append(four.data(), four.size());
    count_ = 0;
  }

  ByteSink& out_;
  std::uint64_t size_ = 0;
  std::array<unsigned char, 3> rest_{};
  std::size_t count_ = 0;
};

void put(std::string& text, std::uint32_t word) {
  text.append(reinterpret_cast<const char*>(&word), sizeof word);
}

std::string_view bytes_of(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

// What tinygltf makes of the model, without its buffers.
std::optional<nlohmann::json> json_of(tinygltf::Model& model) {
  std::ostringstream stream;
  model.buffers.clear();
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, false)) {
    return {};
  }
  nlohmann::json json = nlohmann::json::parse(std::move(stream).str(), nullptr, false);
  return json.is_object() ? std::optional(std::move(json)) : std::nullopt;
}

}  // namespace

void GltfBuffer::append(std::size_t bytes, int target, std::function<void(ByteSink&)> write) {
  const std::size_t padding = (4 - size_ % 4) % 4;
  size_ += padding;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = size_;
  view.byteLength = bytes;
  view.target = target;
  model_.bufferViews.push_back(std::move(view));
  size_ += bytes;
  pieces_.push_back({padding, std::move(write)});
}

int GltfBuffer::add_accessor(tinygltf::Accessor accessor, std::size_t count, int type, int component) {
  accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
  accessor.componentType = component;
  accessor.type = type;
  accessor.count = count;
  model_.accessors.push_back(std::move(accessor));
  return static_cast<int>(model_.accessors.size()) - 1;
}

int GltfBuffer::add_keys(const std::vector<Eigen::Quaterniond>& keys) {
  append(keys.size() * 4 * sizeof(float), 0, [&keys](ByteSink& sink) {
    GltfRotations convert;
    std::vector<float> values;
    for (std::size_t i = 0; i < keys.size(); i += kKeysAtOnce) {
      const std::span part = std::span(keys).subspan(i, std::min(kKeysAtOnce, keys.size() - i));
      values.resize(part.size() * 4);
      convert(part, values.data());
      sink.append(bytes_of(values));
    }
  });
  return add_accessor({}, keys.size(), TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_FLOAT);
}

int GltfBuffer::add_keys(const std::vector<Eigen::Vector3d>& keys) {
  append(keys.size() * 3 * sizeof(float), 0, [&keys](ByteSink& sink) {
    std::vector<float> values;
    for (std::size_t i = 0; i < keys.size(); i += kKeysAtOnce) {
      const std::span part = std::span(keys).subspan(i, std::min(kKeysAtOnce, keys.size() - i));
      values.resize(part.size() * 3);
      gltf_positions(part, values.data());
      sink.append(bytes_of(values));
    }
  });
  return add_accessor({}, keys.size(), TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT);
}

Status GltfBuffer::write(ByteSink& sink, const Progress& progress) const {
  const std::string zeros(4, '\0');
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (!progress.report(static_cast<double>(i) / static_cast<double>(pieces_.size()), "writing")) {
      return cancelled();
    }
    sink.append(std::string_view(zeros).substr(0, pieces_[i].padding));
    pieces_[i].write(sink);
  }
  return {};
}

Status write_gltf_file(tinygltf::Model& model, const GltfBuffer& buffer, bool binary, ByteSink& sink,
                       const std::string& place, const Progress& progress) {
  // Text holds three bytes in four characters.
  if (buffer.size() > (binary ? kLargestBuffer : kLargestBuffer / 4 * 3)) {
    return Error{"does not fit into a glTF file (4 GB)", place, "export a part of it or fewer frames a second"};
  }
  std::optional<nlohmann::json> json = json_of(model);
  if (!json) {
    return Error{"cannot be written as glTF", place, "export again"};
  }
  const std::uint64_t size = buffer.size();
  if (!binary) {
    std::string text = json->dump();
    text.pop_back();
    const std::string tail = size == 0 ? ""
                                       : R"(,"buffers":[{"byteLength":)" + std::to_string(size) +
                                             R"(,"uri":"data:application/octet-stream;base64,)";
    sink.append(text + tail);
    if (size > 0) {
      Base64Sink base64(sink);
      if (Status status = buffer.write(base64, progress); !status) {
        return status;
      }
      base64.finish();
      sink.append("\"}]");
    }
    sink.append("}");
    return {};
  }
  if (size > 0) {
    (*json)["buffers"] = nlohmann::json::array({nlohmann::json::object({{"byteLength", size}})});
  }
  std::string text = json->dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  const std::size_t padding = (4 - size % 4) % 4;
  const std::uint64_t chunk = size == 0 ? 0 : 8 + size + padding;
  if (20 + text.size() + chunk > std::numeric_limits<std::uint32_t>::max()) {
    return Error{"does not fit into a glTF file (4 GB)", place, "export a part of it or fewer frames a second"};
  }
  std::string head = "glTF";
  put(head, 2);
  put(head, static_cast<std::uint32_t>(20 + text.size() + chunk));
  put(head, static_cast<std::uint32_t>(text.size()));
  head += "JSON" + text;
  if (size > 0) {
    put(head, static_cast<std::uint32_t>(size + padding));
    head += std::string("BIN\0", 4);
  }
  sink.append(head);
  if (Status status = buffer.write(sink, progress); !status) {
    return status;
  }
  sink.append(std::string(padding, '\0'));
  return {};
}

}  // namespace limbwave::interchange

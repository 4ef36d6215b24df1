#include "interchange/gltf_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/files.h"
#include "base/json_reader.h"

namespace limbwave::interchange {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeader = 12;  // of a binary file
constexpr std::size_t kChunk = 8;    // of each chunk: its length and kind
// Elements of one accessor without data of its own; those with data are bounded by it.
constexpr std::size_t kMostSparse = std::size_t{1} << 20;

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

bool is_binary(std::string_view bytes) {
  return bytes.starts_with("glTF");
}

// The text of the file. tinygltf recurses into JSON without limit and trusts sizes, so both are checked before.
Result<std::string_view> json_text(std::string_view bytes, const std::string& place) {
  if (!is_binary(bytes)) {
    if (bytes.starts_with("\xEF\xBB\xBF")) {
      bytes.remove_prefix(3);
    }
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || bytes[first] != '{') {
      return Error{"is not a glTF file", place, "check that it is the right file"};
    }
    return bytes;
  }
  if (bytes.size() < kHeader + kChunk) {
    return Error{"is cut off", place, "check that it was copied whole"};
  }
  if (word(bytes, 4) != 2) {
    return Error{fmt::format("is glTF version {}", word(bytes, 4)), place, "use glTF 2.0"};
  }
  bool whole = word(bytes, 8) == bytes.size();
  for (std::size_t at = kHeader; whole && at < bytes.size();) {
    const std::size_t left = bytes.size() - at;
    whole = left >= kChunk && word(bytes, at) <= left - kChunk;
    at += whole ? kChunk + word(bytes, at) : 0;
  }
  if (!whole) {
    return Error{"is cut off or has something behind its end", place, "check that it was copied whole"};
  }
  return bytes.substr(kHeader + kChunk, word(bytes, kHeader));
}

bool refuse_image(tinygltf::Image* /*image*/, int /*index*/, std::string* /*error*/, std::string* /*warning*/,
                  int /*width*/, int /*height*/, const unsigned char* /*bytes*/, int /*size*/, void* /*user*/) {
  return true;
}

// Reading for tinygltf: only what lies in the folder or below it.
struct Folder {
  fs::path path;

  static bool exists(const std::string& name, void* user) {
    const auto& self = *static_cast<const Folder*>(user);
    std::error_code error;
    return !self.path.empty() && self.allows(name) && fs::is_regular_file(name, error);
  }
  static std::string expand(const std::string& name, void* /*user*/) { return name; }
  static bool read(std::vector<unsigned char>* out, std::string* error, const std::string& name, void* user) {
    const auto& self = *static_cast<const Folder*>(user);
    if (self.path.empty() || !self.allows(name)) {
      *error = "refers to a file elsewhere, " + name;
      return false;
    }
    const Result<std::string> bytes = read_file(name, std::size_t{1} << 32);
    if (!bytes) {
      *error = bytes.error().text();
      return false;
    }
    out->assign(bytes->begin(), bytes->end());
    return true;
  }
  static bool write(std::string* /*error*/, const std::string& /*name*/, const std::vector<unsigned char>& /*bytes*/,
                    void* /*user*/) {
    return false;
  }

 private:
  [[nodiscard]] bool allows(const std::string& name) const {
    const fs::path inside = fs::path(name).lexically_normal().lexically_relative(path.lexically_normal());
    return !inside.empty() && *inside.begin() != "..";
  }
};

struct Bytes {
  const unsigned char* start = nullptr;
  std::size_t stride = 0;
};

// Where `count` elements of `element` bytes lie in a view; nothing when they would reach outside.
std::optional<Bytes> locate(const tinygltf::Model& model, int view_index, std::size_t offset, std::size_t count,
                            std::size_t element) {
  if (view_index < 0 || static_cast<std::size_t>(view_index) >= model.bufferViews.size()) {
    return {};
  }
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
    return {};
  }
  const std::vector<unsigned char>& bytes = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  const std::size_t stride = view.byteStride == 0 ? element : view.byteStride;
  // Each step is checked against what is left, so that no sum can wrap around.
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset || offset > view.byteLength ||
      stride < element) {
    return {};
  }
  const std::size_t room = view.byteLength - offset;
  if (count == 0 || room < element || count - 1 > (room - element) / stride) {
    return {};
  }
  return Bytes{bytes.data() + view.byteOffset + offset, stride};
}

template <typename T>
double read_as(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double component(const unsigned char* bytes, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return read_as<std::int8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return read_as<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return read_as<std::int16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return read_as<std::uint16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return read_as<std::uint32_t>(bytes);
    default:
      return read_as<float>(bytes);
  }
}

// What a normalised integer is divided by.
double full_scale(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return 127.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 255.0;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return 32767.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 65535.0;
    default:
      return 1.0;
  }
}

const tinygltf::Accessor* find(const tinygltf::Model& model, int index, std::initializer_list<int> types) {
  if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()) {
    return nullptr;
  }
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const bool known = std::ranges::find(types, accessor.type) != types.end() &&
                     tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)) > 0;
  return known ? &accessor : nullptr;
}

struct Range {
  std::size_t first = 0;
  std::size_t count = 0;
};

// Components of some elements as doubles, sparse ones put in their places. The whole accessor is checked.
std::optional<std::vector<double>> components(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                                              Range range) {
  const auto size =
      static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
  const auto width =
      static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  const std::size_t element = size * width;
  const auto copy = [&](const Bytes& from, std::size_t i, double* to) {
    for (std::size_t c = 0; c < width; ++c) {
      to[c] = component(from.start + i * from.stride + c * size, accessor.componentType);
    }
  };
  std::vector<double> values;
  if (accessor.bufferView >= 0) {
    const auto bytes = locate(model, accessor.bufferView, accessor.byteOffset, accessor.count, element);
    if (!bytes) {
      return {};
    }
    values.resize(range.count * width);
    for (std::size_t i = 0; i < range.count; ++i) {
      copy(*bytes, range.first + i, values.data() + i * width);
    }
  } else {
    if (accessor.count == 0 || accessor.count > kMostSparse) {
      return {};
    }
    values.assign(range.count * width, 0.0);
  }
  if (accessor.sparse.isSparse) {
    const auto& sparse = accessor.sparse;
    const int index_size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(sparse.indices.componentType));
    if (sparse.count <= 0 || index_size <= 0) {
      return {};
    }
    const auto count = static_cast<std::size_t>(sparse.count);
    const auto indices = locate(model, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                                count, static_cast<std::size_t>(index_size));
    const auto replaced =
        locate(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count, element);
    if (!indices || !replaced) {
      return {};
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double index = component(indices->start + i * indices->stride, sparse.indices.componentType);
      if (!(index >= 0.0 && index < static_cast<double>(accessor.count))) {
        return {};
      }
      const auto element_index = static_cast<std::size_t>(index);
      if (element_index >= range.first && element_index - range.first < range.count) {
        copy(*replaced, i, values.data() + (element_index - range.first) * width);
      }
    }
  }
  return values;
}

}  // namespace

Result<tinygltf::Model> parse_gltf(std::string_view bytes, const std::string& place, const fs::path& folder) {
  const Result<std::string_view> text = json_text(bytes, place);
  if (!text) {
    return text.error();
  }
  if (const Result<nlohmann::json> json = parse_json(*text, place); !json) {
    return json.error();
  }
  Folder allowed{folder};
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(refuse_image, nullptr);
  loader.SetFsCallbacks({Folder::exists, Folder::expand, Folder::read, Folder::write, &allowed});
  loader.SetStoreOriginalJSONForExtrasAndExtensions(true);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  bool read = false;
  try {
    read = is_binary(bytes) ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                                          reinterpret_cast<const unsigned char*>(bytes.data()),
                                                          static_cast<unsigned int>(bytes.size()), folder.string())
                            : loader.LoadASCIIFromString(&model, &error, &warning, text->data(),
                                                         static_cast<unsigned int>(text->size()), folder.string());
  } catch (const std::exception& exception) {  // the library throws on JSON of unexpected types
    error = exception.what();
  }
  if (read) {
    return model;
  }
  std::ranges::replace(error, '\n', ' ');
  error.erase(error.find_last_not_of(" .") + 1);
  return Error{"is not valid glTF (" + error + ")", place, "check that it was copied whole"};
}

std::size_t gltf_count(const tinygltf::Model& model, int index) {
  return index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()
             ? 0
             : model.accessors[static_cast<std::size_t>(index)].count;
}

std::optional<GltfNumbers> gltf_numbers(const tinygltf::Model& model, int index, std::initializer_list<int> types) {
  return gltf_numbers(model, index, types, 0, gltf_count(model, index));
}

std::optional<GltfNumbers> gltf_numbers(const tinygltf::Model& model, int index, std::initializer_list<int> types,
                                        std::size_t first, std::size_t count) {
  const tinygltf::Accessor* accessor = find(model, index, types);
  if (accessor == nullptr || first > accessor->count || count > accessor->count - first) {
    return {};
  }
  const auto read = components(model, *accessor, {first, count});
  if (!read) {
    return {};
  }
  GltfNumbers result;
  result.width = static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor->type)));
  result.values.reserve(read->size());
  const double scale = accessor->normalized ? 1.0 / full_scale(accessor->componentType) : 1.0;
  for (const double value : *read) {
    result.values.push_back(static_cast<float>(std::max(value * scale, accessor->normalized ? -1.0 : value)));
  }
  return result;
}

std::optional<std::vector<std::uint32_t>> gltf_integers(const tinygltf::Model& model, int index,
                                                        std::initializer_list<int> types) {
  const tinygltf::Accessor* accessor = find(model, index, types);
  if (accessor == nullptr || (accessor->componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
                              accessor->componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
                              accessor->componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
    return {};
  }
  const auto read = components(model, *accessor, {0, accessor->count});
  if (!read) {
    return {};
  }
  std::vector<std::uint32_t> result;
  result.reserve(read->size());
  for (const double value : *read) {
    result.push_back(static_cast<std::uint32_t>(value));
  }
  return result;
}

}  // namespace limbwave::interchange

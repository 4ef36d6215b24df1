#include "fuzz/fbx_mutator.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "interchange/fbx_format.h"

namespace limbwave::test {
namespace {

constexpr std::size_t kHeader = 27;
constexpr std::size_t kLargestArray = std::size_t{1} << 20;  // bytes, unpacked

template <typename T>
void put(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::size_t size_of(char type) {
  return type == 'l' || type == 'd' || type == 'L' || type == 'D'   ? 8
         : type == 'i' || type == 'f' || type == 'I' || type == 'F' ? 4
         : type == 'Y'                                              ? 2
                                                                    : 1;
}

void put_number(char* at, char type, double value) {
  const auto whole = static_cast<std::int64_t>(std::isfinite(value) ? std::clamp(value, -9e18, 9e18) : 0.0);
  const auto single = static_cast<float>(value);
  switch (type) {
    case 'd':
    case 'D':
      std::memcpy(at, &value, sizeof value);
      break;
    case 'f':
    case 'F':
      std::memcpy(at, &single, sizeof single);
      break;
    default:
      std::memcpy(at, &whole, size_of(type));
  }
}

}  // namespace

FbxMutator::Node FbxMutator::tree_of(const interchange::FbxRecord& record) {
  Node node;
  node.name = record.name;
  for (const interchange::FbxValue& value : record.values) {
    std::string bytes(1, value.type);
    if (value.is_array()) {
      put(bytes, value.count);
      put(bytes, std::uint32_t{value.compressed ? 1U : 0U});
      put(bytes, static_cast<std::uint32_t>(value.bytes.size()));
      bytes += value.bytes;
    } else if (!value.is_number()) {
      put(bytes, static_cast<std::uint32_t>(value.bytes.size()));
      bytes += value.bytes;
    } else if (value.type == 'L') {
      put(bytes, value.integer);
    } else {
      bytes.resize(1 + size_of(value.type));
      put_number(bytes.data() + 1, value.type, value.number);
    }
    node.values.push_back(std::move(bytes));
  }
  for (const interchange::FbxRecord& child : record.children) {
    node.children.push_back(tree_of(child));
  }
  return node;
}

void FbxMutator::all_below(Node& node, std::vector<Node*>& list) {
  for (Node& child : node.children) {
    list.push_back(&child);
    all_below(child, list);
  }
}

void FbxMutator::append(const Node& node, std::string& out) {
  const std::size_t start = out.size();
  put(out, std::uint32_t{0});
  put(out, static_cast<std::uint32_t>(node.values.size()));
  std::uint32_t size = 0;
  for (const std::string& value : node.values) {
    size += static_cast<std::uint32_t>(value.size());
  }
  put(out, size);
  out += static_cast<char>(node.name.size());
  out += node.name;
  for (const std::string& value : node.values) {
    out += value;
  }
  for (const Node& child : node.children) {
    append(child, out);
  }
  if (!node.children.empty()) {
    out.append(interchange::kFbxNullRecord.data(), interchange::kFbxNullRecord.size());
  }
  const auto end = static_cast<std::uint32_t>(out.size());
  std::memcpy(out.data() + start, &end, sizeof end);
}

double FbxMutator::odd_number() {
  static constexpr std::array kOdd = {0.0,     -1.0,         1.0,          2.0,  1e-300, 1e30, -1e30,
                                      65535.0, 2147483647.0, 4294967296.0, 9e18, 90.0,   1e6,  46186158000.0};
  switch (pick(6)) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return std::numeric_limits<double>::infinity();
    case 2:
      return static_cast<double>(pick(8));
    case 3:
      return static_cast<double>(random_()) / 1e7 - 200.0;
    default:
      return kOdd[pick(kOdd.size())];
  }
}

void FbxMutator::change_array(std::string& value) {
  constexpr std::size_t kHead = 13;
  const char type = value[0];
  std::uint32_t count = 0;
  std::uint32_t packed = 0;
  std::memcpy(&count, value.data() + 1, 4);
  std::memcpy(&packed, value.data() + 5, 4);
  const std::size_t size = size_of(type);
  if (count * size > kLargestArray) {
    return;
  }
  std::string plain = value.substr(kHead);
  if (packed == 1) {
    plain.assign(count * size, '\0');
    auto got = static_cast<uLongf>(plain.size());
    uncompress(reinterpret_cast<Bytef*>(plain.data()), &got, reinterpret_cast<const Bytef*>(value.data() + kHead),
               value.size() - kHead);
  }
  plain.resize(count * size);
  const std::size_t which = pick(5);
  if (which == 0) {
    plain.resize(plain.size() / size / 2 * size);
  } else if (which == 1) {
    plain += plain.substr(0, size * pick(8));
  } else {
    for (std::size_t n = 0; n < 1 + pick(3) && plain.size() >= size; ++n) {
      put_number(plain.data() + pick(plain.size() / size) * size, type, odd_number());
    }
  }
  value.assign(1, type);
  put(value, static_cast<std::uint32_t>(plain.size() / size));
  put(value, std::uint32_t{0});
  put(value, static_cast<std::uint32_t>(plain.size()));
  value += plain;
}

void FbxMutator::change_value(std::string& value, const std::vector<Node*>& all) {
  const char type = value[0];
  if (type >= 'a' && type <= 'z') {
    change_array(value);
  } else if (type == 'S' || type == 'R' || pick(3) == 0) {
    // One that stands elsewhere: other names, other objects.
    const Node& other = *all[pick(all.size())];
    if (!other.values.empty()) {
      value = other.values[pick(other.values.size())];
    }
  } else {
    put_number(value.data() + 1, type, odd_number());
  }
}

void FbxMutator::change(Node& root) {
  std::vector<Node*> all;
  all_below(root, all);
  if (all.empty()) {
    return;
  }
  Node& node = *all[pick(all.size())];
  const std::size_t which = pick(12);
  if (which == 0 && !node.children.empty()) {
    node.children.erase(node.children.begin() + static_cast<std::ptrdiff_t>(pick(node.children.size())));
  } else if (which == 1 && !node.children.empty()) {
    const Node copy = node.children[pick(node.children.size())];
    node.children.insert(node.children.begin() + static_cast<std::ptrdiff_t>(pick(node.children.size())), copy);
  } else if (which == 2) {
    Node copy = *all[pick(all.size())];
    node.children.push_back(std::move(copy));
  } else if (which == 3) {
    node.name = all[pick(all.size())]->name;
  } else if (which == 4 && !node.values.empty()) {
    node.values.erase(node.values.begin() + static_cast<std::ptrdiff_t>(pick(node.values.size())));
  } else if (!node.values.empty()) {
    change_value(node.values[pick(node.values.size())], all);
  }
}

std::string FbxMutator::mutated(const std::string& bytes) {
  const Result<interchange::FbxRecords> records = interchange::FbxRecords::parse(bytes, "");
  if (!records) {
    return {};
  }
  Node root = tree_of(records->root());
  for (std::size_t n = 0; n < 1 + pick(4); ++n) {
    change(root);
  }
  std::string out(interchange::kFbxMagic);
  out.resize(kHeader);
  const std::uint32_t version = interchange::kFbxVersion;
  std::memcpy(out.data() + kHeader - 4, &version, 4);
  for (const Node& child : root.children) {
    append(child, out);
  }
  out.append(interchange::kFbxNullRecord.data(), interchange::kFbxNullRecord.size());
  return out;
}

}  // namespace limbwave::test

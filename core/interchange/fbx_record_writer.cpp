#include "interchange/fbx_record_writer.h"

#include <zlib.h>

#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <limits>

#include "interchange/fbx_format.h"

namespace limbwave::interchange {
namespace {

static_assert(std::endian::native == std::endian::little, "FBX is little-endian");

// Shorter arrays do not become smaller.
constexpr std::size_t kCompressFrom = 128;  // bytes

// Long arrays of measured numbers are noise to zlib; a piece from the middle says so before the time is spent.
constexpr std::size_t kProbe = 8192;  // bytes
constexpr std::size_t kProbeFrom = 8 * kProbe;
constexpr double kWorthwhile = 0.8;

bool compressible(const char* bytes, std::size_t size) {
  if (size < kProbeFrom) {
    return true;
  }
  std::array<Bytef, kProbe + 64> out{};
  uLongf packed = out.size();
  const char* middle = bytes + (size / 2) / 8 * 8;
  return compress2(out.data(), &packed, reinterpret_cast<const Bytef*>(middle), kProbe, 1) == Z_OK &&
         static_cast<double>(packed) < kWorthwhile * kProbe;
}

void put(std::string& bytes, std::uint32_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <typename T>
FbxArray pack(char type, std::span<const T> values, int level) {
  const std::size_t plain = values.size_bytes();
  FbxArray array(1, type);
  put(array, static_cast<std::uint32_t>(values.size()));
  constexpr std::size_t kHeader = 13;  // type, count, encoding, bytes
  if (plain >= kCompressFrom && level > 0 && compressible(reinterpret_cast<const char*>(values.data()), plain)) {
    uLongf size = compressBound(plain);
    array.resize(kHeader + size);
    const int result = compress2(reinterpret_cast<Bytef*>(array.data() + kHeader), &size,
                                 reinterpret_cast<const Bytef*>(values.data()), plain, level);
    if (result == Z_OK && size < plain) {
      const std::array<std::uint32_t, 2> rest = {1, static_cast<std::uint32_t>(size)};
      std::memcpy(array.data() + 5, rest.data(), sizeof rest);
      array.resize(kHeader + size);
      return array;
    }
    array.resize(5);
  }
  put(array, 0);
  put(array, static_cast<std::uint32_t>(plain));
  array.append(reinterpret_cast<const char*>(values.data()), plain);
  return array;
}

}  // namespace

FbxArray fbx_array(std::span<const std::int32_t> values, int level) {
  return pack('i', values, level);
}
FbxArray fbx_array(std::span<const std::int64_t> values, int level) {
  return pack('l', values, level);
}
FbxArray fbx_array(std::span<const float> values, int level) {
  return pack('f', values, level);
}
FbxArray fbx_array(std::span<const double> values, int level) {
  return pack('d', values, level);
}

FbxRecordWriter::FbxRecordWriter(ByteSink& file) : file_(file) {
  file_.append(kFbxMagic);
  const std::uint32_t version = kFbxVersion;
  file_.append({reinterpret_cast<const char*>(&version), sizeof version});
}

void FbxRecordWriter::begin(std::string_view name) {
  assert(name.size() < 256);
  if (!open_.empty()) {
    close_properties(open_.back());
  }
  Open record;
  record.start = file_.size();
  std::string head(12, '\0');
  head += static_cast<char>(name.size());
  head += name;
  file_.append(head);
  record.properties_start = file_.size();
  open_.push_back(record);
}

void FbxRecordWriter::scalar(char type, const void* value, std::size_t size) {
  std::array<char, 9> bytes{type};
  std::memcpy(bytes.data() + 1, value, size);
  file_.append({bytes.data(), size + 1});
  ++open_.back().properties;
}
void FbxRecordWriter::add(bool value) {
  const char byte = value ? 1 : 0;
  scalar('C', &byte, 1);
}
void FbxRecordWriter::add(std::int32_t value) {
  scalar('I', &value, sizeof value);
}
void FbxRecordWriter::add(std::int64_t value) {
  scalar('L', &value, sizeof value);
}
void FbxRecordWriter::add(double value) {
  scalar('D', &value, sizeof value);
}
void FbxRecordWriter::add(std::string_view value) {
  const auto size = static_cast<std::uint32_t>(value.size());
  scalar('S', &size, sizeof size);
  file_.append(value);
}
void FbxRecordWriter::add_raw(std::string_view bytes) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  scalar('R', &size, sizeof size);
  file_.append(bytes);
}
void FbxRecordWriter::add_array(const FbxArray& array) {
  file_.append(array);
  ++open_.back().properties;
}

// Fills in count and bytes of the properties when the first child begins or the record ends.
void FbxRecordWriter::close_properties(Open& record) {
  if (!record.children) {
    record.children = true;
    const std::array<std::uint32_t, 2> counts = {record.properties,
                                                 static_cast<std::uint32_t>(file_.size() - record.properties_start)};
    file_.overwrite(record.start + 4, {reinterpret_cast<const char*>(counts.data()), sizeof counts});
  }
}

void FbxRecordWriter::end(bool block) {
  assert(!open_.empty());
  Open& record = open_.back();
  if (record.children || block || record.properties == 0) {
    close_properties(record);
    file_.append(std::string_view(kFbxNullRecord.data(), kFbxNullRecord.size()));
  } else {
    close_properties(record);
  }
  const auto end = static_cast<std::uint32_t>(file_.size());
  file_.overwrite(record.start, {reinterpret_cast<const char*>(&end), sizeof end});
  open_.pop_back();
}

void FbxRecordWriter::finish() {
  assert(open_.empty());
  std::string foot(kFbxNullRecord.data(), kFbxNullRecord.size());
  foot += kFbxFooterId;
  foot.append(4, '\0');
  // One to sixteen zero bytes up to a multiple of sixteen.
  foot.append(16 - (file_.size() + foot.size()) % 16, '\0');
  put(foot, kFbxVersion);
  foot.append(120, '\0');
  foot += kFbxFooterEnd;
  file_.append(foot);
}

bool FbxRecordWriter::fits() const {
  return file_.size() <= std::numeric_limits<std::uint32_t>::max();
}

}  // namespace limbwave::interchange

#include "interchange/bvh_playback.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace limbwave::interchange {
namespace {

constexpr std::size_t kBlock = 4096;  // frames
constexpr std::size_t kLongestHead = std::size_t{16} << 20;
constexpr const char* kRemedy = "check that the disk has room, and export again";
constexpr std::string_view kFrames = "Frames:";

}  // namespace

BvhPlayback::BvhPlayback(std::ifstream file, std::string place, BvhReadOptions options)
    : file_(std::move(file)), place_(std::move(place)), options_(options) {}

Result<BvhPlayback> BvhPlayback::open(const std::filesystem::path& path, const BvhReadOptions& options) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return Error{"cannot be opened", path.string(), kRemedy};
  }
  BvhPlayback playback(std::move(file), path.string(), options);
  std::string line;
  while (playback.head_.size() < kLongestHead && std::getline(playback.file_, line)) {
    if (!line.starts_with(kFrames)) {
      playback.head_ += line + '\n';
      continue;
    }
    std::string_view digits(line);
    digits.remove_prefix(std::min(digits.size(), digits.find_first_of("0123456789")));
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), playback.declared_);
    if (problem != std::errc() || playback.declared_ == 0 || !std::getline(playback.file_, playback.timing_)) {
      break;
    }
    const Status loaded = playback.load();
    return loaded ? Result<BvhPlayback>(std::move(playback)) : Result<BvhPlayback>(loaded.error());
  }
  return Error{"has no frames", path.string(), kRemedy};
}

Status BvhPlayback::load() {
  // The last frame stays: what lies between it and the next one belongs to both blocks.
  if (!lines_.empty()) {
    first_ += lines_.size() - 1;
    lines_.erase(lines_.begin(), lines_.end() - 1);
  }
  std::string line;
  while (lines_.size() < kBlock && std::getline(file_, line)) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) {
      lines_.push_back(line);
    }
  }
  ended_ = lines_.size() < kBlock || file_.peek() == std::ifstream::traits_type::eof();
  const std::size_t frames = first_ + lines_.size();
  if (frames > declared_ || (ended_ && frames != declared_)) {
    return Error{fmt::format("says that it has {} frames and has {}", declared_, frames), place_, kRemedy};
  }
  std::string text = fmt::format("{}{} {}\n{}\n", head_, kFrames, lines_.size(), timing_);
  for (const std::string& frame : lines_) {
    text += frame;
    text += '\n';
  }
  Diagnostics odd;
  options_.diagnostics = &odd;
  Result<motion::Clip> clip = read_bvh(text, place_, options_);
  if (!clip) {
    return Error{fmt::format("{} (behind frame {})", clip.error().message, first_), clip.error().place, kRemedy};
  }
  block_ = *std::move(clip);
  return {};
}

Status BvhPlayback::places(double time_s, std::vector<Eigen::Vector3d>& p_W) {
  const double rate = block_.frame_rate_hz;
  while (!ended_ && time_s * rate > static_cast<double>(first_ + lines_.size() - 1)) {
    if (Status status = load(); !status) {
      return status;
    }
  }
  motion::pose_at(block_, time_s - static_cast<double>(first_) / rate, poses_);
  p_W.clear();
  for (const body::SegmentPose& pose : poses_) {
    p_W.push_back(pose.p_WL);
  }
  return {};
}

}  // namespace limbwave::interchange

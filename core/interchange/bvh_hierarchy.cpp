#include "interchange/bvh_hierarchy.h"

#include <fmt/format.h>

#include <algorithm>

#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

class HierarchyReader {
 public:
  HierarchyReader(TextScanner& scanner, Diagnostics& diagnostics) : scanner_(scanner), diagnostics_(diagnostics) {}

  Result<std::vector<BvhJoint>> read() {
    if (!same_word(scanner_.peek_word(), "HIERARCHY")) {
      return unexpected("HIERARCHY, with which a BVH file starts", "check that it is a BVH file");
    }
    scanner_.word();
    if (!same_word(scanner_.peek_word(), "ROOT")) {
      return unexpected("ROOT", "check that it is a BVH file");
    }
    scanner_.word();
    if (Status status = open_joint(); !status) {
      return status.error();
    }
    while (!open_.empty()) {
      if (Status status = statement(); !status) {
        return status.error();
      }
    }
    if (same_word(scanner_.peek_word(), "ROOT")) {
      scanner_.skip_space();
      return scanner_.error("a second ROOT", "write one person per file");
    }
    if (!same_word(scanner_.peek_word(), "MOTION")) {
      return unexpected("MOTION", "check that the file is whole");
    }
    scanner_.word();
    if (without_offset_ > 0) {
      diagnostics_.push_back({Severity::kWarning, "bvh.no-offset",
                              fmt::format("{} joint(s) without OFFSET, first \"{}\", are taken to be at their parent",
                                          without_offset_, first_without_offset_),
                              "", ""});
    }
    return std::move(joints_);
  }

 private:
  Error unexpected(const std::string& wanted, const std::string& remedy) {
    scanner_.skip_space();
    return scanner_.error(fmt::format("{} stands where {} belongs", scanner_.here(), wanted), remedy);
  }

  Status expect(std::string_view word) {
    if (!same_word(scanner_.peek_word(), word)) {
      return unexpected(fmt::format("\"{}\"", word), "check the hierarchy there");
    }
    scanner_.word();
    return {};
  }

  // The name and the opening brace of a joint whose keyword has been taken.
  Status open_joint() {
    BvhJoint joint;
    joint.name = unique_(plain_name(scanner_.rest_of_line('{')));
    joint.parent = open_.empty() ? -1 : static_cast<int>(open_.back().joint);
    open_.push_back({joints_.size(), false});
    joints_.push_back(std::move(joint));
    return expect("{");
  }

  Status statement() {
    const std::string_view word = scanner_.peek_word();
    BvhJoint& joint = joints_[open_.back().joint];
    if (word == "}") {
      if (!open_.back().has_offset) {
        if (without_offset_++ == 0) {
          first_without_offset_ = joint.name;
        }
      }
      scanner_.word();
      open_.pop_back();
      return {};
    }
    if (same_word(word, "OFFSET")) {
      scanner_.word();
      open_.back().has_offset = true;
      return offset(joint.offset);
    }
    if (same_word(word, "CHANNELS")) {
      scanner_.word();
      return channels(joint);
    }
    if (same_word(word, "JOINT")) {
      scanner_.word();
      return open_joint();
    }
    if (same_word(word, "End")) {
      scanner_.word();
      return end_site(joint);
    }
    if (word.empty()) {
      scanner_.skip_space();
      return scanner_.error(fmt::format("the file ends inside joint \"{}\"", joint.name),
                            "check that the file is whole");
    }
    return unexpected("OFFSET, CHANNELS, JOINT, End Site or }", "check the braces of the hierarchy");
  }

  Status offset(Eigen::Vector3d& offset) {
    for (int axis = 0; axis < 3; ++axis) {
      scanner_.skip_space();
      double value = 0.0;
      if (!scanner_.number(value)) {
        return unexpected("a number of OFFSET", "give three numbers with decimal points");
      }
      if (std::abs(value) > kBvhLargestLength) {
        return scanner_.error(fmt::format("an OFFSET of {} is no bone's", value), "correct it there");
      }
      offset[axis] = value;
    }
    return {};
  }

  Status channels(BvhJoint& joint) {
    scanner_.skip_space();
    double count = 0.0;
    if (!scanner_.number(count) || !(count >= 0.0 && count <= 6.0) || count != std::floor(count)) {
      return unexpected("a number of channels from 0 to 6", "count the channels that follow");
    }
    if (joint.channel_count > 0) {
      return scanner_.error(fmt::format("\"{}\" has CHANNELS twice", joint.name), "leave one of them");
    }
    static constexpr std::string_view kNames[] = {"Xposition", "Yposition", "Zposition",
                                                  "Xrotation", "Yrotation", "Zrotation"};
    for (int n = 0; n < static_cast<int>(count); ++n) {
      const std::string_view word = scanner_.peek_word();
      const auto* const found = std::find_if(std::begin(kNames), std::end(kNames),
                                             [&](std::string_view name) { return same_word(name, word); });
      if (found == std::end(kNames)) {
        return unexpected("the name of a channel", "use Xposition to Zposition and Xrotation to Zrotation");
      }
      const auto channel = static_cast<BvhChannel>(found - std::begin(kNames));
      const auto* const listed = joint.channels.begin() + joint.channel_count;
      if (std::find(static_cast<const BvhChannel*>(joint.channels.begin()), listed, channel) != listed) {
        return scanner_.error(fmt::format("\"{}\" has {} twice", joint.name, *found), "list every channel once");
      }
      scanner_.word();
      joint.channels[joint.channel_count++] = channel;
    }
    return {};
  }

  Status end_site(BvhJoint& joint) {
    scanner_.rest_of_line('{');  // "Site", and in some files a name
    if (Status status = expect("{"); !status) {
      return status;
    }
    Eigen::Vector3d end(0, 0, 0);
    while (scanner_.peek_word() != "}") {
      if (Status status = expect("OFFSET"); !status) {
        return status;
      }
      if (Status status = offset(end); !status) {
        return status;
      }
    }
    scanner_.word();
    if (!joint.end) {
      joint.end = end;
    }
    return {};
  }

  struct Open {
    std::size_t joint;
    bool has_offset;
  };

  TextScanner& scanner_;
  Diagnostics& diagnostics_;
  UniqueNames unique_;
  std::vector<BvhJoint> joints_;
  std::vector<Open> open_;
  std::size_t without_offset_ = 0;
  std::string first_without_offset_;
};

}  // namespace

Result<std::vector<BvhJoint>> read_bvh_hierarchy(TextScanner& scanner, Diagnostics& diagnostics) {
  return HierarchyReader(scanner, diagnostics).read();
}

}  // namespace limbwave::interchange

/// A second way through a BVH file, as plain as the format's description and sharing nothing with the reader: words one
/// by one, 4×4 matrices, file units and axes.
#pragma once

#include <Eigen/Geometry>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace limbwave::test {

struct NaiveBvh {
  struct Joint {
    std::string name;
    int parent = -1;
    Eigen::Vector3d offset{0, 0, 0};
    std::vector<std::string> channels;
  };
  std::vector<Joint> joints;
  std::size_t frames = 0;
  double frame_time = 0.0;
  std::vector<std::vector<double>> values;

  static NaiveBvh parse(const std::string& text) {
    NaiveBvh bvh;
    std::istringstream in(text);
    std::string word;
    std::vector<int> open;
    bool in_end = false;
    while (in >> word && word != "MOTION") {
      if (word == "ROOT" || word == "JOINT") {
        Joint joint;
        in >> joint.name;
        joint.parent = open.empty() ? -1 : open.back();
        bvh.joints.push_back(joint);
        in >> word;
        open.push_back(static_cast<int>(bvh.joints.size()) - 1);
      } else if (word == "End") {
        in >> word >> word;
        in_end = true;
      } else if (word == "OFFSET") {
        double x = 0, y = 0, z = 0;
        in >> x >> y >> z;
        if (!in_end) {
          bvh.joints[static_cast<std::size_t>(open.back())].offset = {x, y, z};
        }
      } else if (word == "CHANNELS") {
        int n = 0;
        in >> n;
        for (int i = 0; i < n; ++i) {
          in >> word;
          bvh.joints[static_cast<std::size_t>(open.back())].channels.push_back(word);
        }
      } else if (word == "}") {
        if (in_end) {
          in_end = false;
        } else {
          open.pop_back();
        }
      }
    }
    in >> word >> bvh.frames >> word >> word >> bvh.frame_time;
    std::size_t channels = 0;
    for (const Joint& joint : bvh.joints) {
      channels += joint.channels.size();
    }
    for (std::size_t f = 0; f < bvh.frames; ++f) {
      std::vector<double> row(channels);
      for (double& value : row) {
        in >> value;
      }
      bvh.values.push_back(row);
    }
    return bvh;
  }

  /// World transforms of all joints in file axes.
  [[nodiscard]] std::vector<Eigen::Isometry3d> pose(std::size_t frame) const {
    std::vector<Eigen::Isometry3d> world;
    std::size_t next = 0;
    for (const Joint& joint : joints) {
      Eigen::Vector3d p = joint.offset;
      Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
      for (const std::string& channel : joint.channels) {
        const double value = values[frame][next++];
        const int axis = channel[0] - 'X';
        if (channel.substr(1) == "position") {
          p[axis] = value;
        } else {
          R = R *
              Eigen::AngleAxisd(value * 3.14159265358979323846 / 180.0, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
        }
      }
      Eigen::Isometry3d local = Eigen::Isometry3d::Identity();
      local.linear() = R;
      local.translation() = p;
      world.push_back(joint.parent < 0 ? local : world[static_cast<std::size_t>(joint.parent)] * local);
    }
    return world;
  }
};

}  // namespace limbwave::test

// Other people's sensors from their tables to figures, by the program that users run: eight boards on a walking person,
// and a chain of five segments with joints of every kind.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "body/rig.h"
#include "support/command_line.h"
#include "support/pose_readings.h"
#include "support/temporary_folder.h"
#include "support/walking_person.h"

namespace limbwave {
namespace {

namespace fs = std::filesystem;
using testing_support::BoardErrors;
using testing_support::PosesAt;

class LogCommand : public testing::Test {
 protected:
  // Writes skeleton, rig, readings and truth as somebody else would.
  void write(const body::Skeleton& skeleton, const std::vector<std::string>& boards, const PosesAt& poses,
             double seconds, double rate_hz) {
    body::Rig rig;
    rig.name = "theirs";
    rig.title = "Boards of somebody else";
    rig.skeleton = (folder_.path() / "skeleton.json").string();
    rig.has_line_in = false;
    for (const std::string& name : boards) {
      const auto s = static_cast<std::size_t>(skeleton.find(name));
      body::Gyroscope gyroscope;
      gyroscope.name = gyroscope.segment = name;
      gyroscope.R_LS = geometry::exp_so3({0.4, 0.1, -0.3});
      gyroscope.p_LS = {0.5 * skeleton.segments[s].length, 0.0, 0.04};
      rig.gyroscopes.push_back(gyroscope);
      body::Accelerometer accelerometer;
      accelerometer.name = accelerometer.segment = name;
      accelerometer.R_LS = gyroscope.R_LS;
      accelerometer.p_LS = gyroscope.p_LS;
      rig.accelerometers.push_back(accelerometer);
    }
    std::ofstream(folder_.path() / "skeleton.json") << body::skeleton_to_json(skeleton).dump(1);
    std::ofstream(folder_.path() / "rig.json") << body::rig_to_json(rig).dump(1);
    const estimate::BodyModel model = estimate::body_model(rig, skeleton);
    const estimate::BodyReadings readings =
        testing_support::read_poses(poses, model, seconds, rate_hz, BoardErrors::worn(), 11);
    std::ofstream csv(folder_.path() / "inertial.csv");
    csv << "time_s,sensor,wx_rad_s,wy_rad_s,wz_rad_s,ax_m_s2,ay_m_s2,az_m_s2\n";
    for (const estimate::InertialReading& r : readings.inertial) {
      csv << fmt::format("{:.6f},{},{:.6f},{:.6f},{:.6f},{:.5f},{:.5f},{:.5f}\n", r.time_s,
                         model.boards[static_cast<std::size_t>(r.board)].name, r.w_S.x(), r.w_S.y(), r.w_S.z(),
                         r.f_S.x(), r.f_S.y(), r.f_S.z());
    }
    std::ofstream truth(folder_.path() / "truth.csv");
    truth << "time_s,segment,qw,qx,qy,qz,px_m,py_m,pz_m\n";
    for (int k = 0; k / 50.0 <= seconds; ++k) {
      const auto at = poses(k / 50.0);
      for (std::size_t s = 0; s < at.size(); ++s) {
        const Eigen::Quaterniond& q = at[s].R_WL;
        truth << fmt::format("{:.6f},{},{:.8f},{:.8f},{:.8f},{:.8f},{:.6f},{:.6f},{:.6f}\n", k / 50.0,
                             skeleton.segments[s].name, q.w(), q.x(), q.y(), q.z(), at[s].p_WL.x(), at[s].p_WL.y(),
                             at[s].p_WL.z());
      }
    }
  }

  nlohmann::json run(const std::vector<std::string>& arguments) {
    const testing_support::CommandLine program(folder_.path());
    const auto outcome = program.run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output, nullptr, false);
  }

  test::TemporaryFolder folder_;
};

TEST_F(LogCommand, EightBoardsOnAWalkingPerson) {
  const auto skeleton = body::load_skeleton("body");
  ASSERT_TRUE(skeleton.ok());
  const testing_support::WalkingPerson person(*skeleton);
  write(
      *skeleton, {"pelvis", "chest", "left_thigh", "left_shin", "left_foot", "right_thigh", "right_shin", "right_foot"},
      [&](double t) { return person.poses(t); }, 40.0, 100.0);
  run({"import", "walk.take", "--csv", "inertial.csv", "--rig", "rig.json", "--json"});
  run({"solve", "walk.take", "--method", "filter", "--root", "contacts", "--name", "feet", "--start", "rest",
       "--json"});
  run({"solve", "walk.take", "--method", "filter", "--root", "free", "--name", "free", "--json"});
  const auto feet = run({"evaluate", "walk.take", "--solve", "feet", "--truth", "truth.csv", "--json"});
  const auto free = run({"evaluate", "walk.take", "--solve", "free", "--truth", "truth.csv", "--json"});
  for (const char* joint : {"left_thigh", "left_shin", "right_thigh", "right_shin"}) {
    EXPECT_LT(feet["joints"][joint]["mean_deg"].get<double>(), 4.0) << joint;
  }
  const double held = feet["segments"]["pelvis"]["position_mean_mm"].get<double>();
  const double drifted = free["segments"]["pelvis"]["position_mean_mm"].get<double>();
  std::printf("pelvis off by %.0f mm with contacts, %.0f mm free\n", held, drifted);
  // Steps that are known to stand leave a per cent or two of the way; without them errors grow with the square of time.
  const double way_m = (person.poses(40.0).front().p_WL - person.poses(0.0).front().p_WL).norm();
  EXPECT_GT(way_m, 10.0);
  EXPECT_LT(held, 1e3 * 0.02 * way_m);
  EXPECT_GT(drifted, 10.0 * held);
}

// What is solved in two parts, the second resumed from the first's state, is what is solved at once.
TEST_F(LogCommand, AStateIsSavedAndResumed) {
  const auto skeleton = body::load_skeleton("body");
  const testing_support::WalkingPerson person(*skeleton);
  write(
      *skeleton, {"pelvis", "left_thigh", "left_shin", "right_thigh", "right_shin"},
      [&](double t) { return person.poses(t); }, 5.0, 60.0);
  std::ifstream csv(folder_.path() / "inertial.csv");
  std::ofstream first(folder_.path() / "first.csv");
  std::ofstream second(folder_.path() / "second.csv");
  std::string line;
  std::getline(csv, line);
  first << line << "\n";
  second << line << "\n";
  while (std::getline(csv, line)) {
    (std::stod(line) < 3.7 ? first : second) << line << "\n";
  }
  first.close();
  second.close();
  for (const char* part : {"inertial", "first", "second"}) {
    run({"import", std::string(part) + ".take", "--csv", std::string(part) + ".csv", "--rig", "rig.json", "--json"});
  }
  const std::vector<std::string> how{"--method", "filter", "--root", "contacts", "--json"};
  const auto solve = [&](std::vector<std::string> what) {
    what.insert(what.end(), how.begin(), how.end());
    run(what);
  };
  solve({"solve", "inertial.take", "--save-state", "whole.json"});
  solve({"solve", "first.take", "--save-state", "half.json"});
  solve({"solve", "second.take", "--resume", "half.json", "--save-state", "end.json"});
  const auto content = [&](const char* name) { return read_file(folder_.path() / name).value(); };
  EXPECT_GT(content("whole.json").size(), 1000U);
  EXPECT_EQ(content("whole.json"), content("end.json"));
  const testing_support::CommandLine program(folder_.path());
  const auto smoothed = program.run({"solve", "second.take", "--method", "smoother", "--resume", "half.json"});
  EXPECT_EQ(smoothed.status, 1);
  EXPECT_THAT(smoothed.errors, testing::HasSubstr("cannot resume"));
  const auto broken = program.run({"solve", "second.take", "--method", "filter", "--resume", "rig.json"});
  EXPECT_EQ(broken.status, 1);
  EXPECT_THAT(broken.errors, testing::HasSubstr("rig.json"));
}

TEST_F(LogCommand, AWearerWhoIsNotStillIsRefusedWhereRestIsAskedFor) {
  const auto skeleton = body::load_skeleton("body");
  const testing_support::WalkingPerson person(*skeleton);
  write(
      *skeleton, {"pelvis", "left_thigh", "left_shin"}, [&](double t) { return person.poses(t + 6.0); }, 2.0, 60.0);
  run({"import", "walk.take", "--csv", "inertial.csv", "--rig", "rig.json", "--json"});
  const testing_support::CommandLine program(folder_.path());
  const auto refused = program.run({"solve", "walk.take", "--method", "filter", "--start", "rest"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors, testing::HasSubstr("\"left_thigh\""));
  EXPECT_THAT(refused.errors, testing::HasSubstr("moved in the first second"));
  EXPECT_EQ(std::count(refused.errors.begin(), refused.errors.end(), '\n'), 1);
}

TEST_F(LogCommand, AChainOfBallHingeAndUniversalJoints) {
  body::Skeleton chain;
  chain.name = "chain";
  const char* names[] = {"base", "hinge", "universal", "ball", "end"};
  const body::JointKind kinds[] = {body::JointKind::kSpherical, body::JointKind::kHinge, body::JointKind::kUniversal,
                                   body::JointKind::kSpherical, body::JointKind::kHinge};
  for (std::size_t s = 0; s < 5; ++s) {
    body::Segment segment;
    segment.name = names[s];
    segment.parent = static_cast<int>(s) - 1;
    segment.length = 0.3;
    segment.p_PL = s == 0 ? Eigen::Vector3d(0, 0, 1.5) : Eigen::Vector3d(0.3, 0, 0);
    segment.R_PL_rest =
        s == 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY())) : Eigen::Quaterniond::Identity();
    segment.joint.kind = kinds[s];
    segment.joint.axis = Eigen::Vector3d(0.2, 1.0, 0.1 * static_cast<double>(s)).normalized();
    segment.joint.axis2 = Eigen::Vector3d(0.1, -0.2, 1.0).normalized();
    chain.segments.push_back(segment);
  }
  const auto poses = [&](double t) {
    // Two seconds of rest, then everything moves in its own time.
    const double begun = std::max(0.0, t - 2.0);
    const double grown = std::min(1.0, begun / 2.0);
    const double much = grown * grown * grown * (10.0 + grown * (-15.0 + 6.0 * grown));
    std::vector<Eigen::Quaterniond> R;
    for (std::size_t s = 0; s < 5; ++s) {
      const double k = static_cast<double>(s);
      const auto angle = [&](double size, double rate, double phase) {
        return much * size * std::sin(rate * begun + phase);
      };
      const body::Joint& joint = chain.segments[s].joint;
      switch (joint.kind) {
        case body::JointKind::kHinge:
          R.emplace_back(Eigen::AngleAxisd(angle(0.8, 1.9 + 0.2 * k, k), joint.axis));
          break;
        case body::JointKind::kUniversal:
          R.push_back(Eigen::Quaterniond(Eigen::AngleAxisd(angle(0.6, 2.3, 0.4), joint.axis)) *
                      Eigen::Quaterniond(Eigen::AngleAxisd(angle(0.7, 1.4, 1.0), joint.axis2)));
          break;
        default:
          R.push_back(geometry::exp_so3({angle(0.4, 1.3 + 0.1 * k, 0.0), angle(0.5, 1.7, 0.7), angle(0.3, 2.1, 1.9)}));
      }
    }
    return body::poses_from_joints(chain, R, chain.segments.front().p_PL);
  };
  write(chain, {"base", "hinge", "universal", "ball", "end"}, poses, 12.0, 120.0);
  run({"import", "chain.take", "--csv", "inertial.csv", "--rig", "rig.json", "--json"});
  for (const char* method : {"filter", "smoother"}) {
    run({"solve", "chain.take", "--method", method, "--root", "fixed", "--name", method, "--json"});
    const auto figures = run({"evaluate", "chain.take", "--solve", method, "--truth", "truth.csv", "--json"});
    std::printf("chain by %s: %.2f deg\n", method, figures["all"]["mean_deg"].get<double>());
    for (const char* joint : {"hinge", "universal", "ball", "end"}) {
      EXPECT_LT(figures["joints"][joint]["mean_deg"].get<double>(), 4.0) << method << " " << joint;
    }
    EXPECT_LT(figures["all"]["mean_deg"].get<double>(), 4.0) << method;
  }
}

}  // namespace
}  // namespace limbwave

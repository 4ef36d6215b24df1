#include "interchange/export_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "base/units.h"
#include "interchange/bvh_reader.h"
#include "interchange/export_check.h"
#include "interchange/fbx_reader.h"
#include "interchange/frame_rate.h"
#include "interchange/gltf_file.h"
#include "interchange/random_clip.h"
#include "interchange/read_back.h"
#include "support/temporary_folder.h"

namespace limbwave::interchange {
namespace {

using Eigen::Vector3d;
using motion::Clip;

constexpr const char* kEndings[] = {".fbx", ".glb", ".gltf", ".bvh", ".csv"};

// A leg that kicks once a second while its owner walks, captured at `fps`.
Clip kick(double fps, double seconds) {
  Clip clip;
  clip.name = "kick";
  clip.frame_rate_hz = fps;
  for (int i = 0; i < 3; ++i) {
    body::Segment segment;
    segment.name = "leg " + std::to_string(i);
    segment.parent = i - 1;
    segment.p_PL = i == 0 ? Vector3d(0, 0, 1) : Vector3d(0.45, 0, 0);
    segment.length = 0.45;
    segment.R_PL_rest =
        i == 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(kPi / 2, Vector3d::UnitY())) : Eigen::Quaterniond::Identity();
    clip.skeleton.segments.push_back(segment);
  }
  clip.joints.resize(3);
  for (int f = 0; f < static_cast<int>(fps * seconds) + 1; ++f) {
    const double t = f / fps;
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = std::sin(2 * kPi * t) * (i == 0 ? 0.8 : 0.6);
      clip.joints[i].rotation.times.push_back(t);
      clip.joints[i].rotation.values.push_back(clip.skeleton.segments[i].R_PL_rest *
                                               Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitY())));
    }
    clip.root_position.times.push_back(t);
    clip.root_position.values.push_back({1.2 * t, 0.05 * std::sin(kPi * t), 1.0});
  }
  return clip;
}

Result<ExportReport> exported(const Clip& clip, const std::filesystem::path& path, const ExportOptions& options = {}) {
  const Clip* clips[] = {&clip};
  return export_file(clips, path, options);
}

TEST(ExportFile, EveryFormatIsWrittenCheckedAndReported) {
  const Clip clip = kick(60.0, 2.0);
  const test::TemporaryFolder folder;
  for (const char* ending : kEndings) {
    SCOPED_TRACE(ending);
    const auto report = exported(clip, folder / (std::string("Käfer 1") + ending));
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_EQ(report->frames, 121U);
    EXPECT_EQ(report->bones, 3U);
    EXPECT_EQ(report->fps, 60.0);
    EXPECT_NEAR(report->duration_s, 2.0, 1e-9);
    EXPECT_LT(report->worst_m, 1e-4);
    EXPECT_EQ(report->bytes, std::filesystem::file_size(report->file));
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 5);
}

TEST(ExportFile, EveryRateKeepsTheMovementOfTheCapture) {
  const Clip clip = kick(120.0, 1.0);
  const Clip fine = kick(9600.0, 1.0);
  const test::TemporaryFolder folder;
  for (const double fps : {23.976, 24.0, 25.0, 29.97, 30.0, 48.0, 50.0, 59.94, 60.0, 100.0, 120.0}) {
    ExportOptions options;
    options.fps = fps;
    const auto report = exported(clip, folder / "x.fbx", options);
    ASSERT_TRUE(report.ok()) << report.error().text();
    const double exact = exact_frame_rate(fps);
    EXPECT_NEAR(exact, fps, 2e-3);
    const Clip read = load_fbx(folder / "x.fbx")->front();
    EXPECT_NEAR(read.frame_rate_hz, exact, exact * 1e-6) << fps;
    for (std::size_t f = 0; f < report->frames; ++f) {
      const double t = static_cast<double>(f) / exact;
      const auto a = motion::pose_at(fine, t);
      const auto b = motion::pose_at(read, t);
      EXPECT_LT((a[2].p_WL - b[2].p_WL).norm(), 2e-5) << fps << " at " << t;
    }
  }
  EXPECT_EQ(exact_frame_rate(23.976), 24.0 / 1.001);
  EXPECT_EQ(exact_frame_rate(23.0), 23.0);
}

TEST(ExportFile, APartAndFewerKeys) {
  const Clip clip = kick(120.0, 4.0);
  const test::TemporaryFolder folder;
  ExportOptions options;
  options.begin_s = 1.0;
  options.end_s = 2.0;
  options.key_tolerance_rad = radians(0.5);
  const auto report = exported(clip, folder / "x.glb", options);
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_NEAR(report->duration_s, 1.0, 1e-9);
  EXPECT_LT(report->keys_after * 2, report->keys_before);
  const Clip read = load_gltf(folder / "x.glb")->front();
  for (double t = 0.0; t <= 1.0; t += 0.01) {
    const double off = (motion::pose_at(clip, 1.0 + t)[2].p_WL - motion::pose_at(read, t)[2].p_WL).norm();
    EXPECT_LT(off, 0.9 * radians(1.0) + 1e-3) << t;
  }
  options.begin_s = 9.0;
  options.end_s = 10.0;
  EXPECT_FALSE(exported(clip, folder / "y.glb", options).ok());
}

TEST(ExportFile, WithoutAMeshOfItsOwnASkeletonGetsAMannequin) {
  const Clip clip = kick(30.0, 0.2);
  const test::TemporaryFolder folder;
  ASSERT_TRUE(exported(clip, folder / "x.glb").ok());
  EXPECT_EQ(load_gltf(folder / "x.glb")->front().meshes.size(), 1U);
  ASSERT_TRUE(exported(clip, folder / "x.fbx").ok());
  EXPECT_EQ(load_fbx(folder / "x.fbx")->front().meshes.size(), 1U);
  ExportOptions bare;
  bare.mesh = false;
  ASSERT_TRUE(exported(clip, folder / "x.glb", bare).ok());
  EXPECT_TRUE(load_gltf(folder / "x.glb")->front().meshes.empty());
}

TEST(ExportFile, EveryPresetInEveryFormat) {
  const test::TemporaryFolder folder;
  const char* data = std::getenv("LIMBWAVE_DATA");
  const std::filesystem::path file = std::filesystem::path(data != nullptr ? data : "") / "motions/02_01.bvh";
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << file << " is not there";
  }
  BvhReadOptions read;
  read.metres_per_unit = std::nullopt;
  const Clip whole = *load_bvh(file, read);
  const Clip walk = motion::trimmed(whole, 0.0, 0.5);
  for (const std::string& name : preset_names()) {
    for (const char* ending : kEndings) {
      SCOPED_TRACE(name + ending);
      ExportOptions options;
      options.preset = *load_preset(name);
      const auto report = exported(walk, folder / (name + ending), options);
      ASSERT_TRUE(report.ok()) << report.error().text();
      EXPECT_LT(report->worst_m, 1e-4);
    }
  }
  ExportOptions vrm;
  vrm.preset = *load_preset("vrm");
  EXPECT_TRUE(exported(walk, folder / "x.vrm", vrm).ok());
}

TEST(ExportFile, WhatFailsLeavesTheOldFile) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder / "x.fbx", "old").ok());
  Clip broken = kick(60.0, 0.5);
  broken.joints[1].rotation.values[3].coeffs().setConstant(NAN);
  EXPECT_FALSE(exported(broken, folder / "x.fbx").ok());
  const Clip good = kick(60.0, 0.5);
  const Clip* clips[] = {&good};
  for (const double stop : {0.0, 0.3, 0.7}) {
    const auto stopped = export_file(clips, folder / "x.fbx", {},
                                     Progress([&](double fraction, std::string_view) { return fraction < stop; }));
    ASSERT_FALSE(stopped.ok());
    EXPECT_TRUE(is_cancelled(stopped.error()));
  }
  EXPECT_EQ(*read_file(folder / "x.fbx"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_FALSE(exported(good, folder / "x.txt").ok());
  EXPECT_FALSE(exported(good, folder / "none/x.fbx").ok());
  const Clip* two[] = {&good, &good};
  EXPECT_FALSE(export_file(two, folder / "x.bvh").ok());
  EXPECT_TRUE(export_file(two, folder / "x.fbx").ok());
}

WrittenActor playing(const Clip& clip) {
  WrittenActor actor;
  for (const body::Segment& segment : clip.skeleton.segments) {
    actor.parents.push_back(segment.parent);
  }
  actor.places = [&clip](double time_s, std::vector<Vector3d>& p_W) {
    p_W.clear();
    for (const body::SegmentPose& pose : motion::pose_at(clip, time_s)) {
      p_W.push_back(pose.p_WL);
    }
    return Status();
  };
  return actor;
}

TEST(ReadBack, NamesJointAndFrameOfADifference) {
  const Clip meant = kick(60.0, 1.0);
  Clip read = meant;
  read.joints[2].rotation.values[30] = read.joints[2].rotation.values[10];
  read.joints[1].rotation.values[30] = read.joints[1].rotation.values[10];
  const auto same = compare_paths({joint_paths(meant)}, {playing(read)}, kExportTolerance, "x.fbx");
  ASSERT_FALSE(same.ok());
  EXPECT_NE(same.error().text().find("\"leg 2\""), std::string::npos) << same.error().text();
  EXPECT_NE(same.error().text().find("frame 30"), std::string::npos) << same.error().text();
  EXPECT_FALSE(compare_paths({joint_paths(meant)}, {}, kExportTolerance, "x.fbx").ok());
  read.skeleton.segments.pop_back();
  EXPECT_FALSE(compare_paths({joint_paths(meant)}, {playing(read)}, kExportTolerance, "x.fbx").ok());
}

// Longer than what a playback holds of a file at a time, in each format.
TEST(CheckExport, LongFilesAreCheckedToTheirEnd) {
  const Clip clip = kick(30.0, 700.0);
  const std::size_t late = clip.joints[1].rotation.times.size() - 3;
  const test::TemporaryFolder folder;
  for (const char* ending : kEndings) {
    SCOPED_TRACE(ending);
    const std::filesystem::path path = folder / (std::string("x") + ending);
    ExportOptions options;
    options.mesh = false;
    const auto report = exported(clip, path, options);
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_LT(report->worst_m, 1e-4);
    const Clip* clips[] = {&clip};
    ExportReport unused;
    const FileFormat format = *format_of(path);
    std::vector<Clip> meant = *prepared(clips, format, options, unused);
    EXPECT_TRUE(check_export(meant, format, FileUnit::kCentimetres, path).ok());
    // The file is right, what was meant is not: near the end, at one key, by 4 cm.
    meant[0].joints[1].rotation.values[late] *=
        Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vector3d::Ones().normalized()));
    const auto same = check_export(meant, format, FileUnit::kCentimetres, path);
    ASSERT_FALSE(same.ok());
    EXPECT_NE(same.error().text().find("frame " + std::to_string(late)), std::string::npos) << same.error().text();
    EXPECT_NE(same.error().text().find("\"leg"), std::string::npos) << same.error().text();
  }
}

TEST(CheckExport, DamagedFilesDoNotPass) {
  const Clip clip = kick(60.0, 3.0);
  const test::TemporaryFolder folder;
  for (const char* ending : kEndings) {
    SCOPED_TRACE(ending);
    const std::filesystem::path path = folder / (std::string("x") + ending);
    ExportOptions options;
    options.mesh = false;
    ASSERT_TRUE(exported(clip, path, options).ok());
    const std::string whole = *read_file(path);
    const FileFormat format = *format_of(path);
    const Clip* clips[] = {&clip};
    ExportReport unused;
    const std::vector<Clip> meant = *prepared(clips, format, options, unused);
    // Without its end; without its last lines.
    for (const std::size_t size : {whole.size() / 2, whole.size() * 9 / 10}) {
      ASSERT_TRUE(write_file(path, whole.substr(0, size)).ok());
      EXPECT_FALSE(check_export(meant, format, FileUnit::kCentimetres, path).ok()) << size;
    }
    std::filesystem::remove(path);
    EXPECT_FALSE(check_export(meant, format, FileUnit::kCentimetres, path).ok());
  }
}

}  // namespace
}  // namespace limbwave::interchange

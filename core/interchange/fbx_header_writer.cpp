#include "interchange/fbx_header_writer.h"

#include <cmath>

namespace limbwave::interchange {
namespace {

constexpr FbxId kDocument = 999999;
constexpr std::string_view kCreator = "Limbwave";

void write_extension(FbxRecordWriter& out, FbxSceneWriter& scene) {
  out.begin("FBXHeaderExtension");
  out.leaf("FBXHeaderVersion", 1003);
  out.leaf("FBXVersion", static_cast<std::int32_t>(kFbxVersion));
  out.leaf("EncryptionType", 0);
  // The same as in kFbxCreationTime.
  out.begin("CreationTimeStamp");
  out.leaf("Version", 1000);
  out.leaf("Year", 1970);
  out.leaf("Month", 1);
  out.leaf("Day", 1);
  out.leaf("Hour", 10);
  out.leaf("Minute", 0);
  out.leaf("Second", 0);
  out.leaf("Millisecond", 0);
  out.end();
  out.leaf("Creator", kCreator);
  out.begin("SceneInfo");
  out.add(fbx_object_name("GlobalInfo", "SceneInfo"));
  out.add("UserData");
  out.leaf("Type", "UserData");
  out.leaf("Version", 100);
  out.begin("MetaData");
  out.leaf("Version", 100);
  for (const char* entry : {"Title", "Subject", "Author", "Keywords", "Revision", "Comment"}) {
    out.leaf(entry, "");
  }
  out.end();
  out.begin("Properties70");
  scene.property("Original", "Compound", "", "");
  scene.property("Original|ApplicationVendor", "KString", "", "", "");
  scene.property("Original|ApplicationName", "KString", "", "", kCreator);
  scene.property("LastSaved", "Compound", "", "");
  scene.property("LastSaved|ApplicationVendor", "KString", "", "", "");
  scene.property("LastSaved|ApplicationName", "KString", "", "", kCreator);
  out.end();
  out.end();
  out.end();
}

void write_settings(FbxRecordWriter& out, FbxSceneWriter& scene, const FbxHeader& header) {
  out.begin("GlobalSettings");
  out.leaf("Version", 1000);
  out.begin("Properties70");
  const auto integer = [&](const char* name, std::int32_t value) { scene.property(name, "int", "Integer", "", value); };
  const bool y_up = header.up == FbxUpAxis::kY;
  integer("UpAxis", y_up ? 1 : 2);
  integer("UpAxisSign", 1);
  integer("FrontAxis", y_up ? 2 : 1);
  integer("FrontAxisSign", y_up ? 1 : -1);
  integer("CoordAxis", 0);
  integer("CoordAxisSign", 1);
  integer("OriginalUpAxis", -1);
  integer("OriginalUpAxisSign", 1);
  const double centimetres = header.metres_per_unit * 100.0;
  scene.property("UnitScaleFactor", "double", "Number", "", centimetres);
  scene.property("OriginalUnitScaleFactor", "double", "Number", "", centimetres);
  scene.property("AmbientColor", "ColorRGB", "Color", "", 0.0, 0.0, 0.0);
  scene.property("DefaultCamera", "KString", "", "", "Producer Perspective");
  scene.property("TimeMode", "enum", "", "", fbx_time_mode(header.fps));
  scene.property("TimeProtocol", "enum", "", "", 2);
  scene.property("SnapOnFrameMode", "enum", "", "", 0);
  scene.property("TimeSpanStart", "KTime", "Time", "", std::int64_t{0});
  scene.property("TimeSpanStop", "KTime", "Time", "", header.stop_ticks);
  scene.property("CustomFrameRate", "double", "Number", "", header.fps);
  out.end();
  out.end();
}

}  // namespace

std::int32_t fbx_time_mode(double fps) {
  struct Named {
    double fps;
    std::int32_t mode;
  };
  constexpr Named kNamed[] = {{120, 1}, {100, 2},        {60, 3},          {50, 4},          {48, 5},
                              {30, 6},  {30 / 1.001, 9}, {25, 10},         {24, 11},         {24 / 1.001, 13},
                              {96, 15}, {72, 16},        {60 / 1.001, 17}, {120 / 1.001, 18}};
  for (const Named& named : kNamed) {
    if (std::abs(fps - named.fps) < 1e-9 * fps) {
      return named.mode;
    }
  }
  return 14;
}

void write_fbx_header(FbxRecordWriter& out, FbxSceneWriter& scene, const FbxHeader& header) {
  write_extension(out, scene);
  out.begin("FileId");
  out.add_raw(kFbxFileId);
  out.end();
  out.leaf("CreationTime", kFbxCreationTime);
  out.leaf("Creator", kCreator);
  write_settings(out, scene, header);

  out.begin("Documents");
  out.leaf("Count", 1);
  out.begin("Document");
  out.add(kDocument);
  out.add("Scene");
  out.add("Scene");
  out.begin("Properties70");
  scene.property("SourceObject", "object", "", "");
  scene.property("ActiveAnimStackName", "KString", "", "", header.stack);
  out.end();
  out.leaf("RootNode", kFbxRoot);
  out.end();
  out.end();
  out.begin("References");
  out.end();

  out.begin("Definitions");
  out.leaf("Version", 100);
  std::int32_t all = 1;
  for (const auto& [type, count] : header.counts) {
    all += count;
  }
  out.leaf("Count", all);
  const auto definition = [&](const std::string& type, std::int32_t count) {
    out.begin("ObjectType");
    out.add(type);
    out.leaf("Count", count);
    out.end();
  };
  definition("GlobalSettings", 1);
  for (const auto& [type, count] : header.counts) {
    if (count > 0) {
      definition(type, count);
    }
  }
  out.end();
}

void write_fbx_takes(FbxRecordWriter& out, const FbxHeader& header) {
  out.begin("Takes");
  out.leaf("Current", header.stack);
  if (!header.stack.empty()) {
    out.begin("Take");
    out.add(header.stack);
    out.leaf("FileName", header.stack + ".tak");
    out.leaf("LocalTime", std::int64_t{0}, header.stop_ticks);
    out.leaf("ReferenceTime", std::int64_t{0}, header.stop_ticks);
    out.end();
  }
  out.end();
}

}  // namespace limbwave::interchange

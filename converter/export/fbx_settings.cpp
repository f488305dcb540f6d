#include "converter/export/fbx_settings.h"

#include <algorithm>
#include <string_view>

#include "converter/export/fbx_motion.h"

namespace ribbon {

namespace {

constexpr const char* writer = "ribbon-convert";
// A fixed time, and the identity that belongs to it: readers that look at them want both to fit.
constexpr const char* creation_time = "1970-01-01 10:00:00:000";
constexpr std::string_view file_identity(
    "\x28\xb3\x2a\xeb\xb6\x24\xcc\xc2\xbf\xc8\xb0\x2a\xa9\x2b\xfc\xf1");
constexpr std::int64_t document_identity = 1;
constexpr double centimetres_per_metre = 100;  // FBX's unit is the centimetre

FbxRecord header_extension() {
  return {"FBXHeaderExtension",
          {},
          {{"FBXHeaderVersion", {1003}},
           {"FBXVersion", {7400}},
           {"EncryptionType", {0}},
           {"CreationTimeStamp",
            {},
            {{"Version", {1000}},
             {"Year", {1970}},
             {"Month", {1}},
             {"Day", {1}},
             {"Hour", {10}},
             {"Minute", {0}},
             {"Second", {0}},
             {"Millisecond", {0}}}},
           {"Creator", {writer}}}};
}

FbxRecord integer(std::string_view name, int value) {
  return {"P", {name, "int", "Integer", "", value}};
}

FbxRecord number(std::string_view name, double value) {
  return {"P", {name, "double", "Number", "", value}};
}

// Axes: 0 x, 1 y, 2 z; up, to the viewer, and to the right.
std::vector<FbxRecord> axes_and_unit(const Placement& placement) {
  const bool z_up = placement.up == UpAxis::z;
  const double unit_cm = centimetres_per_metre * placement.metres_per_unit;
  return {integer("UpAxis", z_up ? 2 : 1),
          integer("UpAxisSign", 1),
          integer("FrontAxis", z_up ? 1 : 2),
          integer("FrontAxisSign", z_up ? -1 : 1),
          integer("CoordAxis", 0),
          integer("CoordAxisSign", 1),
          number("UnitScaleFactor", unit_cm),
          number("OriginalUnitScaleFactor", unit_cm)};
}

FbxRecord global_settings(const Model& model, int frames) {
  const std::int64_t last = fbx_ticks(model.frames_per_second, frames - 1);
  constexpr int custom_rate = 14;
  std::vector<FbxRecord> settings = axes_and_unit(model.placement);
  settings.push_back({"P", {"TimeMode", "enum", "", "", custom_rate}});
  settings.push_back({"P", {"TimeSpanStart", "KTime", "Time", "", std::int64_t{0}}});
  settings.push_back({"P", {"TimeSpanStop", "KTime", "Time", "", last}});
  settings.push_back(number("CustomFrameRate", model.frames_per_second));
  return {"GlobalSettings", {}, {{"Version", {1000}}, {"Properties70", {}, settings}}};
}

FbxRecord documents(int frames) {
  return {"Documents",
          {},
          {{"Count", {1}},
           {"Document",
            {document_identity, "Scene", "Scene"},
            {{"Properties70",
              {},
              {{"P", {"SourceObject", "object", "", ""}},
               {"P", {"ActiveAnimStackName", "KString", "", "", frames > 1 ? "motion" : ""}}}},
             {"RootNode", {std::int64_t{0}}}}}}};
}

// How many of each type; types without any are left out.
FbxRecord definitions(const Model& model, int frames) {
  const auto objects = static_cast<int>(model.objects.size());
  const std::vector<Material> shown = materials_of(model);
  const auto materials = static_cast<int>(shown.size());
  const auto pictures = static_cast<int>(std::count_if(
      shown.begin(), shown.end(), [](const Material& material) { return material.picture; }));
  const int shapes = frames - 1;
  const int motions = frames > 1 ? 1 : 0;
  FbxRecord record{"Definitions", {}, {{"Version", {100}}}};
  int total = 0;
  std::vector<FbxRecord> types;
  for (const auto& [type, count] :
       std::initializer_list<std::pair<const char*, int>>{{"GlobalSettings", 1},
                                                          {"Model", objects},
                                                          {"Geometry", objects + shapes},
                                                          {"Material", materials},
                                                          {"Texture", pictures},
                                                          {"Video", pictures},
                                                          {"Deformer", motions + shapes},
                                                          {"AnimationStack", motions},
                                                          {"AnimationLayer", motions},
                                                          {"AnimationCurveNode", shapes},
                                                          {"AnimationCurve", shapes}}) {
    total += count;
    if (count > 0) types.push_back({"ObjectType", {type}, {{"Count", {count}}}});
  }
  record.nested.push_back({"Count", {total}});
  record.nested.insert(record.nested.end(), types.begin(), types.end());
  return record;
}

}  // namespace

std::vector<FbxRecord> fbx_settings(const Model& model, int frames) {
  return {header_extension(),
          {"FileId", {FbxProperty::raw(file_identity)}},
          {"CreationTime", {creation_time}},
          {"Creator", {writer}},
          global_settings(model, frames),
          documents(frames),
          {"References", {}},
          definitions(model, frames)};
}

FbxRecord fbx_takes(const Model& model, int frames) {
  if (frames == 1) return {"Takes", {}, {{"Current", {""}}}};
  const std::int64_t last = fbx_ticks(model.frames_per_second, frames - 1);
  return {"Takes",
          {},
          {{"Current", {"motion"}},
           {"Take",
            {"motion"},
            {{"FileName", {"motion.tak"}},
             {"LocalTime", {std::int64_t{0}, last}},
             {"ReferenceTime", {std::int64_t{0}, last}}}}}};
}

}  // namespace ribbon

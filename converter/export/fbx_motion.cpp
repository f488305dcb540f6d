#include "converter/export/fbx_motion.h"

#include <cmath>
#include <string>

#include "converter/export/fbx_pieces.h"

namespace ribbon {

namespace {

constexpr double ticks_per_second = 46'186'158'000;

std::string frame_name(int frame) {
  return "frame " + std::to_string(frame + 1);
}

FbxRecord curve(const Model& model, int frame, int frames, FbxArrays& arrays) {
  const int keys = frame + 1 < frames ? 3 : 2;
  Eigen::VectorX<std::int64_t> times(keys);
  Eigen::VectorXf weights = Eigen::VectorXf::Zero(keys);
  for (int key = 0; key < keys; ++key)
    times[key] = fbx_ticks(model.frames_per_second, frame - 1 + key);
  weights[1] = 100;
  constexpr int linear = 4;
  return {
      "AnimationCurve",
      {fbx_identity(FbxKind::curve, frame), fbx_name("", "AnimCurve"), ""},
      {{"Default", {0.0}},
       {"KeyVer", {4008}},
       {"KeyTime", {arrays.array(times)}},
       {"KeyValueFloat", {arrays.array(weights)}},
       {"KeyAttrFlags", {arrays.array(Eigen::VectorXi(Eigen::VectorXi::Constant(1, linear)))}},
       {"KeyAttrDataFloat", {arrays.array(Eigen::VectorXf(Eigen::VectorXf::Zero(4)))}},
       {"KeyAttrRefCount", {arrays.array(Eigen::VectorXi(Eigen::VectorXi::Constant(1, keys)))}}}};
}

}  // namespace

std::int64_t fbx_ticks(double frames_per_second, int frame) {
  return std::llround(frame * ticks_per_second / frames_per_second);
}

std::vector<FbxRecord> fbx_motion_records(const Model& model, int frames) {
  const std::int64_t last = fbx_ticks(model.frames_per_second, frames - 1);
  return {{"Deformer",
           {fbx_identity(FbxKind::deformer), fbx_name("motion", "Deformer"), "BlendShape"},
           {{"Version", {100}}}},
          {"AnimationStack",
           {fbx_identity(FbxKind::stack), fbx_name("motion", "AnimStack"), ""},
           {{"Properties70",
             {},
             {{"P", {"LocalStop", "KTime", "Time", "", last}},
              {"P", {"ReferenceStop", "KTime", "Time", "", last}}}}}},
          {"AnimationLayer",
           {fbx_identity(FbxKind::layer), fbx_name("motion", "AnimLayer"), ""},
           {{"Properties70", {}, {{"P", {"Weight", "Number", "", "A", 100.0}}}}}}};
}

std::vector<FbxRecord> fbx_motion_connections() {
  return {fbx_connection(fbx_identity(FbxKind::deformer), fbx_identity(FbxKind::geometry)),
          fbx_connection(fbx_identity(FbxKind::layer), fbx_identity(FbxKind::stack))};
}

FbxShapes::FbxShapes(const ModelObject& first, FbxArrays& arrays)
    : positions_(first.positions.cast<double>()),
      normals_(first.normals.cast<double>()),
      indices_(arrays.array(Eigen::VectorXi(Eigen::VectorXi::LinSpaced(
          positions_.cols(), 0, static_cast<int>(positions_.cols()) - 1)))),
      no_change_(arrays.array(Eigen::Matrix3Xd(Eigen::Matrix3Xd::Zero(3, positions_.cols())))) {}

// All vertices, also those that rest: Blender does not open a shape without any. Readers as assimp
// before 5.3 demand normals; zeros leave those of the mesh as they are.
FbxRecord FbxShapes::shape(int frame, const ModelObject& posed, FbxArrays& arrays) const {
  const Eigen::Matrix3Xd moved = posed.positions.cast<double>() - positions_;
  const Eigen::Matrix3Xd turned = posed.normals.cast<double>() - normals_;
  return {"Geometry",
          {fbx_identity(FbxKind::shape, frame), fbx_name(frame_name(frame), "Geometry"), "Shape"},
          {{"Version", {100}},
           {"Indexes", {indices_}},
           {"Vertices", {arrays.array(moved)}},
           {"Normals", {turned.cols() > 0 ? arrays.array(turned) : no_change_}}}};
}

std::vector<FbxRecord> fbx_channel_records(const Model& model, int frame, int frames,
                                           FbxArrays& arrays) {
  return {
      {"Deformer",
       {fbx_identity(FbxKind::channel, frame), fbx_name(frame_name(frame), "SubDeformer"),
        "BlendShapeChannel"},
       {{"Version", {100}},
        {"DeformPercent", {0.0}},
        {"FullWeights", {arrays.array(Eigen::VectorXd(Eigen::VectorXd::Constant(1, 100)))}}}},
      {"AnimationCurveNode",
       {fbx_identity(FbxKind::curve_node, frame), fbx_name("DeformPercent", "AnimCurveNode"), ""},
       {{"Properties70", {}, {{"P", {"d|DeformPercent", "Number", "", "A", 0.0}}}}}},
      curve(model, frame, frames, arrays)};
}

std::vector<FbxRecord> fbx_channel_connections(int frame) {
  const std::int64_t channel = fbx_identity(FbxKind::channel, frame);
  const std::int64_t curve_node = fbx_identity(FbxKind::curve_node, frame);
  return {fbx_connection(channel, fbx_identity(FbxKind::deformer)),
          fbx_connection(fbx_identity(FbxKind::shape, frame), channel),
          fbx_connection(curve_node, fbx_identity(FbxKind::layer)),
          fbx_connection(curve_node, channel, "DeformPercent"),
          fbx_connection(fbx_identity(FbxKind::curve, frame), curve_node, "d|DeformPercent")};
}

}  // namespace ribbon

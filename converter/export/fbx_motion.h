// Blend shapes and their motion as records of an FBX file.
#pragma once

#include <cstdint>
#include <vector>

#include "converter/export/fbx_arrays.h"
#include "converter/export/fbx_record.h"
#include "model/model.h"

namespace ribbon {

// FBX counts time in these.
std::int64_t fbx_ticks(double frames_per_second, int frame);

// The deformer, the layer and the stack that all shapes of the first object share. frames: 2 and
// more.
std::vector<FbxRecord> fbx_motion_records(const Model& model, int frames);
std::vector<FbxRecord> fbx_motion_connections();

// Shapes of the first object: how far every vertex is displaced in a frame (from 1; frame 0 is the
// mesh itself), and how its normal has changed, if it has one. What is alike in all shapes is
// deflated once.
class FbxShapes {
 public:
  FbxShapes(const ModelObject& first, FbxArrays& arrays);
  // posed: the object in that frame.
  [[nodiscard]] FbxRecord shape(int frame, const ModelObject& posed, FbxArrays& arrays) const;

 private:
  Eigen::Matrix3Xd positions_;  // of the mesh itself
  Eigen::Matrix3Xd normals_;    // likewise
  FbxProperty indices_;
  FbxProperty no_change_;
};

// The channel that gives a frame's shape its weight, and the curve of that: 0, 100 in its frame, 0,
// with straight lines between.
std::vector<FbxRecord> fbx_channel_records(const Model& model, int frame, int frames,
                                           FbxArrays& arrays);
std::vector<FbxRecord> fbx_channel_connections(int frame);

}  // namespace ribbon

// The JSON chunk of a GLB file: what its binary chunk holds, and in which order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/model.h"
#include "model/point_bounds.h"

namespace ribbon {

// Corners of triangles, 3 x count; quads are split from their first corner to their third.
Eigen::Matrix3Xi triangulated(const Eigen::MatrixXi& faces);

// How many bytes are missing to a multiple of four, which chunks and their parts are.
std::size_t glb_padding(std::size_t bytes);

// Of a frame, numbered from 0.
float frame_time_s(const Model& model, Eigen::Index frame);

struct GlbScene {
  std::string json;  // filled up with spaces to a multiple of four bytes, as chunks are
  std::uint64_t binary_bytes = 0;
};

// The binary chunk holds, little-endian and without gaps:
//   for each object: positions (3 x f32 a vertex), normals likewise if it has any, uv if it has any
//                    (2 x f32, v downwards), triangles (3 x u32);
//   for each material: the picture that it shows, if there is one, filled up with zeros to a
//                      multiple of four bytes;
//   if there are several frames: for each but the first, how far every vertex of the first object
//                    has moved since the first (3 x f32 a vertex), and how its normals have
//                    changed if it has any; the times of all frames (f32); the weights that are not
//                    0, of frames x targets: where (u32), and how large (f32).
// targets: the bounds of each further frame's displacements. The length of the text does not depend
// on them.
GlbScene glb_scene(const Model& model, const std::vector<PointBounds>& targets);

}  // namespace ribbon

// What is exported: the ribbon and the obstacle as named objects with faces, uv and a material.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/placement.h"
#include "model/ribbon_faces.h"
#include "recording/records/recording.h"
#include "result/result.h"

namespace ribbon {

class SolidRibbon;
struct Model;
struct PictureFile;

struct Material {
  std::string name;
  Eigen::Vector3f color;  // linear, 0 to 1
  // Takes the place of the colour: (0, 0) of the uv is its lower left corner, (1, 1) the upper
  // right one, and it is repeated beyond. Null: none.
  std::shared_ptr<const PictureFile> picture = nullptr;
};

// Of a solid ribbon: faces from `first_face` on, all others come before them.
struct BackOfSolid {
  Material material;
  Eigen::Index first_face = 0;
};

struct ModelObject {
  std::string name;  // one line, not empty, at most 63 bytes; unique in its model
  Material material;
  Eigen::Matrix3Xf positions;  // 3 x vertices, as the model's placement says
  Eigen::Matrix2Xf uv;         // 2 x vertices, or 2 x 0: the object has none
  Eigen::MatrixXi faces;       // corners x faces, counter-clockwise seen from the front
  // 3 x vertices of length 1, or 3 x 0: none are asked for.
  Eigen::Matrix3Xf normals = Eigen::Matrix3Xf(3, 0);
  bool moves = false;                              // from frame to frame: true of the ribbon
  std::optional<BackOfSolid> back = std::nullopt;  // where it has a material of its own
};

// Faces in a row, and what they show.
struct ModelPart {
  Material material;
  Eigen::Index first_face = 0;
  Eigen::Index faces = 0;
};

// All faces of the object: one part, or two where the back has a material of its own.
std::vector<ModelPart> parts_of(const ModelObject& object);

// Of all parts of all objects.
std::vector<Material> materials_of(const Model& model);

struct Model {
  std::vector<ModelObject> objects;  // the ribbon first
  double frames_per_second = 0;
  RibbonGrid grid = {};  // of the ribbon's particles, which are its vertices row by row
  Placement placement = {};
  // The recording guarantees that nothing comes nearer (RecordingHeader); 0: nothing is guaranteed.
  double stated_gap_m = 0;
  std::shared_ptr<const SolidRibbon> solid = nullptr;  // what makes the ribbon one; null: a surface
};

// What of a recording is exported, and how.
struct ModelSettings {
  RibbonFaces faces = RibbonFaces::triangles;
  bool with_ribbon = true;
  bool with_obstacle = true;
  bool with_normals = false;
  double frames_per_second = 0;  // that the files state; 0: the recording's
  double thickness_m = 0;        // of the ribbon, before it is scaled; 0: a surface
  Placement placement = {};
  // Lies on the ribbon as high as that is wide, and is repeated along it: u then counts its widths
  // from the first drawn end, and v goes from 0 to 1 as it does without. Null: none.
  std::shared_ptr<const PictureFile> picture = nullptr;
  // Of a solid: lies likewise on the back alone. Null: that shows the same.
  std::shared_ptr<const PictureFile> back_picture = nullptr;
};

// The parts of the model that no frame changes. The ribbon's positions are still to be set. Fails
// when the header contradicts itself (uv or face indices that do not fit, an obstacle that is not
// finite), or when nothing is left to export.
Result<Model> model_of_recording(const RecordingHeader& header, const ModelSettings& settings);

// Puts one frame's ribbon, as it is recorded (3 x particles, metres), into `model`, whose first
// object it is: as a surface, or as the front and then the back of a solid. False where it cannot
// be made a solid; the model is then as it was. Fails, naming the frame (`number` from 1), when the
// number of particles differs from the recording's, when a position is not finite, before or after
// it is placed, or when the placement rounds so coarsely that layers could meet which the recording
// keeps apart.
Result<bool> pose_ribbon(Model& model, const Eigen::Matrix3Xf& positions, int number);

}  // namespace ribbon

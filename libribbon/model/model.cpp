#include "model/model.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string_view>
#include <utility>

#include "model/normals.h"
#include "model/picture_file.h"
#include "model/solid_ribbon.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr std::size_t max_name_bytes = 63;  // Blender cuts longer names itself

// A name that every format can hold: control characters would end the line in OBJ and are
// separators in FBX. Cut at the start of a UTF-8 character.
std::string object_name(std::string name, std::string_view otherwise) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '_');
  std::size_t length = std::min(name.size(), max_name_bytes);
  while (length > 0 && length < name.size() && (name[length] & 0xc0) == 0x80) --length;
  name.resize(length);
  name.erase(0, name.find_first_not_of(' '));
  name.erase(name.find_last_not_of(' ') + 1);
  return name.empty() ? std::string(otherwise) : name;
}

Material ribbon_material(std::string name, const std::shared_ptr<const PictureFile>& picture) {
  if (picture)
    return {.name = std::move(name), .color = Eigen::Vector3f::Ones(), .picture = picture};
  return {.name = std::move(name), .color = {0.61F, 0.03F, 0.05F}};
}

// As recorded, or so that a picture as high as the ribbon is wide keeps its shape: files have uv,
// but few readers take a transformation of uv from them.
Eigen::Matrix2Xf ribbon_uv(const RecordingHeader& header, const PictureFile* picture) {
  if (picture == nullptr) return header.uv;
  const double width_m = header.ribbon_width_m * picture->width / picture->height;
  const double repetitions = header.ribbon_length_m / width_m;
  Eigen::Matrix2Xf uv = header.uv;
  uv.row(0) = (repetitions * uv.row(0).cast<double>()).cast<float>();
  return uv;
}

ModelObject ribbon_object(const RecordingHeader& header, const ModelSettings& settings) {
  return {.name = object_name(header.scene_name, "ribbon"),
          .material = ribbon_material("ribbon", settings.picture),
          .positions = Eigen::Matrix3Xf::Zero(3, header.grid.particle_count()),
          .uv = ribbon_uv(header, settings.picture.get()),
          .faces = surface_faces(header.grid, settings.faces),
          .moves = true};
}

// As that, with vertices and faces of a back and a rim, which shows what the front does.
ModelObject solid_ribbon_object(const RecordingHeader& header, const ModelSettings& settings) {
  ModelObject solid = ribbon_object(header, settings);
  const Eigen::Index faces_of_a_side = solid.faces.cols();
  const auto& back = settings.back_picture ? settings.back_picture : settings.picture;
  const Eigen::Matrix2Xf front_uv = solid.uv;
  solid.uv.resize(2, 2 * front_uv.cols());
  solid.uv << front_uv, ribbon_uv(header, back.get());
  solid.positions.setZero(3, solid.uv.cols());
  solid.faces = solid_faces(header.grid, settings.faces);
  if (settings.back_picture)
    solid.back = {.material = ribbon_material("ribbon_back", back),
                  .first_face = solid.faces.cols() - faces_of_a_side};
  return solid;
}

ModelObject obstacle_object(const TriangleMesh& mesh, const std::string& ribbon_name,
                            const Placement& placement) {
  std::string name = object_name(mesh.name, "obstacle");
  if (name == ribbon_name) name = name == "obstacle" ? "still_life" : "obstacle";
  return {.name = std::move(name),
          .material = {"obstacle", {0.45F, 0.45F, 0.42F}},
          .positions = placement.place(mesh.vertices),
          .uv = Eigen::Matrix2Xf(2, 0),
          .faces = mesh.triangles};
}

void set_normals(ModelObject& object, const Placement& placement) {
  const bool y_up = placement.up == UpAxis::y;
  object.normals = vertex_normals(object.positions, object.faces,
                                  y_up ? Eigen::Vector3f::UnitY() : Eigen::Vector3f::UnitZ());
}

bool faces_fit(const ModelObject& object) {
  return object.faces.size() == 0 ||
         (object.faces.minCoeff() >= 0 && object.faces.maxCoeff() < object.positions.cols());
}

tl::unexpected<Error> contradiction(const std::string& problem) {
  return failure("", "the recording's header contradicts itself: " + problem, "record it again");
}

std::shared_ptr<const SolidRibbon> solid_of(const RecordingHeader& header,
                                            const ModelSettings& settings) {
  if (settings.thickness_m == 0) return nullptr;
  const Placement& placement = settings.placement;
  const TriangleMesh obstacle = header.obstacle.value_or(TriangleMesh{});
  return std::make_shared<SolidRibbon>(header.grid, placement.factor() * settings.thickness_m,
                                       placement.place(obstacle.vertices), obstacle.triangles);
}

Result<void> check_ribbon(const RecordingHeader& header) {
  if (header.grid.along < 2 || header.grid.across < 2)
    return contradiction("the ribbon has fewer than 2 x 2 particles");
  if (header.uv.cols() != header.grid.particle_count())
    return contradiction(filled_in("it has uv for {} of {} particles", header.uv.cols(),
                                   header.grid.particle_count()));
  if (!header.uv.allFinite()) return contradiction("a uv is not a finite number");
  return {};
}

// Two things may each move by the rounding, towards each other.
Result<void> check_rounding(const Model& model, const Eigen::Matrix3Xf& recorded) {
  const double rounding_m = model.placement.rounding_m(recorded);
  if (model.stated_gap_m == 0 || 2 * rounding_m < model.stated_gap_m) return {};
  return failure("",
                 "its unit or scale rounds coordinates by up to " +
                     metres(rounding_m, Rounding::up) + ", so that layers could meet that are " +
                     metres(model.stated_gap_m) + " apart",
                 "leave --unit and --scale out");
}

Result<void> check_obstacle(const ModelObject& obstacle) {
  if (!obstacle.positions.allFinite())
    return contradiction("a vertex of the obstacle is not finite");
  if (!faces_fit(obstacle))
    return contradiction("a triangle of the obstacle names a vertex that does not exist");
  return {};
}

}  // namespace

std::vector<ModelPart> parts_of(const ModelObject& object) {
  const Eigen::Index faces = object.faces.cols();
  if (!object.back) return {{.material = object.material, .faces = faces}};
  const auto& [material, first_face] = *object.back;
  return {{.material = object.material, .faces = first_face},
          {.material = material, .first_face = first_face, .faces = faces - first_face}};
}

std::vector<Material> materials_of(const Model& model) {
  std::vector<Material> materials;
  for (const ModelObject& object : model.objects)
    for (const ModelPart& part : parts_of(object)) materials.push_back(part.material);
  return materials;
}

Result<Model> model_of_recording(const RecordingHeader& header, const ModelSettings& settings) {
  if (auto checked = check_ribbon(header); !checked) return tl::unexpected(checked.error());
  const bool own_rate = settings.frames_per_second > 0;
  Model model{.objects = {settings.thickness_m > 0 ? solid_ribbon_object(header, settings)
                                                   : ribbon_object(header, settings)},
              .frames_per_second = own_rate ? settings.frames_per_second : header.frames_per_second,
              .grid = header.grid,
              .placement = settings.placement,
              .stated_gap_m = header.stated_gap_m};
  const bool has_obstacle = header.obstacle && header.obstacle->triangles.cols() > 0;
  if ((settings.with_obstacle || settings.thickness_m > 0) && has_obstacle) {
    ModelObject obstacle =
        obstacle_object(*header.obstacle, model.objects.front().name, settings.placement);
    if (auto checked = check_obstacle(obstacle); !checked) return tl::unexpected(checked.error());
    if (auto checked = check_rounding(model, header.obstacle->vertices); !checked)
      return tl::unexpected(checked.error());
    if (settings.with_obstacle) model.objects.push_back(std::move(obstacle));
  }
  model.solid = solid_of(header, settings);
  if (!settings.with_ribbon) model.objects.erase(model.objects.begin());
  if (model.objects.empty())
    return failure("", "the recording has no obstacle", "export the ribbon");
  if (settings.with_normals)
    for (ModelObject& object : model.objects) set_normals(object, settings.placement);
  return model;
}

namespace {

Result<void> check_positions(const Eigen::Matrix3Xf& placed, Eigen::Index particles) {
  if (placed.cols() != particles)
    return failure(
        "", filled_in("holds {} particles where the ribbon has {}", placed.cols(), particles),
        "leave it out with --frames");
  for (Eigen::Index particle = 0; particle < placed.cols(); ++particle)
    if (!placed.col(particle).allFinite())
      return failure("", filled_in("particle {} is not at a finite position", particle),
                     "leave it out with --frames");
  return {};
}

}  // namespace

Result<bool> pose_ribbon(Model& model, const Eigen::Matrix3Xf& positions, int number) {
  assert(!model.objects.empty() && model.objects.front().moves);
  ModelObject& ribbon = model.objects.front();
  const Eigen::Matrix3Xf placed = model.placement.place(positions);
  return check_positions(placed, ribbon.positions.cols() / (model.solid ? 2 : 1))
      .and_then([&] { return check_rounding(model, positions); })
      .map([&] {
        const auto vertices = model.solid ? model.solid->raise(placed) : std::optional(placed);
        if (!vertices) return false;
        ribbon.positions = *vertices;
        if (ribbon.normals.cols() > 0) set_normals(ribbon, model.placement);
        return true;
      })
      .map_error([&](Error error) {
        error.place = filled_in("frame {}", number);
        return error;
      });
}

}  // namespace ribbon

#include "model/glb_scene.h"

#include <Eigen/Geometry>
#include <array>
#include <string_view>
#include <utility>

#include "model/json_pieces.h"
#include "model/picture_file.h"

namespace ribbon {

namespace {

// glTF's names for types of numbers.
constexpr const char* float_type = "5126";
constexpr const char* u32_type = "5125";

// What a part of the binary chunk is for: glTF's name for it, and bytes from vertex to vertex.
struct Use {
  const char* target;
  const char* stride;
};
constexpr Use for_points{"34962", "12"};
constexpr Use for_uv{"34962", "8"};
constexpr Use for_triangles{"34963", ""};
constexpr Use for_other{"", ""};

std::string json_indices(int count) {
  JsonList list;
  for (int index = 0; index < count; ++index) list.add(std::to_string(index));
  return std::move(list).text();
}

// About x, as x, y, z, w: from z up to y up.
constexpr std::array quarter_turn{-0.70710678F, 0.0F, 0.0F, 0.70710678F};

// What the faces of one material are: glTF's name for them is a primitive.
struct Primitive {
  std::string triangles;  // an accessor
  Material material;
  std::string texture = {};  // empty: none
};

// Accessors of one object's vertices; those of what it has not are empty.
struct Geometry {
  std::string positions;
  std::string normals;
  std::string uv;
  std::vector<Primitive> primitives;
};

// Accessors of the motion; both empty where nothing moves.
struct Motion {
  std::string targets;       // of the mesh
  std::string target_names;  // likewise
  std::string animations;    // of the file
};

class SceneText {
 public:
  // glTF is in metres and y up; nodes bring there what is placed otherwise.
  explicit SceneText(const Placement& placement) {
    const auto unit = static_cast<float>(placement.metres_per_unit);
    if (placement.up == UpAxis::z) rotation_ = json_numbers(quarter_turn);
    if (unit != 1) scale_ = json_numbers(std::array{unit, unit, unit});
  }

  Geometry add_geometry(const ModelObject& object) {
    const Eigen::Index vertices = object.positions.cols();
    Geometry geometry;
    geometry.positions =
        add_points(add_view(3 * vertices, for_points), 0, vertices, bounds_of(object.positions));
    if (object.normals.cols() > 0)
      geometry.normals =
          add_numbers(add_view(3 * vertices, for_points), vertices, float_type, "\"VEC3\"");
    if (object.uv.cols() > 0)
      geometry.uv = add_numbers(add_view(2 * vertices, for_uv), vertices, float_type, "\"VEC2\"");
    const Eigen::Index corners_of_a_face = 3 * (object.faces.rows() - 2);
    for (const ModelPart& part : parts_of(object)) {
      const Eigen::Index corners = corners_of_a_face * part.faces;
      geometry.primitives.push_back({.triangles = add_numbers(add_view(corners, for_triangles),
                                                              corners, u32_type, "\"SCALAR\""),
                                     .material = part.material});
    }
    return geometry;
  }

  Motion add_motion(const ModelObject& object, const std::vector<PointBounds>& targets,
                    float last_s) {
    const Eigen::Index vertices = object.positions.cols();
    const bool has_normals = object.normals.cols() > 0;
    const std::size_t sets = has_normals ? 2 : 1;  // of vectors, in each target
    const std::string view =
        add_view(3 * vertices * static_cast<Eigen::Index>(sets * targets.size()), for_points);
    JsonList displacements;
    JsonList names;
    for (std::size_t target = 0; target < targets.size(); ++target) {
      const std::string points = add_points(view, sets * target, vertices, targets[target]);
      const std::string normals =
          has_normals ? add_vectors(view, sets * target + 1, vertices, {}) : "";
      displacements.add(json_object({{"POSITION", points}, {"NORMAL", normals}}));
      names.add("\"frame " + std::to_string(target + 2) + '"');
    }
    const std::string sampler = add_sampler(static_cast<Eigen::Index>(targets.size()), last_s);
    constexpr const char* channel = R"([{"sampler":0,"target":{"node":0,"path":"weights"}}])";
    return {
        .targets = std::move(displacements).text(),
        .target_names = json_object({{"targetNames", std::move(names).text()}}),
        .animations =
            '[' + json_object({{"channels", channel}, {"samplers", '[' + sampler + ']'}}) + ']'};
  }

  // The texture that shows it; empty where the material has none. It is repeated along u and not
  // along v, at whose ends the ribbon ends.
  std::string add_picture(const Material& material) {
    if (!material.picture) return {};
    const PictureFile& picture = *material.picture;
    const std::string view = add_bytes(picture.bytes.size(), for_other);
    binary_bytes_ += glb_padding(picture.bytes.size());
    const std::string image =
        std::to_string(images_.add(json_object({{"name", json_quoted(material.name)},
                                                {"bufferView", view},
                                                {"mimeType", json_quoted(picture.media_type)}})));
    const std::string sampler = std::to_string(samplers_.add(R"({"wrapS":10497,"wrapT":33071})"));
    return std::to_string(textures_.add(json_object({{"sampler", sampler}, {"source", image}})));
  }

  // With a node and materials of its own.
  void add_mesh(const ModelObject& object, const Geometry& geometry, const Motion& motion) {
    const std::string attributes = json_object({{"POSITION", geometry.positions},
                                                {"NORMAL", geometry.normals},
                                                {"TEXCOORD_0", geometry.uv}});
    JsonList primitives;
    for (const Primitive& primitive : geometry.primitives) {
      const std::string material =
          std::to_string(materials_.add(material_text(primitive.material, primitive.texture)));
      primitives.add(json_object({{"attributes", attributes},
                                  {"indices", primitive.triangles},
                                  {"material", material},
                                  {"targets", motion.targets}}));
    }
    const std::string name = json_quoted(object.name);
    const std::string mesh =
        std::to_string(meshes_.add(json_object({{"name", name},
                                                {"primitives", std::move(primitives).text()},
                                                {"extras", motion.target_names}})));
    nodes_.add(
        json_object({{"name", name}, {"mesh", mesh}, {"rotation", rotation_}, {"scale", scale_}}));
  }

  [[nodiscard]] GlbScene scene(const Motion& motion) && {
    const std::string roots = json_object({{"nodes", json_indices(nodes_.size())}});
    const std::string buffer = json_object({{"byteLength", std::to_string(binary_bytes_)}});
    std::string json = json_object({{"asset", R"({"version":"2.0","generator":"ribbon"})"},
                                    {"scene", "0"},
                                    {"scenes", '[' + roots + ']'},
                                    {"nodes", std::move(nodes_).text()},
                                    {"meshes", std::move(meshes_).text()},
                                    {"materials", std::move(materials_).text()},
                                    {"textures", std::move(textures_).text_or_nothing()},
                                    {"images", std::move(images_).text_or_nothing()},
                                    {"samplers", std::move(samplers_).text_or_nothing()},
                                    {"animations", motion.animations},
                                    {"accessors", std::move(accessors_).text()},
                                    {"bufferViews", std::move(views_).text()},
                                    {"buffers", '[' + buffer + ']'}});
    json.append(glb_padding(json.size()), ' ');
    return {.json = std::move(json), .binary_bytes = binary_bytes_};
  }

 private:
  // The part of the binary chunk that follows those that were added before.
  std::string add_view(Eigen::Index numbers, const Use& use) {
    return add_bytes(4 * static_cast<std::uint64_t>(numbers), use);
  }

  std::string add_bytes(std::uint64_t bytes, const Use& use) {
    const std::string offset = std::to_string(std::exchange(binary_bytes_, binary_bytes_ + bytes));
    return std::to_string(views_.add(json_object({{"buffer", "0"},
                                                  {"byteOffset", offset},
                                                  {"byteLength", std::to_string(bytes)},
                                                  {"byteStride", use.stride},
                                                  {"target", use.target}})));
  }

  std::string add_numbers(std::string_view view, Eigen::Index count, std::string_view number_type,
                          std::string_view shape) {
    return std::to_string(accessors_.add(json_object({{"bufferView", view},
                                                      {"componentType", number_type},
                                                      {"count", std::to_string(count)},
                                                      {"type", shape}})));
  }

  std::string add_points(std::string_view view, std::size_t set, Eigen::Index count,
                         const PointBounds& bounds) {
    return add_vectors(view, set, count,
                       {json_numbers(bounds.least), json_numbers(bounds.largest)});
  }

  // A view may hold several sets of vectors, as many in each. bounds: the least and the largest, or
  // empty, which points must not be.
  std::string add_vectors(std::string_view view, std::size_t set, Eigen::Index count,
                          const std::array<std::string, 2>& bounds) {
    const std::uint64_t offset = 12 * static_cast<std::uint64_t>(count) * set;
    return std::to_string(accessors_.add(json_object({{"bufferView", view},
                                                      {"byteOffset", std::to_string(offset)},
                                                      {"componentType", float_type},
                                                      {"count", std::to_string(count)},
                                                      {"type", "\"VEC3\""},
                                                      {"min", bounds[0]},
                                                      {"max", bounds[1]}})));
  }

  // At each frame's time the weight of its own target is 1 and all others are 0: written out they
  // would be frames x targets numbers, so only those that are not 0 are.
  std::string add_sampler(Eigen::Index targets, float last_s) {
    const Eigen::Index frames = targets + 1;
    const std::string times =
        std::to_string(accessors_.add(json_object({{"bufferView", add_view(frames, for_other)},
                                                   {"componentType", float_type},
                                                   {"count", std::to_string(frames)},
                                                   {"type", "\"SCALAR\""},
                                                   {"min", json_numbers(std::array{0.0F})},
                                                   {"max", json_numbers(std::array{last_s})}})));
    const std::string places =
        json_object({{"bufferView", add_view(targets, for_other)}, {"componentType", u32_type}});
    const std::string ones = json_object({{"bufferView", add_view(targets, for_other)}});
    const std::string sparse =
        json_object({{"count", std::to_string(targets)}, {"indices", places}, {"values", ones}});
    const std::string weights =
        std::to_string(accessors_.add(json_object({{"componentType", float_type},
                                                   {"count", std::to_string(frames * targets)},
                                                   {"type", "\"SCALAR\""},
                                                   {"sparse", sparse}})));
    return json_object({{"input", times}, {"output", weights}, {"interpolation", "\"LINEAR\""}});
  }

  static std::string material_text(const Material& material, const std::string& texture) {
    const Eigen::Vector4f color = material.color.homogeneous();
    const std::string shown = texture.empty() ? "" : json_object({{"index", texture}});
    const std::string surface = json_object({{"baseColorFactor", json_numbers(color)},
                                             {"baseColorTexture", shown},
                                             {"metallicFactor", "0"},
                                             {"roughnessFactor", "0.8"}});
    return json_object({{"name", json_quoted(material.name)},
                        {"pbrMetallicRoughness", surface},
                        {"doubleSided", "true"}});
  }

  std::string rotation_;  // of every node
  std::string scale_;     // likewise
  JsonList nodes_;
  JsonList meshes_;
  JsonList materials_;
  JsonList textures_;
  JsonList images_;
  JsonList samplers_;
  JsonList accessors_;
  JsonList views_;
  std::uint64_t binary_bytes_ = 0;
};

}  // namespace

std::size_t glb_padding(std::size_t bytes) {
  return (4 - bytes % 4) % 4;
}

Eigen::Matrix3Xi triangulated(const Eigen::MatrixXi& faces) {
  if (faces.rows() == 3) return faces;
  Eigen::Matrix3Xi triangles(3, 2 * faces.cols());
  for (Eigen::Index face = 0; face < faces.cols(); ++face) {
    triangles.col(2 * face) << faces(0, face), faces(1, face), faces(2, face);
    triangles.col(2 * face + 1) << faces(0, face), faces(2, face), faces(3, face);
  }
  return triangles;
}

float frame_time_s(const Model& model, Eigen::Index frame) {
  return static_cast<float>(static_cast<double>(frame) / model.frames_per_second);
}

GlbScene glb_scene(const Model& model, const std::vector<PointBounds>& targets) {
  SceneText text(model.placement);
  std::vector<Geometry> geometries;
  for (const ModelObject& object : model.objects) geometries.push_back(text.add_geometry(object));
  for (Geometry& geometry : geometries)
    for (Primitive& primitive : geometry.primitives)
      primitive.texture = text.add_picture(primitive.material);
  Motion motion;
  if (!targets.empty())
    motion = text.add_motion(model.objects.front(), targets,
                             frame_time_s(model, static_cast<Eigen::Index>(targets.size())));
  for (std::size_t object = 0; object < geometries.size(); ++object)
    text.add_mesh(model.objects[object], geometries[object], object == 0 ? motion : Motion{});
  return std::move(text).scene(motion);
}

}  // namespace ribbon

#include "converter/export/fbx_objects.h"

#include <cmath>
#include <string>
#include <string_view>

#include "converter/export/picture_file.h"

namespace ribbon {

namespace {

constexpr double ticks_per_second = 46'186'158'000;
constexpr int most_parts = 2;  // of an object, with a material each

// What has an identity of its own.
enum class Kind : std::int64_t {
  geometry = 1,
  node,
  material,
  deformer,
  shape,
  channel,
  curve,
  curve_node,
  layer,
  stack,
  texture,
  video
};

std::int64_t identity(Kind kind, int index = 0) {
  return (static_cast<std::int64_t>(kind) << 32) + index;
}

// A name as FBX writes it, with its class behind it.
std::string named(std::string_view name, std::string_view name_class) {
  return std::string(name).append("\0\1", 2).append(name_class);
}

std::string frame_name(int frame) {
  return "frame " + std::to_string(frame + 1);
}

FbxRecord connection(std::int64_t from, std::int64_t to) {
  return {"C", {"OO", from, to}};
}

FbxRecord connection(std::int64_t from, std::int64_t to, std::string_view property) {
  return {"C", {"OP", from, to, property}};
}

// In FBX the last corner of a face is told by its complement.
Eigen::MatrixXi closed_faces(Eigen::MatrixXi faces) {
  const Eigen::Index last = faces.rows() - 1;
  faces.row(last) = -1 - faces.row(last).array();
  return faces;
}

FbxRecord uv_layer(const ModelObject& object, FbxArrays& arrays) {
  const Eigen::Matrix2Xd uv = object.uv.cast<double>();
  return {"LayerElementUV",
          {0},
          {{"Version", {101}},
           {"Name", {"UVMap"}},
           {"MappingInformationType", {"ByPolygonVertex"}},
           {"ReferenceInformationType", {"IndexToDirect"}},
           {"UV", {arrays.array(uv)}},
           {"UVIndex", {arrays.array(object.faces)}}}};
}

FbxRecord normal_layer(const ModelObject& object, FbxArrays& arrays) {
  const Eigen::Matrix3Xd normals = object.normals.cast<double>();
  return {"LayerElementNormal",
          {0},
          {{"Version", {101}},
           {"Name", {""}},
           {"MappingInformationType", {"ByVertice"}},
           {"ReferenceInformationType", {"Direct"}},
           {"Normals", {arrays.array(normals)}}}};
}

// Which of the object's materials each face shows, or all of them.
FbxRecord material_layer(const ModelObject& object, FbxArrays& arrays) {
  Eigen::VectorXi shown = Eigen::VectorXi::Zero(object.back ? object.faces.cols() : 1);
  if (object.back) shown.tail(shown.size() - object.back->first_face).setOnes();
  return {"LayerElementMaterial",
          {0},
          {{"Version", {101}},
           {"Name", {""}},
           {"MappingInformationType", {object.back ? "ByPolygon" : "AllSame"}},
           {"ReferenceInformationType", {"IndexToDirect"}},
           {"Materials", {arrays.array(shown)}}}};
}

FbxRecord layer_element(std::string_view type) {
  return {"LayerElement", {}, {{"Type", {type}}, {"TypedIndex", {0}}}};
}

FbxRecord geometry(const ModelObject& object, std::int64_t id, FbxArrays& arrays) {
  const Eigen::Matrix3Xd positions = object.positions.cast<double>();
  FbxRecord layers{"Layer", {0}, {{"Version", {100}}, layer_element("LayerElementMaterial")}};
  FbxRecord record{"Geometry",
                   {id, named(object.name, "Geometry"), "Mesh"},
                   {{"GeometryVersion", {124}},
                    {"Vertices", {arrays.array(positions)}},
                    {"PolygonVertexIndex", {arrays.array(closed_faces(object.faces))}},
                    material_layer(object, arrays)}};
  if (object.normals.cols() > 0) {
    record.nested.push_back(normal_layer(object, arrays));
    layers.nested.push_back(layer_element("LayerElementNormal"));
  }
  if (object.uv.cols() > 0) {
    record.nested.push_back(uv_layer(object, arrays));
    layers.nested.push_back(layer_element("LayerElementUV"));
  }
  record.nested.push_back(std::move(layers));
  return record;
}

FbxRecord node(const ModelObject& object, std::int64_t id) {
  return {"Model",
          {id, named(object.name, "Model"), "Mesh"},
          {{"Version", {232}},
           {"Properties70", {}, {{"P", {"DefaultAttributeIndex", "int", "Integer", "", 0}}}},
           {"Shading", {true}},
           {"Culling", {"CullingOff"}}}};
}

FbxRecord material(const Material& material, std::int64_t id) {
  const Eigen::Vector3d color = material.color.cast<double>();
  return {"Material",
          {id, named(material.name, "Material"), ""},
          {{"Version", {102}},
           {"ShadingModel", {"lambert"}},
           {"MultiLayer", {0}},
           {"Properties70",
            {},
            {{"P", {"DiffuseColor", "Color", "", "A", color.x(), color.y(), color.z()}},
             {"P", {"DiffuseFactor", "Number", "", "A", 1.0}}}}}};
}

// FBX divides a picture that lies on something into the file and the way in which it lies there.
FbxRecord video(const Material& material, std::int64_t id) {
  const std::string& file = material.picture->name;
  return {"Video",
          {id, named(material.name, "Video"), "Clip"},
          {{"Type", {"Clip"}},
           {"Properties70", {}, {{"P", {"Path", "KString", "XRefUrl", "", file}}}},
           {"UseMipMap", {0}},
           {"Filename", {file}},
           {"RelativeFilename", {file}}}};
}

FbxRecord texture(const Material& material, std::int64_t id) {
  const std::string& file = material.picture->name;
  return {
      "Texture",
      {id, named(material.name, "Texture"), ""},
      {{"Type", {"TextureVideoClip"}},
       {"Version", {202}},
       {"TextureName", {named(material.name, "Texture")}},
       {"Properties70",
        {},
        {{"P", {"UVSet", "KString", "", "", "UVMap"}}, {"P", {"UseMaterial", "bool", "", "", 1}}}},
       {"Media", {named(material.name, "Video")}},
       {"FileName", {file}},
       {"RelativeFilename", {file}},
       {"ModelUVTranslation", {0.0, 0.0}},
       {"ModelUVScaling", {1.0, 1.0}},
       {"Texture_Alpha_Source", {"None"}},
       {"Cropping", {0, 0, 0, 0}}}};
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
      {identity(Kind::curve, frame), named("", "AnimCurve"), ""},
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

std::vector<FbxRecord> fbx_mesh_records(const Model& model, int object, FbxArrays& arrays) {
  const ModelObject& mesh = model.objects[static_cast<std::size_t>(object)];
  std::vector<FbxRecord> records{geometry(mesh, identity(Kind::geometry, object), arrays),
                                 node(mesh, identity(Kind::node, object))};
  int index = most_parts * object;
  for (const ModelPart& part : parts_of(mesh)) {
    records.push_back(material(part.material, identity(Kind::material, index)));
    if (part.material.picture) {
      records.push_back(texture(part.material, identity(Kind::texture, index)));
      records.push_back(video(part.material, identity(Kind::video, index)));
    }
    ++index;
  }
  return records;
}

std::vector<FbxRecord> fbx_mesh_connections(const Model& model, int object) {
  const std::int64_t own_node = identity(Kind::node, object);
  std::vector<FbxRecord> connections{connection(own_node, 0),
                                     connection(identity(Kind::geometry, object), own_node)};
  int index = most_parts * object;
  for (const ModelPart& part : parts_of(model.objects[static_cast<std::size_t>(object)])) {
    const std::int64_t own_material = identity(Kind::material, index);
    connections.push_back(connection(own_material, own_node));
    if (part.material.picture) {
      const std::int64_t own_texture = identity(Kind::texture, index);
      connections.push_back(connection(own_texture, own_material, "DiffuseColor"));
      connections.push_back(connection(identity(Kind::video, index), own_texture));
    }
    ++index;
  }
  return connections;
}

std::vector<FbxRecord> fbx_motion_records(const Model& model, int frames) {
  const std::int64_t last = fbx_ticks(model.frames_per_second, frames - 1);
  return {{"Deformer",
           {identity(Kind::deformer), named("motion", "Deformer"), "BlendShape"},
           {{"Version", {100}}}},
          {"AnimationStack",
           {identity(Kind::stack), named("motion", "AnimStack"), ""},
           {{"Properties70",
             {},
             {{"P", {"LocalStop", "KTime", "Time", "", last}},
              {"P", {"ReferenceStop", "KTime", "Time", "", last}}}}}},
          {"AnimationLayer",
           {identity(Kind::layer), named("motion", "AnimLayer"), ""},
           {{"Properties70", {}, {{"P", {"Weight", "Number", "", "A", 100.0}}}}}}};
}

std::vector<FbxRecord> fbx_motion_connections() {
  return {connection(identity(Kind::deformer), identity(Kind::geometry)),
          connection(identity(Kind::layer), identity(Kind::stack))};
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
          {identity(Kind::shape, frame), named(frame_name(frame), "Geometry"), "Shape"},
          {{"Version", {100}},
           {"Indexes", {indices_}},
           {"Vertices", {arrays.array(moved)}},
           {"Normals", {turned.cols() > 0 ? arrays.array(turned) : no_change_}}}};
}

std::vector<FbxRecord> fbx_channel_records(const Model& model, int frame, int frames,
                                           FbxArrays& arrays) {
  return {{"Deformer",
           {identity(Kind::channel, frame), named(frame_name(frame), "SubDeformer"),
            "BlendShapeChannel"},
           {{"Version", {100}},
            {"DeformPercent", {0.0}},
            {"FullWeights", {arrays.array(Eigen::VectorXd(Eigen::VectorXd::Constant(1, 100)))}}}},
          {"AnimationCurveNode",
           {identity(Kind::curve_node, frame), named("DeformPercent", "AnimCurveNode"), ""},
           {{"Properties70", {}, {{"P", {"d|DeformPercent", "Number", "", "A", 0.0}}}}}},
          curve(model, frame, frames, arrays)};
}

std::vector<FbxRecord> fbx_channel_connections(int frame) {
  const std::int64_t channel = identity(Kind::channel, frame);
  const std::int64_t curve_node = identity(Kind::curve_node, frame);
  return {connection(channel, identity(Kind::deformer)),
          connection(identity(Kind::shape, frame), channel),
          connection(curve_node, identity(Kind::layer)),
          connection(curve_node, channel, "DeformPercent"),
          connection(identity(Kind::curve, frame), curve_node, "d|DeformPercent")};
}

}  // namespace ribbon

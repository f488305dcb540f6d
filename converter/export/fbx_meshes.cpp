#include "converter/export/fbx_meshes.h"

#include <string>
#include <string_view>

#include "converter/export/fbx_pieces.h"
#include "model/picture_file.h"

namespace ribbon {

namespace {

constexpr int most_parts = 2;  // of an object, with a material each

// In FBX the last corner of a face is told by its complement.
Eigen::MatrixXi closed_faces(Eigen::MatrixXi faces) {
  const Eigen::Index last = faces.rows() - 1;
  faces.row(last) = -1 - faces.row(last).array();
  return faces;
}

// Values that belong to corners, vertices or faces of a mesh, with indices or as indices of others
// (IndexToDirect), or one for each (Direct).
FbxRecord layer(std::string_view type, std::string_view name, std::string_view belongs_to,
                std::string_view reference, const std::vector<FbxRecord>& values) {
  FbxRecord record{std::string(type),
                   {0},
                   {{"Version", {101}},
                    {"Name", {name}},
                    {"MappingInformationType", {belongs_to}},
                    {"ReferenceInformationType", {reference}}}};
  record.nested.insert(record.nested.end(), values.begin(), values.end());
  return record;
}

FbxRecord uv_layer(const ModelObject& object, FbxArrays& arrays) {
  const Eigen::Matrix2Xd uv = object.uv.cast<double>();
  return layer("LayerElementUV", "UVMap", "ByPolygonVertex", "IndexToDirect",
               {{"UV", {arrays.array(uv)}}, {"UVIndex", {arrays.array(object.faces)}}});
}

FbxRecord normal_layer(const ModelObject& object, FbxArrays& arrays) {
  const Eigen::Matrix3Xd normals = object.normals.cast<double>();
  return layer("LayerElementNormal", "", "ByVertice", "Direct",
               {{"Normals", {arrays.array(normals)}}});
}

// Indices of the object's materials: of each face, or one for all.
FbxRecord material_layer(const ModelObject& object, FbxArrays& arrays) {
  Eigen::VectorXi shown = Eigen::VectorXi::Zero(object.back ? object.faces.cols() : 1);
  if (object.back) shown.tail(shown.size() - object.back->first_face).setOnes();
  return layer("LayerElementMaterial", "", object.back ? "ByPolygon" : "AllSame", "IndexToDirect",
               {{"Materials", {arrays.array(shown)}}});
}

FbxRecord layer_element(std::string_view type) {
  return {"LayerElement", {}, {{"Type", {type}}, {"TypedIndex", {0}}}};
}

FbxRecord geometry(const ModelObject& object, std::int64_t id, FbxArrays& arrays) {
  const Eigen::Matrix3Xd positions = object.positions.cast<double>();
  FbxRecord layers{"Layer", {0}, {{"Version", {100}}, layer_element("LayerElementMaterial")}};
  FbxRecord record{"Geometry",
                   {id, fbx_name(object.name, "Geometry"), "Mesh"},
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
          {id, fbx_name(object.name, "Model"), "Mesh"},
          {{"Version", {232}},
           {"Properties70", {}, {{"P", {"DefaultAttributeIndex", "int", "Integer", "", 0}}}},
           {"Shading", {true}},
           {"Culling", {"CullingOff"}}}};
}

FbxRecord material(const Material& material, std::int64_t id) {
  const Eigen::Vector3d color = material.color.cast<double>();
  return {"Material",
          {id, fbx_name(material.name, "Material"), ""},
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
          {id, fbx_name(material.name, "Video"), "Clip"},
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
      {id, fbx_name(material.name, "Texture"), ""},
      {{"Type", {"TextureVideoClip"}},
       {"Version", {202}},
       {"TextureName", {fbx_name(material.name, "Texture")}},
       {"Properties70",
        {},
        {{"P", {"UVSet", "KString", "", "", "UVMap"}}, {"P", {"UseMaterial", "bool", "", "", 1}}}},
       {"Media", {fbx_name(material.name, "Video")}},
       {"FileName", {file}},
       {"RelativeFilename", {file}},
       {"ModelUVTranslation", {0.0, 0.0}},
       {"ModelUVScaling", {1.0, 1.0}},
       {"Texture_Alpha_Source", {"None"}},
       {"Cropping", {0, 0, 0, 0}}}};
}

}  // namespace

std::vector<FbxRecord> fbx_mesh_records(const Model& model, int object, FbxArrays& arrays) {
  const ModelObject& mesh = model.objects[static_cast<std::size_t>(object)];
  std::vector<FbxRecord> records{geometry(mesh, fbx_identity(FbxKind::geometry, object), arrays),
                                 node(mesh, fbx_identity(FbxKind::node, object))};
  int index = most_parts * object;
  for (const ModelPart& part : parts_of(mesh)) {
    records.push_back(material(part.material, fbx_identity(FbxKind::material, index)));
    if (part.material.picture) {
      records.push_back(texture(part.material, fbx_identity(FbxKind::texture, index)));
      records.push_back(video(part.material, fbx_identity(FbxKind::video, index)));
    }
    ++index;
  }
  return records;
}

std::vector<FbxRecord> fbx_mesh_connections(const Model& model, int object) {
  const std::int64_t own_node = fbx_identity(FbxKind::node, object);
  std::vector<FbxRecord> connections{
      fbx_connection(own_node, 0),
      fbx_connection(fbx_identity(FbxKind::geometry, object), own_node)};
  int index = most_parts * object;
  for (const ModelPart& part : parts_of(model.objects[static_cast<std::size_t>(object)])) {
    const std::int64_t own_material = fbx_identity(FbxKind::material, index);
    connections.push_back(fbx_connection(own_material, own_node));
    if (part.material.picture) {
      const std::int64_t own_texture = fbx_identity(FbxKind::texture, index);
      connections.push_back(fbx_connection(own_texture, own_material, "DiffuseColor"));
      connections.push_back(fbx_connection(fbx_identity(FbxKind::video, index), own_texture));
    }
    ++index;
  }
  return connections;
}

}  // namespace ribbon

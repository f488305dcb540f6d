#include "converter/export/alembic_writer.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "converter/export/alembic_tree.h"
#include "converter/export/unique_names.h"
#include "model/number_digits.h"
#include "model/point_bounds.h"
#include "model/raw_bytes.h"
#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

constexpr std::int32_t file_version = 0;
constexpr std::int32_t library_version = 10805;  // whose layout this is: 1.8.5

// Rows of the table of time samplings.
constexpr std::uint32_t once = 0;
constexpr std::uint32_t every_frame = 1;

constexpr const char* xform_object =
    "schema=AbcGeom_Xform_v3;schemaObjTitle=AbcGeom_Xform_v3:.xform";
constexpr const char* xform_schema = "schema=AbcGeom_Xform_v3";
constexpr const char* mesh_object =
    "schema=AbcGeom_PolyMesh_v1;schemaBaseType=AbcGeom_GeomBase_v1;"
    "schemaObjTitle=AbcGeom_PolyMesh_v1:.geom";
constexpr const char* mesh_schema = "schema=AbcGeom_PolyMesh_v1;schemaBaseType=AbcGeom_GeomBase_v1";

constexpr PropertyType bounds_type{.name = ".selfBnds",
                                   .metadata = "interpretation=box",
                                   .is_array = false,
                                   .number = PlainType::float64,
                                   .extent = 6};
constexpr PropertyType positions_type{
    .name = "P", .metadata = "geoScope=vtx;interpretation=point", .extent = 3};
constexpr PropertyType indices_type{
    .name = ".faceIndices", .metadata = "", .number = PlainType::int32};
constexpr PropertyType counts_type{
    .name = ".faceCounts", .metadata = "", .number = PlainType::int32};
constexpr PropertyType uv_type{
    .name = "uv",
    .metadata =
        "arrayExtent=1;geoScope=vtx;interpretation=vector;isGeomParam=true;podExtent=2;"
        "podName=float32_t",
    .extent = 2};

constexpr PropertyType normals_type{
    .name = "N",
    .metadata =
        "arrayExtent=1;geoScope=vtx;interpretation=normal;isGeomParam=true;podExtent=3;"
        "podName=float32_t",
    .extent = 3};

// A mesh whose positions and normals are told frame by frame, or once for all.
class AlembicMesh {
 public:
  explicit AlembicMesh(std::uint32_t time_sampling)
      : time_sampling_(time_sampling),
        bounds_(bounds_type, time_sampling),
        positions_(positions_type, time_sampling),
        normals_(normals_type, time_sampling) {}

  void append(OgawaFile& file, const ModelObject& object) {
    const PointBounds reach = bounds_of(object.positions);
    Eigen::Matrix<double, 3, 2> bounds;
    bounds << reach.least.cast<double>(), reach.largest.cast<double>();
    bounds_.append(file, raw_bytes(bounds));
    positions_.append(file, raw_bytes(object.positions));
    if (object.normals.cols() > 0) normals_.append(file, raw_bytes(object.normals));
    ++samples_;
  }

  // The mesh below its transformation. Of `object` what no frame changes.
  AlembicNode finish(OgawaFile& file, MetadataTable& metadata, const ModelObject& object,
                     const std::string& name) {
    std::vector<AlembicNode> properties{bounds_.finish(file, metadata),
                                        positions_.finish(file, metadata)};
    const Eigen::MatrixXi clockwise = object.faces.colwise().reverse();
    const Eigen::VectorXi counts =
        Eigen::VectorXi::Constant(clockwise.cols(), static_cast<int>(clockwise.rows()));
    properties.push_back(constant(file, metadata, indices_type, raw_bytes(clockwise)));
    properties.push_back(constant(file, metadata, counts_type, raw_bytes(counts)));
    if (object.uv.cols() > 0)
      properties.push_back(constant(file, metadata, uv_type, raw_bytes(object.uv)));
    if (object.normals.cols() > 0) properties.push_back(normals_.finish(file, metadata));
    const AlembicNode schema = add_compound(file, metadata, ".geom", mesh_schema, properties);
    const AlembicNode mesh = add_object(file, metadata, name + "Shape", mesh_object, {schema}, {});
    const AlembicNode identity = add_compound(file, metadata, ".xform", xform_schema, {});
    return add_object(file, metadata, name, xform_object, {identity}, {mesh});
  }

 private:
  AlembicNode constant(OgawaFile& file, MetadataTable& metadata, const PropertyType& type,
                       std::string_view values) const {
    SampledProperty property(type, time_sampling_);
    property.append(file, values);
    property.hold_until(samples_);
    return property.finish(file, metadata);
  }

  std::uint32_t time_sampling_;
  std::uint32_t samples_ = 0;
  SampledProperty bounds_;
  SampledProperty positions_;
  SampledProperty normals_;
};

// Without the "/" that stands between the names of a path.
std::vector<std::string> object_names(const Model& model) {
  std::vector<std::string> names;
  for (const ModelObject& object : model.objects) {
    std::string& name = names.emplace_back(object.name);
    std::replace(name.begin(), name.end(), '/', '_');
  }
  return unique_names(names);
}

void put_time_sampling(std::string& bytes, std::uint32_t samples, double seconds_per_sample) {
  put<std::uint32_t>(bytes, samples);
  put<double>(bytes, seconds_per_sample);
  put<std::uint32_t>(bytes, 1);
  put<double>(bytes, 0);
}

// The format has no place for unit and axes; people can read them here.
std::string archive_metadata(const Model& model) {
  std::string text = "_ai_AlembicVersion=Alembic 1.8.5;_ai_Application=ribbon-convert;_ai_DCC_FPS=";
  append_digits(text, model.frames_per_second);
  text += ";_ai_Description=a unit is ";
  append_digits(text, model.placement.metres_per_unit);
  return text + (model.placement.up == UpAxis::z ? " m, z is up" : " m, y is up");
}

class AlembicWriter : public MotionWriter {
 public:
  AlembicWriter(OgawaFile file, const Model& model, int frames)
      : file_(std::move(file)), model_(model), frames_(frames) {
    for (const ModelObject& object : model.objects)
      meshes_.emplace_back(object.moves ? every_frame : once);
  }

  Result<void> append(const Model& model) override {
    assert(appended_ < frames_);
    for (std::size_t i = 0; i < meshes_.size(); ++i)
      if (appended_ == 0 || model.objects[i].moves) meshes_[i].append(file_, model.objects[i]);
    ++appended_;
    if (file_.error()) return tl::unexpected(*file_.error());
    return {};
  }

  Result<void> finish(Older older) override {
    assert(appended_ == frames_);
    MetadataTable metadata;
    const auto names = object_names(model_);
    std::vector<AlembicNode> objects;
    for (std::size_t i = 0; i < meshes_.size(); ++i)
      objects.push_back(meshes_[i].finish(file_, metadata, model_.objects[i], names[i]));
    const AlembicNode top = add_object(file_, metadata, "ABC", "", {}, objects);
    return file_.finish(add_archive(top, metadata), older);
  }

 private:
  OgawaFile::Child add_archive(const AlembicNode& top, const MetadataTable& metadata) {
    std::string version;
    put<std::int32_t>(version, file_version);
    std::string library;
    put<std::int32_t>(library, library_version);
    std::string times;
    put_time_sampling(times, meshes_.size() > 1 ? 1 : 0, 1);
    put_time_sampling(times, static_cast<std::uint32_t>(frames_), 1 / model_.frames_per_second);
    return file_.add_group({file_.add_data({version}), file_.add_data({library}), top.group,
                            file_.add_data({archive_metadata(model_)}), file_.add_data({times}),
                            file_.add_data({metadata.bytes()})});
  }

  OgawaFile file_;
  Model model_;  // in the pose of the first frame
  int frames_;
  int appended_ = 0;
  std::vector<AlembicMesh> meshes_;
};

}  // namespace

Result<std::unique_ptr<MotionWriter>> new_alembic_writer(const std::filesystem::path& path,
                                                         const Model& model, int frames) {
  auto file = OgawaFile::create(path);
  if (!file) return tl::unexpected(file.error());
  return std::make_unique<AlembicWriter>(std::move(*file), model, frames);
}

}  // namespace ribbon

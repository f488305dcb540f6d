#include "converter/export/usd_writer.h"

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "converter/export/unique_names.h"
#include "converter/export/usd_text.h"
#include "files/pending_file.h"
#include "files/scratch_file.h"
#include "model/number_digits.h"
#include "model/picture_file.h"
#include "model/point_bounds.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr const char* materials_scope = "Materials";

// The names of the model's objects as prims beside the scope of materials.
std::vector<std::string> prim_names(const Model& model) {
  std::vector<std::string> names{materials_scope};
  for (const ModelObject& object : model.objects) names.push_back(usd_identifier(object.name));
  names = unique_names(names);
  names.erase(names.begin());
  return names;
}

// Of all materials of the model, in its order.
std::vector<std::string> material_names(const Model& model) {
  std::vector<std::string> names;
  for (const Material& material : materials_of(model))
    names.push_back(usd_identifier(material.name));
  return unique_names(names);
}

std::string path_of_material(const std::string& name) {
  return std::string("/World/") + materials_scope + "/" + name;
}

std::string layer_text(const Model& model, int frames) {
  std::string rate;
  append_digits(rate, model.frames_per_second);
  std::string unit;
  append_digits(unit, model.placement.metres_per_unit);
  return filled_in(R"(#usda 1.0
(
    defaultPrim = "World"
    doc = "ribbon-convert"
    endTimeCode = {}
    framesPerSecond = {}
    metersPerUnit = {}
    startTimeCode = 0
    timeCodesPerSecond = {}
    upAxis = "{}"
)

def Xform "World"
)",
                   frames - 1, rate, unit, rate, model.placement.up == UpAxis::z ? "Z" : "Y") +
         "{\n";
}

Eigen::Matrix<float, 3, 2> extent_of(const Eigen::Matrix3Xf& positions) {
  const PointBounds bounds = bounds_of(positions);
  Eigen::Matrix<float, 3, 2> extent;
  extent << bounds.least, bounds.largest;
  return extent;
}

constexpr const char* a_value_a_vertex = " (\n            interpolation = \"vertex\"\n        )\n";

// Everything about a mesh before its points, which come last.
std::string mesh_text(const ModelObject& object, const std::string& name,
                      const std::string& material) {
  std::string text =
      "    def Mesh \"" + name + "\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n";
  if (name != object.name) text += "        displayName = " + usd_string(object.name) + "\n";
  text += "    )\n    {\n        uniform bool doubleSided = 1\n";
  const Eigen::VectorXi counts =
      Eigen::VectorXi::Constant(object.faces.cols(), static_cast<int>(object.faces.rows()));
  text += "        int[] faceVertexCounts = " + usd_array(counts) + "\n";
  text += "        int[] faceVertexIndices = " + usd_array(object.faces.reshaped()) + "\n";
  text += "        rel material:binding = <" + path_of_material(material) + ">\n";
  if (object.uv.cols() > 0)
    text +=
        "        texCoord2f[] primvars:st = " + usd_array_of_tuples(object.uv) + a_value_a_vertex;
  return text + "        uniform token subdivisionScheme = \"none\"\n";
}

// The faces that show a material of their own; `name` is that one's.
std::string back_text(const ModelObject& object, const std::string& name) {
  const auto faces = static_cast<int>(object.faces.cols() - object.back->first_face);
  const auto first = static_cast<int>(object.back->first_face);
  return R"(
        def GeomSubset "back" (
            prepend apiSchemas = ["MaterialBindingAPI"]
        )
        {
            uniform token elementType = "face"
            uniform token familyName = "materialBind"
            int[] indices = )" +
         usd_array(Eigen::VectorXi::LinSpaced(faces, first, first + faces - 1)) +
         "\n            rel material:binding = <" + path_of_material(name) + ">\n        }\n";
}

std::string static_points_text(const ModelObject& object) {
  std::string text =
      "        float3[] extent = " + usd_array_of_tuples(extent_of(object.positions)) +
      "\n        point3f[] points = " + usd_array_of_tuples(object.positions) + "\n";
  if (object.normals.cols() > 0)
    text +=
        "        normal3f[] normals = " + usd_array_of_tuples(object.normals) + a_value_a_vertex;
  return text + "    }\n\n";
}

// Shaders that look up the picture at the mesh's uv.
std::string picture_text(const Material& material, const std::string& path) {
  if (!material.picture) return "";
  return R"(
            def Shader "uv"
            {
                uniform token info:id = "UsdPrimvarReader_float2"
                string inputs:varname = "st"
                float2 outputs:result
            }

            def Shader "picture"
            {
                uniform token info:id = "UsdUVTexture"
                asset inputs:file = )" +
         usd_asset(material.picture->name) + R"(
                token inputs:sourceColorSpace = "sRGB"
                float2 inputs:st.connect = <)" +
         path + R"(/uv.outputs:result>
                token inputs:wrapS = "repeat"
                token inputs:wrapT = "clamp"
                float3 outputs:rgb
            }
)";
}

std::string color_text(const Material& material, const std::string& path) {
  if (material.picture) return ".connect = <" + path + "/picture.outputs:rgb>";
  const std::string tuple = usd_array_of_tuples(material.color);
  return " = " + tuple.substr(1, tuple.size() - 2);
}

std::string material_text(const Material& material, const std::string& name) {
  const std::string path = path_of_material(name);
  return "        def Material \"" + name + R"("
        {
            token outputs:surface.connect = <)" +
         path + R"(/surface.outputs:surface>

            def Shader "surface"
            {
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor)" +
         color_text(material, path) + R"(
                token outputs:surface
            }
)" + picture_text(material, path) +
         "        }\n";
}

// In the text all frames of the points come before the first one of the normals, which wait for
// that in a file of their own.
class UsdWriter : public MotionWriter {
 public:
  UsdWriter(PendingFile file, std::optional<ScratchFile> normals, Model model, int frames)
      : file_(std::move(file)),
        normals_(std::move(normals)),
        model_(std::move(model)),
        frames_(frames) {}

  // The layer, and the moving mesh as far as its points.
  Result<void> begin() {
    return file_.append(layer_text(model_, frames_) +
                        mesh_text(model_.objects.front(), prim_names(model_).front(),
                                  material_names(model_).front()) +
                        "        point3f[] points.timeSamples = {\n");
  }

  Result<void> append(const Model& model) override {
    assert(static_cast<int>(extents_.size()) < frames_);
    const ModelObject& ribbon = model.objects.front();
    extents_.push_back(extent_of(ribbon.positions));
    const std::size_t frame = extents_.size() - 1;
    return append_sample(file_, frame, ribbon.positions).and_then([&] {
      return normals_ ? append_sample(*normals_, frame, ribbon.normals) : Result<void>{};
    });
  }

  Result<void> finish(Older older) override {
    assert(static_cast<int>(extents_.size()) == frames_);
    return file_.append("        }\n        float3[] extent.timeSamples = {\n")
        .and_then([&] { return append_extents(); })
        .and_then([&] { return file_.append("        }\n"); })
        .and_then([&] { return normals_ ? append_normals() : Result<void>{}; })
        .and_then([&] { return file_.append(end_of_ribbon() + rest_text()); })
        .and_then([&] { return file_.finish(older); });
  }

 private:
  Result<void> append_extents() {
    for (std::size_t frame = 0; frame < extents_.size(); ++frame)
      if (auto appended = append_sample(file_, frame, extents_[frame]); !appended) return appended;
    return {};
  }

  Result<void> append_normals() {
    return file_
        .append(std::string("        normal3f[] normals") + a_value_a_vertex +
                "        normal3f[] normals.timeSamples = {\n")
        .and_then([&] { return normals_->append_to(file_); })
        .and_then([&] { return file_.append("        }\n"); });
  }

  template <class File>
  Result<void> append_sample(File& file, std::size_t frame,
                             const Eigen::Ref<const Eigen::MatrixXf>& tuples) {
    text_ = "            " + std::to_string(frame) + ": ";
    append_usd_array_of_tuples(text_, tuples);
    return file.append(text_ += ",\n");
  }

  [[nodiscard]] std::string end_of_ribbon() const {
    const ModelObject& ribbon = model_.objects.front();
    return (ribbon.back ? back_text(ribbon, material_names(model_)[1]) : "") + "    }\n\n";
  }

  // The meshes that do not move, each with one material, and the materials of all.
  [[nodiscard]] std::string rest_text() const {
    const auto names = prim_names(model_);
    const auto materials = materials_of(model_);
    const auto of_materials = material_names(model_);
    const std::size_t more = materials.size() - model_.objects.size();  // the ribbon's second one
    std::string text;
    for (std::size_t i = 1; i < model_.objects.size(); ++i)
      text += mesh_text(model_.objects[i], names[i], of_materials[i + more]) +
              static_points_text(model_.objects[i]);
    text += std::string("    def Scope \"") + materials_scope + "\"\n    {\n";
    for (std::size_t i = 0; i < materials.size(); ++i)
      text += material_text(materials[i], of_materials[i]);
    return text + "    }\n}\n";
  }

  PendingFile file_;
  std::optional<ScratchFile> normals_;
  Model model_;  // in the pose of the first frame
  int frames_;
  std::vector<Eigen::Matrix<float, 3, 2>> extents_;  // of the frames so far
  std::string text_;                                 // of the last sample; keeps its memory
};

}  // namespace

Result<std::unique_ptr<MotionWriter>> new_usd_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames) {
  auto file = PendingFile::create(path);
  if (!file) return tl::unexpected(file.error());
  std::optional<ScratchFile> normals;
  if (model.objects.front().normals.cols() > 0) {
    auto created = ScratchFile::create(path);
    if (!created) return tl::unexpected(created.error());
    normals.emplace(std::move(*created));
  }
  auto writer = std::make_unique<UsdWriter>(std::move(*file), std::move(normals), model, frames);
  if (auto begun = writer->begin(); !begun) return tl::unexpected(begun.error());
  return writer;
}

}  // namespace ribbon

#include "converter/read_back/alembic_file.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "converter/read_back/ogawa_tree.h"

namespace ribbon {

namespace {

constexpr std::uint32_t float32 = 10;
constexpr std::uint32_t int32 = 6;
// One stored sample may stand for any number of them.
constexpr std::uint32_t most_frames = 10'000'000;

// A mesh's properties, by their names.
class MeshProperties {
 public:
  MeshProperties(const OgawaTree& tree, std::uint64_t schema)
      : tree_(tree), properties_(tree.properties(schema)) {}

  [[nodiscard]] bool has(std::string_view name) const {
    return std::any_of(properties_.begin(), properties_.end(),
                       [&](const OgawaProperty& property) { return property.name == name; });
  }

  [[nodiscard]] const OgawaProperty& at(std::string_view name) const {
    for (const OgawaProperty& property : properties_)
      if (property.name == name) return property;
    throw Spoiled("it lacks the property " + std::string(name));
  }

  // Values x extent of one sample.
  [[nodiscard]] Eigen::MatrixXd values(std::string_view name, std::uint32_t number,
                                       Eigen::Index extent, int sample) const {
    const OgawaProperty& property = at(name);
    demand(property.number == number && property.extent == extent, "numbers of another type");
    const OgawaData data = tree_.sample(property, sample);
    const std::uint64_t count = data.size / 4 / static_cast<std::uint64_t>(extent);
    demand(data.size == count * 4 * static_cast<std::uint64_t>(extent), "half a value");
    const WrittenBytes& bytes = tree_.bytes();
    if (number == int32)
      return bytes.numbers<std::int32_t>(data.begin, extent, count).cast<double>();
    return bytes.numbers<float>(data.begin, extent, count).cast<double>();
  }

 private:
  const OgawaTree& tree_;
  std::vector<OgawaProperty> properties_;
};

// All faces have as many corners; in Alembic these run clockwise.
Eigen::MatrixXi faces_of(const MeshProperties& mesh) {
  const Eigen::VectorXi counts = mesh.values(".faceCounts", int32, 1, 0).cast<int>().reshaped();
  const Eigen::VectorXi corners = mesh.values(".faceIndices", int32, 1, 0).cast<int>().reshaped();
  if (counts.size() == 0) return {};
  const int corners_of_a_face = counts[0];
  demand(corners_of_a_face > 0 && (counts.array() == corners_of_a_face).all() &&
             corners.size() == counts.size() * corners_of_a_face,
         "faces with different numbers of corners");
  return corners.reshaped(corners_of_a_face, counts.size()).colwise().reverse();
}

class AlembicFile : public WrittenMotion {
 public:
  explicit AlembicFile(const std::filesystem::path& path) : tree_(path) {
    for (const std::uint64_t object : tree_.children(tree_.top())) add_mesh(object);
    demand(!meshes_.empty(), "it has no object");
    const OgawaProperty& positions = meshes_.front().at("P");
    demand(positions.samples > 0 && positions.samples <= most_frames, "a wrong number of frames");
    scene_.frames = static_cast<int>(positions.samples);
    const OgawaTimes times = tree_.times(positions.times);
    for (int frame = 0; frame < scene_.frames; ++frame)
      scene_.times_s.push_back(times.start_s + frame * times.step_s);
  }

  Eigen::Matrix3Xd ribbon(int frame) override {
    return meshes_.front().values("P", float32, 3, frame);
  }

 private:
  // A transformation that holds a mesh that holds its schema.
  void add_mesh(std::uint64_t object) {
    const auto shapes = tree_.children(object);
    demand(shapes.size() == 1, "not one mesh below an object");
    const auto schemas = tree_.properties(tree_.properties_of(shapes.front()));
    demand(schemas.size() == 1 && schemas.front().name == ".geom", "an object that is no mesh");
    const MeshProperties& mesh = meshes_.emplace_back(tree_, schemas.front().group);
    WrittenMesh& written = scene_.meshes.emplace_back();
    written.faces = faces_of(mesh);
    if (mesh.has("uv")) written.uv = mesh.values("uv", float32, 2, 0);
    if (meshes_.size() > 1) written.positions = mesh.values("P", float32, 3, 0);
  }

  OgawaTree tree_;
  std::vector<MeshProperties> meshes_;
};

}  // namespace

std::unique_ptr<WrittenMotion> read_alembic(const std::filesystem::path& path) {
  return std::make_unique<AlembicFile>(path);
}

}  // namespace ribbon

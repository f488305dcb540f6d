#include "converter/read_back/usd_file.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "converter/read_back/number_columns.h"
#include "converter/read_back/usd_tokens.h"

namespace ribbon {

namespace {

// A mesh's own numbers, as they stand in the text.
struct MeshText {
  std::vector<double> points;
  std::vector<double> counts;
  std::vector<double> corners;
  std::vector<double> uv;
  std::map<double, std::uint64_t> samples;  // time code: where its points stand
};

// Deeper than any of our prims; the reader calls itself so often at most.
constexpr int deepest_prim = 8;

class UsdFile : public WrittenMotion {
 public:
  explicit UsdFile(const std::filesystem::path& path) : tokens_(path) {
    demand(tokens_.word() == "#usda" && tokens_.number() == 1, "not USD's text form 1.0");
    read_layer_metadata();
    while (tokens_.peek() != 0) read_prim(0);
    demand(!meshes_.empty(), "it has no mesh");
    for (const MeshText& mesh : meshes_) scene_.meshes.push_back(finished(mesh));
    MeshText& ribbon = meshes_.front();
    scene_.frames = ribbon.samples.empty() ? 1 : static_cast<int>(ribbon.samples.size());
    for (const auto& [time, place] : ribbon.samples) {
      scene_.times_s.push_back(time / rate_);
      samples_.push_back(place);
    }
    meshes_.clear();
  }

  Eigen::Matrix3Xd ribbon(int frame) override {
    if (samples_.empty()) return scene_.meshes.front().positions;
    tokens_.go_to(samples_[static_cast<std::size_t>(frame)]);
    std::vector<double> numbers;
    tokens_.value(numbers);
    return single(columns(numbers, 3));
  }

 private:
  void read_layer_metadata() {
    tokens_.take('(');
    while (!tokens_.take_if(')')) {
      const std::string name = tokens_.word();
      tokens_.take('=');
      if (tokens_.peek() == '"') {
        const std::string text = tokens_.string();
        if (name == "upAxis") scene_.z_is_up = text == "Z";
        continue;
      }
      const double number = tokens_.number();
      if (name == "metersPerUnit") scene_.metres_per_unit = number;
      if (name == "timeCodesPerSecond") rate_ = number;
    }
    demand(rate_ > 0, "it does not say how many frames a second it has");
  }

  void read_prim(int depth) {
    demand(depth < deepest_prim, "prims that are nested too deeply");
    demand(tokens_.word() == "def", "no 'def' where one should be");
    const bool is_mesh = tokens_.word() == "Mesh";
    tokens_.string();
    skip_metadata();
    MeshText* mesh = is_mesh ? &meshes_.emplace_back() : nullptr;
    tokens_.take('{');
    while (!tokens_.take_if('}')) read_part(depth, mesh);
  }

  // A prim within this one, or a property.
  void read_part(int depth, MeshText* mesh) {
    const std::uint64_t place = tokens_.place();
    std::string type = tokens_.word();
    if (type == "def") {
      tokens_.go_to(place);
      return read_prim(depth + 1);
    }
    if (type == "uniform") type = tokens_.word();
    if (tokens_.take_if('[')) tokens_.take(']');
    read_property(tokens_.word(), mesh);
  }

  void read_property(const std::string& name, MeshText* mesh) {
    if (!tokens_.take_if('=')) return skip_metadata();  // declared, with values elsewhere
    const char first = tokens_.peek();
    if (first == '"')
      tokens_.string();
    else if (first == '@')
      tokens_.skip_asset();
    else if (first == '<')
      tokens_.word();
    else if (first == '{')
      read_samples(name == "points.timeSamples" ? mesh : nullptr);
    else
      tokens_.value(numbers_named(name, mesh));
    skip_metadata();
  }

  // What the value of a property is kept in.
  std::vector<double>& numbers_named(const std::string& name, MeshText* mesh) {
    ignored_.clear();
    if (mesh == nullptr) return ignored_;
    if (name == "points") return mesh->points;
    if (name == "faceVertexCounts") return mesh->counts;
    if (name == "faceVertexIndices") return mesh->corners;
    return name == "primvars:st" ? mesh->uv : ignored_;
  }

  void read_samples(MeshText* mesh) {
    tokens_.take('{');
    while (!tokens_.take_if('}')) {
      const double time = tokens_.number();
      tokens_.take(':');
      tokens_.peek();
      if (mesh != nullptr)
        demand(mesh->samples.emplace(time, tokens_.place()).second, "two samples of one time");
      tokens_.skip_array();
      if (tokens_.peek() != '}') tokens_.take(',');
    }
  }

  // Between brackets, where strings may hold brackets, too.
  void skip_metadata() {
    if (!tokens_.take_if('(')) return;
    while (!tokens_.take_if(')')) {
      demand(tokens_.peek() != 0, "metadata without an end");
      if (tokens_.peek() == '"')
        tokens_.string();
      else if (!take_any_of("=[],"))
        tokens_.word();
    }
  }

  bool take_any_of(std::string_view marks) {
    return std::any_of(marks.begin(), marks.end(),
                       [&](char mark) { return tokens_.take_if(mark); });
  }

  // What the text of a float means.
  static Eigen::MatrixXd single(const Eigen::MatrixXd& numbers) {
    return numbers.cast<float>().cast<double>();
  }

  static WrittenMesh finished(const MeshText& mesh) {
    WrittenMesh written{.positions = single(columns(mesh.points, 3)),
                        .uv = single(columns(mesh.uv, 2))};
    if (mesh.counts.empty()) return written;
    const Eigen::MatrixXi counts = whole_columns(mesh.counts, 1);
    const int corners = counts(0);
    demand(corners >= 3 && (counts.array() == corners).all(),
           "faces with different numbers of corners");
    demand(static_cast<std::size_t>(corners) * mesh.counts.size() == mesh.corners.size(),
           "a wrong number of corners");
    written.faces = whole_columns(mesh.corners, corners);
    return written;
  }

  UsdTokens tokens_;
  double rate_ = 0;
  std::vector<MeshText> meshes_;        // while the file is being read
  std::vector<double> ignored_;         // of properties that say nothing about shape
  std::vector<std::uint64_t> samples_;  // where the points of each frame stand
};

}  // namespace

std::unique_ptr<WrittenMotion> read_usd(const std::filesystem::path& path) {
  return std::make_unique<UsdFile>(path);
}

}  // namespace ribbon

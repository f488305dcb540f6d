#include "converter/read_back/glb_file.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "converter/read_back/written_bytes.h"

namespace ribbon {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t json_begin = 20;
constexpr int float_numbers = 5126;
constexpr int u32_numbers = 5125;

// Where numbers lie in the file.
struct GlbNumbers {
  std::uint64_t begin = 0;
  std::uint64_t count = 0;
};

// What stands in the JSON for each frame and says nothing about positions: as a tree of values it
// would take more memory than all the rest.
bool is_left_out(const std::string& name) {
  return name == "min" || name == "max" || name == "targetNames" || name == "NORMAL";
}

// Makes the tree of all other values, as the library does. (With its own way to leave values out it
// would search all accessors so far at each new one.)
class NeededValues : public nlohmann::detail::json_sax_dom_parser<Json> {
 public:
  using Tree = json_sax_dom_parser;
  explicit NeededValues(Json& tree) : Tree(tree) {}

  bool null() { return is_skipped() || Tree::null(); }
  bool boolean(bool value) { return is_skipped() || Tree::boolean(value); }
  bool number_integer(std::int64_t value) { return is_skipped() || Tree::number_integer(value); }
  bool number_unsigned(std::uint64_t value) { return is_skipped() || Tree::number_unsigned(value); }
  bool number_float(double value, const std::string& text) {
    return is_skipped() || Tree::number_float(value, text);
  }
  bool string(std::string& value) { return is_skipped() || Tree::string(value); }
  bool start_object(std::size_t size) { return enters() || Tree::start_object(size); }
  bool start_array(std::size_t size) { return enters() || Tree::start_array(size); }
  bool end_object() { return leaves() || Tree::end_object(); }
  bool end_array() { return leaves() || Tree::end_array(); }
  bool key(std::string& name) {
    if (depth_ > 0) return true;
    is_next_ = is_left_out(name);
    return is_next_ || Tree::key(name);
  }

 private:
  bool is_skipped() { return depth_ > 0 || std::exchange(is_next_, false); }
  bool enters() {
    if (!is_skipped()) return false;
    ++depth_;
    return true;
  }
  bool leaves() {
    if (depth_ == 0) return false;
    --depth_;
    return true;
  }

  bool is_next_ = false;  // the value that comes is left out
  int depth_ = 0;         // of lists and objects within it
};

Json parsed(const std::string& text) {
  Json root;
  NeededValues values(root);
  Json::sax_parse(text, &values);
  return root;
}

// The JSON chunk, and the binary one that it describes.
class Chunks {
 public:
  explicit Chunks(const WrittenBytes& bytes) {
    demand(bytes.at(0, 4) == "glTF" && bytes.number<std::uint32_t>(4) == 2, "not glTF 2.0");
    demand(bytes.number<std::uint32_t>(8) == bytes.size(), "a wrong length");
    const auto json_bytes = bytes.number<std::uint32_t>(12);
    json_ = parsed(bytes.at(json_begin, json_bytes));
    binary_begin_ = json_begin + json_bytes + 8;
    binary_bytes_ = bytes.number<std::uint32_t>(binary_begin_ - 8);
    demand(binary_begin_ + binary_bytes_ <= bytes.size(), "it ends too early");
  }

  [[nodiscard]] const Json& json() const { return json_; }
  [[nodiscard]] const Json& accessor(std::size_t index) const {
    return json_.at("accessors").at(index);
  }

  [[nodiscard]] GlbNumbers numbers(std::size_t accessor_index, const char* shape, int type) const {
    const Json& found = accessor(accessor_index);
    demand(found.at("type") == shape && found.at("componentType") == type,
           "numbers of another type");
    return {.begin = begin_of(found), .count = found.at("count").get<std::uint64_t>()};
  }

  // Of an accessor, or of what refers to a view likewise.
  [[nodiscard]] std::uint64_t begin_of(const Json& part) const {
    const Json& view = json_.at("bufferViews").at(part.at("bufferView").get<std::size_t>());
    const std::uint64_t offset =
        view.value("byteOffset", std::uint64_t{0}) + part.value("byteOffset", std::uint64_t{0});
    demand(offset <= binary_bytes_, "numbers outside the binary chunk");
    return binary_begin_ + offset;
  }

 private:
  Json json_;
  std::uint64_t binary_begin_ = 0;
  std::uint64_t binary_bytes_ = 0;
};

class GlbFile : public WrittenMotion {
 public:
  explicit GlbFile(const std::filesystem::path& path) : bytes_(path) {
    const Chunks chunks(bytes_);
    for (const Json& node : chunks.json().at("nodes")) add_mesh(chunks, node);
    demand(!scene_.meshes.empty(), "it has no mesh");
    if (!targets_.empty()) read_animation(chunks);
    scene_.frames = static_cast<int>(targets_.size()) + 1;
  }

  // The first frame shows the mesh itself.
  Eigen::Matrix3Xd ribbon(int frame) override {
    Eigen::Matrix3Xd positions = points(ribbon_);
    if (frame > 0) positions += points(targets_[target_at_[static_cast<std::size_t>(frame)]]);
    return positions;
  }

 private:
  [[nodiscard]] Eigen::Matrix3Xd points(const GlbNumbers& place) const {
    return bytes_.points(place.begin, place.count);
  }

  void add_mesh(const Chunks& chunks, const Json& node) {
    const Json& mesh = chunks.json().at("meshes").at(node.at("mesh").get<std::size_t>());
    const Json& primitive = mesh.at("primitives").at(0);
    const Json& attributes = primitive.at("attributes");
    const GlbNumbers positions = chunks.numbers(attributes.at("POSITION"), "VEC3", float_numbers);
    WrittenMesh& written = scene_.meshes.emplace_back();
    if (attributes.contains("TEXCOORD_0")) {
      const GlbNumbers uv = chunks.numbers(attributes.at("TEXCOORD_0"), "VEC2", float_numbers);
      written.uv = bytes_.numbers<float>(uv.begin, 2, uv.count).cast<double>();
      for (auto place : written.uv.colwise()) place.y() = 1 - place.y();
    }
    written.faces = faces_of(chunks, mesh.at("primitives"));
    if (scene_.meshes.size() > 1) {
      written.positions = points(positions);
      return;
    }
    ribbon_ = positions;
    read_placement(node);
    if (!primitive.contains("targets")) return;
    for (const Json& target : primitive.at("targets"))
      targets_.push_back(chunks.numbers(target.at("POSITION"), "VEC3", float_numbers));
  }

  // Of primitives that share their vertices, and differ in what they show.
  [[nodiscard]] Eigen::MatrixXi faces_of(const Chunks& chunks, const Json& primitives) const {
    Eigen::MatrixXi faces(3, 0);
    for (const Json& primitive : primitives) {
      demand(primitive.at("attributes") == primitives.at(0).at("attributes") &&
                 primitive.value("targets", Json()) == primitives.at(0).value("targets", Json()),
             "primitives with vertices of their own");
      const GlbNumbers corners = chunks.numbers(primitive.at("indices"), "SCALAR", u32_numbers);
      const Eigen::MatrixXi part =
          bytes_.numbers<std::int32_t>(corners.begin, 3, corners.count / 3);
      faces.conservativeResize(3, faces.cols() + part.cols());
      faces.rightCols(part.cols()) = part;
    }
    return faces;
  }

  // Nodes bring metres and y up where the numbers are something else.
  void read_placement(const Json& node) {
    scene_.metres_per_unit = 1;
    if (node.contains("scale")) {
      const auto scale = node.at("scale").get<std::vector<double>>();
      demand(scale.size() == 3 && scale[0] == scale[1] && scale[1] == scale[2], "uneven scales");
      scene_.metres_per_unit = scale[0];
    }
    scene_.z_is_up = node.contains("rotation");
    if (!*scene_.z_is_up) return;
    const auto turn = node.at("rotation").get<std::vector<double>>();
    demand(turn.size() == 4 && std::abs(turn[0] + std::sqrt(0.5)) < 1e-6 && turn[1] == 0 &&
               turn[2] == 0 && std::abs(turn[3] - std::sqrt(0.5)) < 1e-6,
           "a rotation that is not from z up to y up");
  }

  // Weights are frames x targets numbers, of which those that are not 0 are stored.
  void read_animation(const Chunks& chunks) {
    const Json& sampler = chunks.json().at("animations").at(0).at("samplers").at(0);
    const GlbNumbers times = chunks.numbers(sampler.at("input"), "SCALAR", float_numbers);
    demand(times.count == targets_.size() + 1, "a wrong number of frames");
    const Eigen::MatrixXd times_s =
        bytes_.numbers<float>(times.begin, 1, times.count).cast<double>();
    scene_.times_s.assign(times_s.data(), times_s.data() + times_s.size());
    const Json& sparse = chunks.accessor(sampler.at("output")).at("sparse");
    demand(sparse.at("count") == targets_.size(), "a wrong number of weights");
    demand(sparse.at("indices").at("componentType") == u32_numbers, "numbers of another type");
    const auto places =
        bytes_.numbers<std::uint32_t>(chunks.begin_of(sparse.at("indices")), 1, targets_.size());
    const auto weights =
        bytes_.numbers<float>(chunks.begin_of(sparse.at("values")), 1, targets_.size());
    demand((weights.array() == 1).all(), "a target that shows in part");
    target_at_.assign(times.count, targets_.size());
    for (const std::uint32_t place : places.reshaped())
      target_at_.at(place / targets_.size()) = place % targets_.size();
    for (std::size_t frame = 1; frame < times.count; ++frame)
      demand(target_at_[frame] < targets_.size(), "a frame without a target");
  }

  WrittenBytes bytes_;
  GlbNumbers ribbon_;
  std::vector<GlbNumbers> targets_;
  std::vector<std::size_t> target_at_;  // of each frame but the first
};

}  // namespace

std::unique_ptr<WrittenMotion> read_glb(const std::filesystem::path& path) {
  return std::make_unique<GlbFile>(path);
}

}  // namespace ribbon

#include "converter/read_back/fbx_file.h"

#include <algorithm>
#include <map>
#include <utility>

#include "converter/read_back/fbx_records.h"
#include "converter/read_back/number_columns.h"
#include "converter/read_back/written_motion.h"

namespace ribbon {

namespace {

constexpr double ticks_per_second = 46'186'158'000;
constexpr double centimetres_per_metre = 100;

using Numbers = std::vector<double>;

// A face's last corner is told by its complement.
Eigen::MatrixXi faces_of(const Numbers& corners) {
  const auto is_last = [](double corner) { return corner < 0; };
  const auto first_end = std::find_if(corners.begin(), corners.end(), is_last);
  if (first_end == corners.end()) return {};
  const Eigen::Index corners_of_a_face = first_end - corners.begin() + 1;
  Eigen::MatrixXi faces = whole_columns(corners, corners_of_a_face);
  auto last = faces.row(corners_of_a_face - 1);
  demand((last.array() < 0).all(), "faces with different numbers of corners");
  last = -1 - last.array();
  demand(faces.minCoeff() >= 0, "faces with different numbers of corners");
  return faces;
}

WrittenMesh mesh_of(const ReadFbxRecord& geometry) {
  WrittenMesh mesh{.positions = columns(geometry["Vertices"].array(), 3),
                   .uv = Eigen::Matrix2Xd(2, 0),
                   .faces = faces_of(geometry["PolygonVertexIndex"].array())};
  const ReadFbxRecord& layer = geometry["LayerElementUV"];
  if (layer.name.empty()) return mesh;
  const Numbers& corners = layer["UVIndex"].array();
  demand(whole_columns(corners, 1).reshaped() == mesh.faces.reshaped(),
         "a corner with the uv of another vertex");
  mesh.uv = columns(layer["UV"].array(), 2);
  return mesh;
}

// When a curve is full; it is 0 at all other keys.
double full_at_s(const ReadFbxRecord& curve) {
  const Numbers& ticks = curve["KeyTime"].array();
  const Numbers& weights = curve["KeyValueFloat"].array();
  demand(ticks.size() == weights.size(), "a curve of a wrong length");
  const auto full = std::find(weights.begin(), weights.end(), 100.0);
  demand(full != weights.end() && std::count(weights.begin(), weights.end(), 0.0) + 1 ==
                                      static_cast<std::ptrdiff_t>(weights.size()),
         "a shape that shows in part");
  return ticks[static_cast<std::size_t>(full - weights.begin())] / ticks_per_second;
}

double identity_of(const ReadFbxRecord& record) {
  demand(!record.properties.empty(), "an object without an identity");
  return std::get<double>(record.properties.front());
}

// What objects belong to, by identity.
using Owners = std::multimap<double, double>;

// What a file tells of shapes and when they show, while it is being read.
struct Animation {
  std::vector<std::pair<double, FbxSpan>> shapes;    // with their identities
  std::vector<std::pair<double, double>> full_at_s;  // curves and when they are full
  Owners owners;
};

class FbxFile : public WrittenMotion {
 public:
  explicit FbxFile(const std::filesystem::path& path) : records_(path) {
    Animation animation;
    records_.for_each([&](const FbxSpan& part) {
      if (part.name == "GlobalSettings") read_settings(records_.read(part));
      if (part.name == "Objects") read_objects(part, animation);
      if (part.name == "Connections") read_connections(part, animation);
    });
    demand(!scene_.meshes.empty(), "it has no mesh");
    order_shapes(animation);
    scene_.frames = static_cast<int>(shapes_.size()) + 1;
  }

  Eigen::Matrix3Xd ribbon(int frame) override {
    const Eigen::Matrix3Xd& first = scene_.meshes.front().positions;
    if (frame == 0) return first;
    const ReadFbxRecord shape = records_.read(shapes_[static_cast<std::size_t>(frame) - 1]);
    const Numbers& vertices = shape["Indexes"].array();
    for (std::size_t i = 0; i < vertices.size(); ++i)
      demand(vertices[i] == static_cast<double>(i), "a shape that leaves vertices out");
    const Eigen::Matrix3Xd moved = columns(shape["Vertices"].array(), 3);
    demand(moved.cols() == first.cols(), "a shape of another number of vertices");
    return first + moved;
  }

 private:
  void read_settings(const ReadFbxRecord& settings) {
    scene_.metres_per_unit = settings.setting("UnitScaleFactor") / centimetres_per_metre;
    scene_.z_is_up = settings.setting("UpAxis") == 2;
  }

  void read_objects(const FbxSpan& part, Animation& animation) {
    records_.for_each_in(part, [&](const FbxSpan& span) {
      if (span.name != "Geometry" && span.name != "AnimationCurve") return;
      const ReadFbxRecord object = records_.read(span);
      const double identity = identity_of(object);
      if (span.name == "AnimationCurve")
        animation.full_at_s.emplace_back(identity, full_at_s(object));
      else if (object.text(2) == "Shape")
        animation.shapes.emplace_back(identity, span);
      else
        scene_.meshes.push_back(mesh_of(object));
    });
  }

  void read_connections(const FbxSpan& part, Animation& animation) {
    records_.for_each_in(part, [&](const FbxSpan& span) {
      const ReadFbxRecord connection = records_.read(span);
      animation.owners.emplace(std::get<double>(connection.properties.at(1)),
                               std::get<double>(connection.properties.at(2)));
    });
  }

  // A curve belongs to a curve's node, that to a channel, to which a shape belongs as well.
  void order_shapes(const Animation& animation) {
    const Owners& owners = animation.owners;
    std::map<double, double> channel_at_s;
    for (const auto& [curve, time_s] : animation.full_at_s)
      for (auto [node, end] = owners.equal_range(curve); node != end; ++node)
        for (auto [channel, last] = owners.equal_range(node->second); channel != last; ++channel)
          channel_at_s[channel->second] = time_s;
    std::map<double, const FbxSpan*> by_time;
    for (const auto& [shape, span] : animation.shapes)
      for (auto [channel, end] = owners.equal_range(shape); channel != end; ++channel)
        by_time[channel_at_s.at(channel->second)] = &span;
    demand(by_time.size() == animation.shapes.size(), "two shapes of one time");
    if (by_time.empty()) return;
    scene_.times_s.push_back(0);
    for (const auto& [time_s, span] : by_time) {
      scene_.times_s.push_back(time_s);
      shapes_.push_back(*span);
    }
  }

  FbxFileRecords records_;
  std::vector<FbxSpan> shapes_;  // of each frame but the first
};

}  // namespace

std::unique_ptr<WrittenMotion> read_fbx_file(const std::filesystem::path& path) {
  return std::make_unique<FbxFile>(path);
}

}  // namespace ribbon

#include "model/glb_writer.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "files/pending_file.h"
#include "geometry/single_precision.h"
#include "model/glb_scene.h"
#include "model/picture_file.h"
#include "model/rate_warnings.h"
#include "model/raw_bytes.h"
#include "recording/coding/bytes.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr std::uint64_t header_bytes = 12;
constexpr std::uint64_t chunk_header_bytes = 8;
constexpr std::uint64_t json_begin = header_bytes + chunk_header_bytes;
constexpr int most_frames = 65536;  // the place of a weight among frames x targets is a u32

std::uint64_t file_bytes(const GlbScene& scene) {
  return header_bytes + 2 * chunk_header_bytes + scene.json.size() + scene.binary_bytes;
}

// What stands before the text of the scene, and between that and the binary chunk's content.
std::string head(const GlbScene& scene) {
  std::string bytes = "glTF";
  const std::array<std::uint64_t, 3> numbers{2, file_bytes(scene), scene.json.size()};
  for (const std::uint64_t number : numbers)
    put<std::uint32_t>(bytes, static_cast<std::uint32_t>(number));
  return bytes + "JSON";
}

std::string binary_head(const GlbScene& scene) {
  std::string bytes;
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(scene.binary_bytes));
  return bytes.append("BIN\0", 4);
}

// glTF's v points down the picture.
Eigen::Matrix2Xf downwards(Eigen::Matrix2Xf uv) {
  for (auto place : uv.colwise()) place.y() = 1 - place.y();
  return uv;
}

Result<void> append_geometry(PendingFile& file, const ModelObject& object) {
  return file.append(raw_bytes(object.positions))
      .and_then([&] { return file.append(raw_bytes(object.normals)); })
      .and_then([&] { return file.append(raw_bytes(downwards(object.uv))); })
      .and_then([&] { return file.append(raw_bytes(triangulated(object.faces))); });
}

Result<void> append_picture(PendingFile& file, const Material& material) {
  if (!material.picture) return {};
  const std::string& bytes = material.picture->bytes;
  return file.append(bytes).and_then(
      [&] { return file.append(std::string(glb_padding(bytes.size()), '\0')); });
}

class GlbWriter : public MotionWriter {
 public:
  GlbWriter(std::string name, PendingFile file, Model first, int frames)
      : name_(std::move(name)),
        file_(std::move(file)),
        first_(std::move(first)),
        frames_missing_(frames) {
    bounds_.reserve(static_cast<std::size_t>(frames) - 1);
  }

  Result<void> begin() {
    const std::vector<PointBounds> unknown(static_cast<std::size_t>(frames_missing_) - 1);
    const GlbScene scene = glb_scene(first_, unknown);
    auto begun =
        file_.append(head(scene)).and_then([&] { return file_.append(scene.json); }).and_then([&] {
          return file_.append(binary_head(scene));
        });
    for (const ModelObject& object : first_.objects)
      if (begun) begun = append_geometry(file_, object);
    for (const Material& material : materials_of(first_))
      if (begun) begun = append_picture(file_, material);
    return begun;
  }

  Result<void> append(const Model& model) override {
    assert(frames_missing_ > 0);
    --frames_missing_;
    if (std::exchange(at_first_, false)) return {};
    const ModelObject& ribbon = model.objects.front();
    const ModelObject& first = first_.objects.front();
    moved_.noalias() = ribbon.positions - first.positions;
    bounds_.push_back(bounds_of(moved_));
    return displacements_keep_the_gap(ribbon)
        .and_then([&] { return file_.append(raw_bytes(moved_)); })
        .and_then([&] {
          moved_.noalias() = ribbon.normals - first.normals;
          return file_.append(raw_bytes(moved_));
        });
  }

  Result<void> finish(Older older) override {
    assert(frames_missing_ == 0);
    auto written = bounds_.empty() ? Result<void>{} : append_times_and_weights();
    return written
        .and_then([&] { return file_.overwrite(json_begin, glb_scene(first_, bounds_).json); })
        .and_then([&] { return file_.finish(older); });
  }

 private:
  Result<void> append_times_and_weights() {
    const auto targets = static_cast<Eigen::Index>(bounds_.size());
    Eigen::VectorXf times_s(targets + 1);
    for (Eigen::Index frame = 0; frame <= targets; ++frame)
      times_s[frame] = frame_time_s(first_, frame);
    Eigen::VectorX<std::uint32_t> places(targets);  // frame after frame; the first has no weights
    for (Eigen::Index target = 0; target < targets; ++target)
      places[target] = static_cast<std::uint32_t>((target + 1) * targets + target);
    const Eigen::VectorXf weights = Eigen::VectorXf::Ones(targets);
    return file_.append(raw_bytes(times_s))
        .and_then([&] { return file_.append(raw_bytes(places)); })
        .and_then([&] { return file_.append(raw_bytes(weights)); });
  }

  // They are rounded, and so is what a viewer adds up; two layers may each move by that.
  [[nodiscard]] Result<void> displacements_keep_the_gap(const ModelObject& ribbon) const {
    if (first_.stated_gap_m == 0) return {};
    const double factor = first_.placement.factor();
    const double reach = ribbon.positions.cwiseAbs().maxCoeff() + moved_.cwiseAbs().maxCoeff();
    const double rounding_m =
        std::sqrt(3.0) * 1.01 * largest_rounding(reach) / factor +
        first_.placement.rounding_m(ribbon.positions / static_cast<float>(factor));
    if (2 * rounding_m < first_.stated_gap_m) return {};
    return failure(name_,
                   "displacements round coordinates by up to " + metres(rounding_m, Rounding::up) +
                       ", so that layers could meet that are " + metres(first_.stated_gap_m) +
                       " apart",
                   "write a format that holds positions, as .obj");
  }

  std::string name_;
  PendingFile file_;
  Model first_;
  std::vector<PointBounds> bounds_;  // of the displacements so far
  Eigen::Matrix3Xf moved_;           // the last ones
  int frames_missing_;
  bool at_first_ = true;
};

Result<void> check_size(const std::filesystem::path& path, const Model& model, int frames) {
  const std::string remedy = "choose fewer frames with --frames, or write .pc2";
  if (frames > most_frames)
    return failure(path.string(),
                   filled_in("a .glb holds at most {} frames, not {}", most_frames, frames),
                   remedy);
  const std::vector<PointBounds> unknown(static_cast<std::size_t>(frames) - 1);
  const std::uint64_t bytes = file_bytes(glb_scene(model, unknown));
  if (bytes <= std::numeric_limits<std::uint32_t>::max()) return {};
  return failure(path.string(),
                 filled_in("a .glb holds at most 4 GB, and this one would take {:.1f} GB",
                           static_cast<double>(bytes) / 1e9),
                 remedy);
}

}  // namespace

Result<std::unique_ptr<MotionWriter>> new_glb_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames) {
  if (auto checked = check_size(path, model, frames); !checked)
    return tl::unexpected(checked.error());
  auto file = PendingFile::create(path);
  if (!file) return tl::unexpected(file.error());
  auto writer = std::make_unique<GlbWriter>(path.string(), std::move(*file), model, frames);
  if (auto begun = writer->begin(); !begun) return tl::unexpected(begun.error());
  return writer;
}

std::string glb_warning(const Model& model, int frames) {
  return joined_warnings(whole_rate_warning(model, frames), rounded_time_warning(model, frames));
}

}  // namespace ribbon

#include "player/bench.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "player/picture/png_encoder.h"
#include "player/render/render.h"
#include "player/shots.h"
#include "player/view/scene_model.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr int most_frames = 2000;  // read in order
constexpr int seek_count = 200;
// Pictures that are taken: so many, and as long as that.
constexpr int least_pictures = 5;
constexpr double least_s = 2;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return seconds_since(start);
}

// The value below which that part of the others lies.
double percentile(std::vector<double> values, double part) {
  const auto rank = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

std::string row(const std::string& what, const std::string& figure) {
  return filled_in("{:<16}{}\n", what, figure);
}

Result<std::string> replay_rows(RecordingReader& reader, const std::vector<int>& frames) {
  Eigen::Matrix3Xf positions;
  Result<void> read;
  const auto count = std::min(frames.size(), static_cast<std::size_t>(most_frames));
  const double in_order_s = seconds_of([&] {
    for (std::size_t f = 0; f < count && read; ++f) read = reader.read(frames[f], positions);
  });
  std::vector<double> seek_ms;
  std::uint32_t state = 1;
  for (int i = 0; i < seek_count && read; ++i) {
    state = state * 1664525U + 1013904223U;
    const int index = frames[(state >> 8) % frames.size()];
    seek_ms.push_back(1e3 * seconds_of([&] { read = reader.read(index, positions); }));
  }
  if (!read) return tl::unexpected(read.error());
  const double rate = static_cast<double>(count) / in_order_s;
  const double gigabytes = rate * static_cast<double>(positions.size()) * sizeof(float) / 1e9;
  return row("replay", filled_in("{:.0f} frames/s, {:.2f} GB/s", rate, gigabytes)) +
         row("seek",
             filled_in("{:.2f} ms half of the time, {:.2f} ms in 90 of 100, {:.2f} ms in 99",
                       percentile(seek_ms, 0.5), percentile(seek_ms, 0.9),
                       percentile(seek_ms, 0.99)));
}

// Times of one picture's stages, each the least of several.
struct PictureTimes {
  double rebuild_s = 1e9;  // of the ribbon, and its tree
  double refit_s = 1e9;
  double render_s = 1e9;
  double paint_s = 1e9;  // of all threads together
  double encode_s = 1e9;
  double file_s = 1e9;
  double rays = 0;
  double plain_s = 1e9;  // of all threads together
};

void keep_least(double& least, double value) {
  least = std::min(least, value);
}

// tree_positions: where the tree is built.
PictureTimes measure_pictures(const Eigen::Matrix3Xf& positions,
                              const Eigen::Matrix3Xf& tree_positions, const RecordingHeader& header,
                              const Camera& camera, const Options& options) {
  RenderScene scene(header);
  scene.set_cloth(options.render.cloth);
  RenderSettings settings = options.render;
  settings.timed = true;
  Renderer renderer(std::move(settings));
  PictureTimes times;
  Picture picture;
  RayLog log;
  scene.set_ribbon(tree_positions);
  scene.set_ribbon(positions, {}, RibbonTree::refitted);
  scene.log_rays_to(&log);
  Rendered rendered = renderer.render(scene, camera, options.size);
  scene.log_rays_to(nullptr);
  for (const LoggedRays& batch : log.batches()) times.rays += static_cast<double>(batch.rays.count);
  // In turns, so that all see the same machine; between two that need the ribbon others, as where
  // pictures are made, so that none finds it near the processor.
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < least_pictures || seconds_since(start) < least_s; ++i) {
    keep_least(times.rebuild_s, seconds_of([&] { scene.set_ribbon(tree_positions); }));
    keep_least(times.encode_s, seconds_of([&] { picture = encode_srgb(rendered.light); }));
    keep_least(times.file_s, seconds_of([&] { png_bytes(picture); }));
    keep_least(times.refit_s,
               seconds_of([&] { scene.set_ribbon(positions, {}, RibbonTree::refitted); }));
    keep_least(times.render_s,
               seconds_of([&] { rendered = renderer.render(scene, camera, options.size); }));
    keep_least(times.paint_s, rendered.report.paint_s);
    keep_least(times.plain_s, scene.rays().plain_seconds(log));
  }
  return times;
}

std::string picture_rows(const PictureTimes& times, const Quality& quality) {
  const double bvh_s = times.refit_s + times.rebuild_s / frames_a_tree_lasts(quality);
  const double all_s = bvh_s + times.render_s + times.encode_s + times.file_s;
  const auto stage = [&](const char* name, double seconds) {
    return row(name,
               filled_in("{:.2f} ms, {:.1f} % of a picture", 1e3 * seconds, 100 * seconds / all_s));
  };
  return row("picture", filled_in("{:.1f} ms, {:.1f} pictures/s", 1e3 * all_s, 1 / all_s)) +
         stage("  ribbon's BVH", bvh_s) + stage("  light", times.render_s) +
         stage("  sRGB", times.encode_s) + stage("  PNG", times.file_s) +
         row("rays", filled_in("{:.2f} million, {:.1f} million/s a thread traced and shaded",
                               times.rays / 1e6, times.rays / 1e6 / times.paint_s)) +
         row("plain Embree",
             filled_in("{:.1f} million/s a thread for the same rays: {:.0f} % kept",
                       times.rays / 1e6 / times.plain_s, 100 * times.plain_s / times.paint_s));
}

}  // namespace

Result<std::string> bench(RecordingReader& reader, const Options& options) {
  std::vector<int> frames;
  for (int index = 0; index < reader.frame_count(); ++index)
    if (reader.readable(index)) frames.push_back(index);
  if (frames.empty())
    return failure(options.recording.string(), "holds no frames", "record some first");
  auto replay = replay_rows(reader, frames);
  if (!replay) return replay;
  const auto shots = shots_of(options);
  if (!shots) return tl::unexpected(shots.error());
  const Quality& quality = options.render.quality;
  Eigen::Matrix3Xf positions;
  if (auto read = reader.read(frames.back(), positions); !read) return tl::unexpected(read.error());
  Eigen::Matrix3Xf tree_positions;
  if (!reader.read(frame_of_tree(frames.back(), quality), tree_positions))
    tree_positions = positions;  // as the player does where that frame is damaged
  const Camera camera = CameraWork(reader, *shots).camera(0, {frames.back(), 0});
  const RecordingHeader model = model_of(reader.header());
  const float scale = model_scale(reader.header());
  return *replay + picture_rows(measure_pictures(scale * positions, scale * tree_positions, model,
                                                 camera, options),
                                quality);
}

}  // namespace ribbon

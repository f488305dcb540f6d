#include "player/page/shown_recording.h"

#include <cmath>
#include <limits>
#include <utility>

#include "geometry/limited_edges.h"
#include "player/picture/color_map.h"
#include "player/render/cloth_pattern.h"
#include "player/render/lighting.h"
#include "player/view/scene_model.h"
#include "text/json.h"
#include "text/number_text.h"
#include "verification/largest_strain.h"

namespace ribbon {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

void append(std::vector<float>& floats, const Eigen::Vector3f& vector) {
  floats.insert(floats.end(), vector.begin(), vector.end());
}

// Those of the frames that are not among them yet.
void append_numbers(const RecordingReader& reader, std::vector<double>& all) {
  const auto known = all.size() / ShownRecording::numbers_per_frame;
  for (int index = static_cast<int>(known); index < reader.frame_count(); ++index) {
    std::vector<double> row(ShownRecording::numbers_per_frame, unknown);
    row[ShownRecording::readable] = reader.readable(index) ? 1 : 0;
    if (const auto frame = reader.numbers(index)) {
      row[ShownRecording::time_s] = frame->time_s;
      row[ShownRecording::strain] = frame->worst_strain;
      row[ShownRecording::penetrations] = frame->penetrating_edges;
      row[ShownRecording::stage] = frame->stage;
      if (frame->tightness) {
        row[ShownRecording::progress] = frame->tightness->progress;
        row[ShownRecording::pull] = frame->tightness->pull;
        row[ShownRecording::contact] = frame->tightness->contact;
      }
    }
    all.insert(all.end(), row.begin(), row.end());
  }
}

std::vector<float> threads_of(const RecordingHeader& header) {
  const auto widths_long = static_cast<float>(header.ribbon_length_m / header.ribbon_width_m);
  std::vector<float> threads;
  threads.reserve(2 * header.uv.cols());
  for (const auto& uv : header.uv.colwise()) {
    threads.push_back(uv.x() * widths_long);
    threads.push_back(uv.y());
  }
  return threads;
}

std::vector<float> corners_of(const std::optional<TriangleMesh>& obstacle) {
  std::vector<float> corners;
  if (!obstacle) return corners;
  const Surface surface = creased_surface(*obstacle);
  corners.reserve(surface.triangles.size() * ShownRecording::floats_per_corner);
  for (const int corner : surface.triangles.reshaped()) {
    append(corners, surface.vertices.col(corner));
    append(corners, surface.normals.col(corner));
  }
  return corners;
}

std::vector<std::string> sentences(const std::vector<Damage>& damage) {
  std::vector<std::string> list;
  list.reserve(damage.size());
  for (const Damage& part : damage)
    list.push_back(filled_in("byte {}: {}", part.byte, part.reason));
  return list;
}

std::vector<double> as_list(const Eigen::Vector3f& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

void append_side(bool is_front, std::vector<std::uint8_t>& texels) {
  for (int j = 0; j < pattern_across; ++j)
    for (int i = 0; i < pattern_along; ++i) {
      const float along = (static_cast<float>(i) + 0.5F) / pattern_along * pattern_period;
      const float across = (static_cast<float>(j) + 0.5F) / pattern_across;
      const Color color = is_front ? cloth_front(along, across, 1.0F / pattern_across)
                                   : cloth_back(along, across, 1.0F / pattern_across);
      for (const float channel : color.sqrt())
        texels.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
      texels.push_back(255);
    }
}

}  // namespace

Result<ShownRecording> ShownRecording::open(const std::filesystem::path& file) {
  auto reader = RecordingReader::open(file);
  if (!reader) return tl::unexpected(reader.error());
  reader->check();
  ShownRecording shown(*std::move(reader));
  for (int index = 0; index < shown.reader_.frame_count(); ++index)
    if (shown.show(index)) {
      shown.take_box();
      return shown;
    }
  return failure(file.string(), "holds no frame that can be read", "record it once more");
}

ShownRecording::ShownRecording(RecordingReader reader)
    : reader_(std::move(reader)),
      scale_(model_scale(reader_.header())),
      ribbon_(ribbon_surface(reader_.header().grid)),
      threads_(threads_of(reader_.header())),
      obstacle_(corners_of(model_of(reader_.header()).obstacle)) {
  append_numbers(reader_, numbers_);
}

// Around the frame that is shown and some that follow it.
void ShownRecording::take_box() {
  constexpr int looks = 8;
  box_min_ = positions_.rowwise().minCoeff();
  box_max_ = positions_.rowwise().maxCoeff();
  const int last = reader_.frame_count() - 1;
  for (int look = 1; look <= looks; ++look) {
    if (!reader_.read(last * look / looks, positions_)) continue;
    box_min_ = box_min_.cwiseMin(positions_.rowwise().minCoeff());
    box_max_ = box_max_.cwiseMax(positions_.rowwise().maxCoeff());
  }
  box_min_ *= scale_;
  box_max_ *= scale_;
}

std::string ShownRecording::description() const {
  const RecordingHeader& header = reader_.header();
  return Json{{"name", header.scene_name},
              {"writer", header.writer},
              {"along", header.grid.along},
              {"across", header.grid.across},
              {"length_m", header.ribbon_length_m},
              {"width_m", header.ribbon_width_m},
              {"frames", reader_.frame_count()},
              {"frames_per_second", header.frames_per_second},
              {"ending", word_for(reader_.ending())},
              {"stages", header.stages},
              {"strain_limit", header.strain_limit},
              {"damage", sentences(reader_.damage())},
              {"pattern_along", pattern_along},
              {"pattern_across", pattern_across},
              {"pattern_period", pattern_period},
              {"box_min", as_list(box_min_)},
              {"box_max", as_list(box_max_)}}
      .line();
}

Result<void> ShownRecording::refresh() {
  if (auto grown = reader_.refresh(); !grown) return grown;
  append_numbers(reader_, numbers_);
  return {};
}

Result<void> ShownRecording::show(int index) {
  if (auto read = reader_.read(index, positions_); !read) return read;
  const RecordingHeader& header = reader_.header();
  update_ribbon(header.grid, scale_ * positions_, ribbon_);
  const std::vector<float> strains =
      particle_strains(rest_size(header), measured_edges(header.limited_edges), positions_);
  particles_.clear();
  for (Eigen::Index p = 0; p < positions_.cols(); ++p) {
    append(particles_, ribbon_.vertices.col(p));
    append(particles_, ribbon_.normals.col(p));
    particles_.push_back(strains[p]);
  }
  return {};
}

std::vector<std::uint8_t> cloth_pattern_texels() {
  std::vector<std::uint8_t> texels;
  append_side(true, texels);
  append_side(false, texels);
  return texels;
}

std::vector<std::uint8_t> strain_colors() {
  std::vector<std::uint8_t> colors;
  for (int i = 0; i < 256; ++i) {
    const auto rgb = srgb_bytes(sequential_map().at(static_cast<float>(i) / 255));
    colors.insert(colors.end(), rgb.begin(), rgb.end());
    colors.push_back(255);
  }
  return colors;
}

std::vector<float> light() {
  const Lighting player;
  std::vector<float> floats;
  append(floats, player.sun_direction);
  for (const Color& color : {player.sun, player.sky_above, player.sky_below})
    append(floats, color.matrix());
  return floats;
}

}  // namespace ribbon

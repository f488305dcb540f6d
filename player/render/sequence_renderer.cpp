#include "player/render/sequence_renderer.h"

#include <algorithm>
#include <utility>

#include "player/view/scene_model.h"

namespace ribbon {

SequenceRenderer::SequenceRenderer(RecordingReader& reader, RenderSettings settings)
    : reader_(reader),
      between_(reader),
      scale_(model_scale(reader.header())),
      scene_(model_of(reader.header()), settings.thickness_m > 0),
      renderer_(std::move(settings)) {
  scene_.set_cloth(renderer_.settings().cloth);
  if (renderer_.settings().thickness_m > 0)
    gaps_.emplace(reader, Quantity::gap, renderer_.settings().thickness_m);
}

// Half of the gap to the next layer at most, less what rounding takes: the selvages of layers that
// are pressed together must not show through each other.
std::vector<float> SequenceRenderer::half_thickness(int index) {
  if (!gaps_) return {};
  constexpr float share = 0.45F;
  std::vector<float> half = gaps_->values(index, positions_);
  for (float& gap_m : half)
    gap_m = scale_ * std::min(share * gap_m, renderer_.settings().thickness_m / 2);
  return half;
}

void SequenceRenderer::set_lowest(float height_m) {
  if (renderer_.settings().ground) scene_.set_ground(height_m);
}

Result<void> SequenceRenderer::show(int index, double after) {
  if (auto read = between_.read(index, after, positions_); !read) return read;
  set_ribbon(index);
  return colors_ ? color(index, after) : Result<void>();
}

// positions_, with the tree of frame `index`; with one of their own where that frame is damaged.
void SequenceRenderer::set_ribbon(int index) {
  const RenderSettings& settings = renderer_.settings();
  const int built = frame_of_tree(index, settings.quality);
  if (tree_frame_ != built) {
    tree_frame_.reset();
    if (reader_.read(built, tree_positions_)) {
      const std::vector<float> thick(static_cast<std::size_t>(tree_positions_.cols()),
                                     scale_ * settings.thickness_m / 2);
      scene_.set_ribbon(scale_ * tree_positions_, thick);
      tree_frame_ = built;
    }
  }
  scene_.set_ribbon(scale_ * positions_, half_thickness(index),
                    tree_frame_ ? RibbonTree::refitted : RibbonTree::rebuilt);
}

Result<void> SequenceRenderer::color(int index, double after) {
  const int nearer = after < 0.5 ? index : index + 1;
  if (after > 0)
    if (auto read = reader_.read(nearer, measured_); !read) return read;
  const Eigen::Matrix3Xf& measured = after > 0 ? measured_ : positions_;
  scene_.color_ribbon(colors_->places(nearer, measured), colors_->map());
  return {};
}

LightPicture SequenceRenderer::light(const Camera& camera, PictureSize size) {
  Rendered rendered = renderer_.render(scene_, camera, size);
  noise_.error = std::max(noise_.error, rendered.report.error);
  noise_.wanting = std::max(noise_.wanting, rendered.report.wanting);
  return std::move(rendered.light);
}

Picture SequenceRenderer::picture(const Camera& camera, PictureSize size) {
  LightPicture shown = light(camera, size);
  apply(renderer_.settings().tone, shown);
  return encode_srgb(shown);
}

std::optional<Legend> SequenceRenderer::legend() const {
  if (!colors_) return std::nullopt;
  return colors_->legend();
}

}  // namespace ribbon

#include "player/preview/preview_renderer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "playback/between_frames.h"
#include "player/preview/composition.h"
#include "player/preview/preview_scene.h"
#include "player/preview/render_target.h"
#include "player/view/scene_model.h"

namespace ribbon {

struct PreviewRenderer::State {
  State(RecordingReader& recording, OffscreenContext opened, const Gl& functions, bool antialiased)
      : frames(recording),
        scale(model_scale(recording.header())),
        context(std::move(opened)),
        gl(functions),
        target(gl, antialiased) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  Result<void> draw(const PreviewShot& shot, const PicturePart& part, Picture& picture) {
    if (auto prepared = target.prepare(part.size); !prepared) return prepared;
    gl.Viewport(-part.left, -part.bottom, shot.size.width, shot.size.height);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    scene->draw(shot);
    target.read(pixels);
    compose(pixels, part, picture);
    return {};
  }

  BetweenFrames frames;
  float scale;  // of the model
  OffscreenContext context;
  Gl gl;
  RenderTarget target;
  std::optional<PreviewScene> scene;
  Eigen::Matrix3Xf positions;
  std::vector<std::uint8_t> pixels;
};

Result<PreviewRenderer> PreviewRenderer::create(RecordingReader& reader,
                                                const PreviewSettings& settings) {
  auto context = OffscreenContext::create(settings.threads);
  if (!context) return tl::unexpected(context.error());
  const auto gl = load_gl(*context);
  if (!gl) return tl::unexpected(gl.error());
  auto state = std::make_unique<State>(reader, *std::move(context), *gl, settings.antialiased);
  auto scene = PreviewScene::create(state->gl, model_of(reader.header()), settings.cloth);
  if (!scene) return tl::unexpected(scene.error());
  state->scene.emplace(*std::move(scene));
  return PreviewRenderer(std::move(state));
}

PreviewRenderer::PreviewRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
PreviewRenderer::PreviewRenderer(PreviewRenderer&&) noexcept = default;
PreviewRenderer& PreviewRenderer::operator=(PreviewRenderer&&) noexcept = default;
PreviewRenderer::~PreviewRenderer() = default;

Result<void> PreviewRenderer::show(int index, double after) {
  if (auto read = state_->frames.read(index, after, state_->positions); !read) return read;
  state_->context.make_current();
  state_->scene->set_ribbon(state_->scale * state_->positions);
  return {};
}

Result<Picture> PreviewRenderer::picture(const Camera& camera, PictureSize size) {
  state_->context.make_current();
  Picture picture{size, std::vector<std::uint8_t>(3 * size.pixel_count())};
  for (int bottom = 0; bottom < size.height; bottom += largest_preview_part)
    for (int left = 0; left < size.width; left += largest_preview_part) {
      const PicturePart part{left,
                             bottom,
                             {std::min(largest_preview_part, size.width - left),
                              std::min(largest_preview_part, size.height - bottom)}};
      if (auto drawn = state_->draw({camera, size}, part, picture); !drawn)
        return tl::unexpected(drawn.error());
    }
  return picture;
}

}  // namespace ribbon

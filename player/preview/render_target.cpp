#include "player/preview/render_target.h"

namespace ribbon {

RenderTarget::RenderTarget(const Gl& gl, bool antialiased) : gl_(&gl), antialiased_(antialiased) {}

RenderTarget::Buffers RenderTarget::make(GLsizei samples) {
  Buffers buffers;
  gl_->GenFramebuffers(1, &buffers.frame);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, buffers.frame);
  const auto attach = [&](GLuint& buffer, GLenum format, GLenum place) {
    gl_->GenRenderbuffers(1, &buffer);
    gl_->BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size_.width,
                                        size_.height);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
  };
  attach(buffers.color, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  attach(buffers.depth, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
  return buffers;
}

void RenderTarget::free(const Buffers& buffers) const {
  gl_->DeleteFramebuffers(1, &buffers.frame);
  gl_->DeleteRenderbuffers(1, &buffers.color);
  gl_->DeleteRenderbuffers(1, &buffers.depth);
}

Result<void> RenderTarget::prepare(PictureSize size) {
  constexpr GLsizei samples = 4;  // the most that Mesa's software rasteriser has
  if (size == size_) {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, drawn_.frame);
    return {};
  }
  free(drawn_);
  free(resolved_);
  size_ = size;
  resolved_ = antialiased_ ? make(0) : Buffers{};
  drawn_ = make(antialiased_ ? samples : 0);
  if (gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE &&
      gl_->GetError() == GL_NO_ERROR)
    return {};
  return failure("--preview", "OSMesa has no memory for the picture", "ask for a smaller --size");
}

void RenderTarget::read(std::vector<std::uint8_t>& pixels) const {
  const GLsizei width = size_.width;
  const GLsizei height = size_.height;
  if (antialiased_) {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.frame);
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.frame);
    gl_->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.frame);
  }
  pixels.resize(4 * size_.pixel_count());
  gl_->ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

}  // namespace ribbon

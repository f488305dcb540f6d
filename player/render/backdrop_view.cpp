#include "player/render/backdrop_view.h"

#include "parallel/parallel.h"

namespace ribbon {

BackdropView::BackdropView(const Backdrop& backdrop, const Camera& camera, PictureSize size)
    : width_(static_cast<std::size_t>(size.width)) {
  if (!backdrop.environment) {
    for (int y = 0; y < size.height; ++y) rows_.push_back(backdrop.at(y, size.height));
    return;
  }
  pixels_.resize(size.pixel_count());
  const auto width = static_cast<float>(size.width);
  const auto height = static_cast<float>(size.height);
  const float pixel = 2 * camera.half_height / height;  // as an angle, in the middle
  parallel_ranges(
      static_cast<std::size_t>(size.height), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          const float up = 1 - (2 * static_cast<float>(y) + 1) / height;
          for (int x = 0; x < size.width; ++x) {
            const float right = (2 * static_cast<float>(x) + 1) / width - 1;
            pixels_[y * size.width + x] =
                backdrop.environment->seen(camera.direction(right, up).normalized(), pixel);
          }
        }
      });
}

}  // namespace ribbon

#include "player/memory_forecast.h"

#include <algorithm>

#include "player/output/picture_format.h"

namespace ribbon {

namespace {

constexpr double reserve = 1.25;
// The program, its libraries and threads.
constexpr double program_bytes = 24e6;
// Positions, normals, triangles and their bounding volumes.
constexpr double bytes_of_a_vertex = 600;
// Of a pixel: light as it is gathered, and the pictures that wait and are encoded.
constexpr double bytes_of_a_pixel = 25;
constexpr double bytes_of_an_exr_pixel = 50;
// What smoothing looks at besides.
constexpr double bytes_of_a_smoothed_pixel = 60;
// What a panorama shows of itself behind the scene.
constexpr double bytes_of_a_backdrop_pixel = 12;
// While a file becomes a texture it is there as bytes, too.
constexpr double reading_a_texture = 1.25;
// What a preview needs besides: OSMesa with its compiler, and what it draws into, a part of the
// picture at a time.
constexpr double osmesa_bytes = 75e6;
constexpr double bytes_of_a_drawn_pixel = 15;
constexpr double bytes_of_an_antialiased_pixel = 55;

double preview_bytes(const PreviewSettings& settings, PictureSize size) {
  const double drawn = static_cast<double>(std::min(size.width, largest_preview_part)) *
                       std::min(size.height, largest_preview_part);
  return osmesa_bytes +
         drawn * (settings.antialiased ? bytes_of_an_antialiased_pixel : bytes_of_a_drawn_pixel);
}

double texture_bytes(const RenderSettings& settings) {
  double bytes = 0;
  for (const auto& texture : {settings.cloth.front, settings.cloth.back})
    if (texture) bytes += static_cast<double>(texture->bytes());
  if (settings.lighting.environment)
    bytes += static_cast<double>(settings.lighting.environment->bytes());
  return reading_a_texture * bytes;
}

double bytes_of_light(const RenderSettings& settings) {
  return (settings.quality.smooth_sky ? bytes_of_a_smoothed_pixel : 0) +
         (settings.backdrop.environment ? bytes_of_a_backdrop_pixel : 0);
}

}  // namespace

std::uint64_t memory_forecast(const RecordingHeader& header, const Options& options) {
  double vertices = header.grid.particle_count();
  if (header.obstacle) vertices += static_cast<double>(header.obstacle->vertices.cols());
  const auto format = picture_format(options.pictures);
  const bool is_exr = format && *format == PictureFormat::exr;
  double pixel_bytes = is_exr ? bytes_of_an_exr_pixel : bytes_of_a_pixel;
  if (!options.preview) pixel_bytes += bytes_of_light(options.render);
  // Each view has pictures that wait; light is gathered for one at a time.
  const double views = std::max<double>(1, static_cast<double>(options.views.size()));
  const double preview = options.preview ? preview_bytes(*options.preview, options.size) : 0;
  return static_cast<std::uint64_t>(
      reserve * (program_bytes + (options.preview ? 2 : 1) * texture_bytes(options.render) +
                 preview + bytes_of_a_vertex * vertices +
                 pixel_bytes * views * static_cast<double>(options.size.pixel_count())));
}

}  // namespace ribbon

#include "player/render/sky_filter.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "parallel/parallel.h"
#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

constexpr int first_step = 1;  // pixels between neighbours; doubled from pass to pass
constexpr int last_step = 4;
// Neighbours do not count from here on.
constexpr float most_lean = 0.08F;   // 1 - cosine between the normals
constexpr float most_offset = 1.5F;  // from the tangent plane, in pixels between the neighbours

struct Rows {
  const PixelPlanes& planes;
  const Planes& from;
  Planes& to;
  int step;
  float pixel_m;
};

// Columns of a row, from the first to before the last.
struct Segment {
  int begin;
  int end;
};

// What neighbours gave, column by column.
struct Sums {
  std::vector<float> red, green, blue, weights;

  explicit Sums(int width) {
    for (auto* sums : {&red, &green, &blue, &weights})
      sums->resize(static_cast<std::size_t>(width));
  }
  void clear(Segment segment) {
    for (auto* sums : {&red, &green, &blue, &weights})
      std::fill(sums->begin() + segment.begin, sums->begin() + segment.end, 0.0F);
  }
};

// Three planes from one pixel on.
struct Row {
  const float* x;
  const float* y;
  const float* z;
};

Row row_from(const Planes& planes, std::ptrdiff_t pixel) {
  return {planes[0].data() + pixel, planes[1].data() + pixel, planes[2].data() + pixel};
}

// Adds what the neighbours `dx` columns away in row `other` give to those of row `y`.
void add_neighbours(const Rows& r, int y, Segment segment, int other, int dx, float weight,
                    Sums& sums) {
  const int width = r.planes.size.width;
  const auto own = static_cast<std::ptrdiff_t>(y) * width;
  const auto theirs = static_cast<std::ptrdiff_t>(other) * width + dx;
  const Row normal = row_from(r.planes.normal, own);
  const Row their_normal = row_from(r.planes.normal, theirs);
  const Row position = row_from(r.planes.position, own);
  const Row their_position = row_from(r.planes.position, theirs);
  const Row light = row_from(r.from, theirs);
  const float* even = r.planes.evenness.data() + theirs;
  const float lean_scale = 1 / most_lean;
  const float offset_scale = 1 / (most_offset * r.pixel_m * static_cast<float>(r.step));
  float* sum_r = sums.red.data();
  float* sum_g = sums.green.data();
  float* sum_b = sums.blue.data();
  float* weights = sums.weights.data();
  const int begin = std::max(segment.begin, -dx);
  const int end = std::min(segment.end, width - dx);
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (int x = begin; x < end; ++x) {
      const float cosine = normal.x[x] * their_normal.x[x] + normal.y[x] * their_normal.y[x] +
                           normal.z[x] * their_normal.z[x];
      const float lean = (1 - cosine) * lean_scale;
      const float offset = (normal.x[x] * (their_position.x[x] - position.x[x]) +
                            normal.y[x] * (their_position.y[x] - position.y[x]) +
                            normal.z[x] * (their_position.z[x] - position.z[x])) *
                           offset_scale;
      const float near = std::max(0.0F, 1 - lean) * std::max(0.0F, 1 - offset * offset);
      const float w = weight * even[x] * near;
      sum_r[x] += w * light.x[x];
      sum_g[x] += w * light.y[x];
      sum_b[x] += w * light.z[x];
      weights[x] += w;
    }
  });
}

void smooth_segment(const Rows& r, int y, Segment segment, Sums& sums) {
  sums.clear(segment);
  for (int down = -1; down <= 1; ++down) {
    const int other = y + down * r.step;
    if (other < 0 || other >= r.planes.size.height) continue;
    for (int right = -1; right <= 1; ++right) {
      const auto weight = static_cast<float>((2 - std::abs(down)) * (2 - std::abs(right)));
      add_neighbours(r, y, segment, other, right * r.step, weight, sums);
    }
  }
  const std::size_t row = static_cast<std::size_t>(y) * r.planes.size.width;
  const std::array<const float*, 3> given{sums.red.data(), sums.green.data(), sums.blue.data()};
  for (std::size_t channel = 0; channel < 3; ++channel)
    for (int x = segment.begin; x < segment.end; ++x)
      if (r.planes.evenness[row + x] > 0 && sums.weights[x] > 0)
        r.to[channel][row + x] = given[channel][x] / sums.weights[x];
}

// The parts of row `y` in which there is a surface, in steps of 16 columns.
std::vector<Segment> segments_with_surface(const PixelPlanes& planes, int y) {
  constexpr int columns = 16;
  const float* even = planes.evenness.data() + static_cast<std::ptrdiff_t>(y) * planes.size.width;
  std::vector<Segment> segments;
  for (int begin = 0; begin < planes.size.width; begin += columns) {
    const int end = std::min(begin + columns, planes.size.width);
    if (std::none_of(even + begin, even + end, [](float e) { return e > 0; })) continue;
    if (!segments.empty() && segments.back().end == begin)
      segments.back().end = end;
    else
      segments.push_back({begin, end});
  }
  return segments;
}

}  // namespace

void smooth_sky(PixelPlanes& planes, float pixel_m) {
  Planes smoothed = planes.sky;
  for (int step = first_step; step <= last_step; step *= 2) {
    const Rows rows{planes, planes.sky, smoothed, step, pixel_m};
    parallel_ranges(static_cast<std::size_t>(planes.size.height), 8,
                    [&](std::size_t begin, std::size_t end) {
                      Sums sums(planes.size.width);
                      for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
                        for (const Segment& segment : segments_with_surface(planes, y))
                          smooth_segment(rows, y, segment, sums);
                    });
    planes.sky.swap(smoothed);
  }
}

}  // namespace ribbon

#include "player/render/tile_painter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "player/render/light_directions.h"

namespace ribbon {

namespace {

constexpr int block_side = 4;  // pixels whose rays travel together

// Light from all sides mixes what it comes from: a pattern there would only be noise.
constexpr float bounce_spread = 0.5F;

Eigen::Array4f four(const Color& color) {
  return {color[0], color[1], color[2], 0};
}

float luminance(const Eigen::Array4f& light) {
  return 0.2126F * light[0] + 0.7152F * light[1] + 0.0722F * light[2];
}

Color full_light_on_ground(const Lighting& lighting) {
  return lighting.sun * std::max(0.0F, lighting.sun_direction.y()) +
         lighting.mean_sky(Eigen::Vector3f::UnitY());
}

void add_to(VectorLanes& lanes, std::size_t lane, const Color& light) {
  lanes.x[lane] += light[0];
  lanes.y[lane] += light[1];
  lanes.z[lane] += light[2];
}

float& samples_of_body(Hit::Body body, PixelSums& sums) {
  if (body == Hit::Body::ribbon) return sums.albedo[3];
  return body == Hit::Body::obstacle ? sums.sky[3] : sums.direct[3];
}

}  // namespace

TilePainter::TilePainter(const Setting& setting) : s_(setting) {
  rays_.spread = s_.rays.spread();
  light_rays_.spread = bounce_spread;
}

void TilePainter::paint(int left, int top) {
  left_ = left;
  top_ = top;
  width_ = std::min(tile_side, s_.size.width - left);
  height_ = std::min(tile_side, s_.size.height - top);
  sums_.fill({});
  set_keys();
  int taken = 0;
  for (int wanted = s_.quality.samples;; wanted = 2 * taken) {
    wanted = std::min(wanted, s_.quality.most_samples);
    sample_wanting(taken, wanted);
    finish_batch();
    taken = wanted;
    if (s_.quality.noise == 0 || taken == s_.quality.most_samples || !find_wanting(taken)) return;
  }
}

// In small blocks, whose rays travel together.
void TilePainter::sample_wanting(int first, int end) {
  for (int top = 0; top < height_; top += block_side)
    for (int left = 0; left < width_; left += block_side)
      for (int row = top; row < std::min(top + block_side, height_); ++row)
        for (int column = left; column < std::min(left + block_side, width_); ++column) {
          const int pixel = row * tile_side + column;
          if (first > 0 && !wanting_[static_cast<std::size_t>(pixel)]) continue;
          for (int number = first; number < end; ++number)
            add({static_cast<std::uint16_t>(pixel), static_cast<std::uint16_t>(number)});
        }
}

// A pixel whose samples agree may have missed what its neighbours found: it wants more as they do,
// if it has as many as any. Returns whether any wants more.
bool TilePainter::find_wanting(int taken) {
  std::array<bool, tile_pixels> uncertain{};
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column)
      uncertain[row * tile_side + column] =
          pixel(column, row).shown[3] == static_cast<float>(taken) &&
          error(column, row) > s_.quality.noise;
  wanting_.reset();
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column) {
      if (pixel(column, row).shown[3] != static_cast<float>(taken)) continue;
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, height_ - 1); ++y)
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, width_ - 1); ++x)
          if (uncertain[y * tile_side + x]) wanting_.set(row * tile_side + column);
    }
  return wanting_.any();
}

void TilePainter::add(const Sample& sample) {
  samples_[rays_.count] = sample;
  rays_.add(s_.rays.ray(left_ + sample.pixel % tile_side, top_ + sample.pixel / tile_side,
                        sample.number));
  if (rays_.count == batch_size) finish_batch();
}

void TilePainter::finish_batch() {
  s_.scene.rays().first_hits(rays_, Coherence::similar, hits_);
  sort_hits();
  rays_.count = 0;
  const std::size_t count = seen_.count;
  for (VectorLanes* light : {&sunlight_, &skylight_})
    for (std::size_t i = 0; i < count; ++i) light->x[i] = light->y[i] = light->z[i] = 0;
  add_sunlight(Pattern::sun, seen_, seen_samples_, sunlight_);
  if (s_.quality.sky == SkyLight::bounced)
    add_bounced_skylight(skylight_);
  else
    add_skylight(Pattern::sky, seen_, seen_samples_, s_.lighting.bounce, skylight_);
  for (std::size_t i = 0; i < count; ++i) {
    PixelSums& sums = sums_[seen_samples_[i].pixel];
    const Eigen::Array4f albedo(seen_.albedo.x[i], seen_.albedo.y[i], seen_.albedo.z[i], 0);
    const Eigen::Array4f sky(skylight_.x[i], skylight_.y[i], skylight_.z[i], 0);
    const Eigen::Array4f direct =
        albedo * Eigen::Array4f(sunlight_.x[i], sunlight_.y[i], sunlight_.z[i], 0);
    sums.direct += direct;
    sums.albedo += albedo;
    sums.sky += sky;
    samples_of_body(seen_.body[i], sums) += 1;
    count_in(seen_samples_[i], direct + albedo * sky);
    if (!s_.quality.smooth_sky) continue;
    sums.normal.head<3>() += seen_.normal.at(i).array();
    sums.position.head<3>() += seen_.position.at(i).array();
  }
}

// The samples that see the backdrop are done; the others' surfaces are laid side by side.
void TilePainter::sort_hits() {
  seen_.count = 0;
  for (std::size_t i = 0; i < rays_.count; ++i) {
    seen_samples_[seen_.count] = samples_[i];
    if (hits_[i].body != Hit::Body::none) {
      s_.scene.add_point(rays_, i, hits_[i], seen_);
      continue;
    }
    const Color backdrop = s_.backdrop.at(top_ + samples_[i].pixel / tile_side, s_.size.height);
    if (s_.scene.add_ground(rays_, i, seen_)) {
      // In full light the floor cannot be told from the backdrop.
      seen_.albedo.set(seen_.count - 1, (backdrop / full_light_on_ground(s_.lighting)).matrix());
      continue;
    }
    sums_[samples_[i].pixel].direct += four(backdrop);
    count_in(samples_[i], four(backdrop));
  }
}

// Where the samples of a pattern look, as points of the unit disc.
void TilePainter::look(Pattern pattern, const Lanes<Sample>& samples, std::size_t count) {
  const auto& keys = keys_[static_cast<std::size_t>(pattern)];
  Lanes<float> u;
  Lanes<float> v;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [key_x, key_y] = keys[samples[i].pixel];
    const Eigen::Vector2f point = s_.patterns.point(pattern, samples[i].number, key_x, key_y);
    u[i] = point.x();
    v[i] = point.y();
  }
  to_disc(u, v, count, disc_x_, disc_y_);
}

// Light that the sun sends to each surface, as white cloth would show it.
void TilePainter::add_sunlight(Pattern pattern, const SurfaceBatch& surface,
                               const Lanes<Sample>& samples, VectorLanes& light) {
  look(pattern, samples, surface.count);
  to_sun(s_.lighting.sun_direction, s_.lighting.sun_radius, disc_x_, disc_y_, surface.count,
         towards_);
  Lanes<float> cosines;
  products(surface.normal, towards_, surface.count, cosines);
  light_rays_.count = 0;
  for (std::size_t i = 0; i < surface.count; ++i) {
    if (cosines[i] <= 0) continue;
    asked_for_[light_rays_.count] = static_cast<std::uint16_t>(i);
    light_rays_.add({surface.start.at(i), towards_.at(i)});
  }
  s_.scene.rays().unblocked(light_rays_, Coherence::similar, free_);
  for (std::size_t r = 0; r < light_rays_.count; ++r)
    add_to(light, asked_for_[r], s_.lighting.sun * (cosines[asked_for_[r]] * free_[r]));
}

// One ray a surface, into a direction of the sky that is as likely as its light counts.
void TilePainter::ask_sky(Pattern pattern, const SurfaceBatch& surface,
                          const Lanes<Sample>& samples) {
  look(pattern, samples, surface.count);
  to_sky(surface.normal, disc_x_, disc_y_, surface.count, light_rays_.direction);
  light_rays_.origin = surface.start;
  light_rays_.count = surface.count;
}

// All of the sky's light, which has no noise, less what is hidden. What hides it sends back the
// part `returned`.
void TilePainter::add_skylight(Pattern pattern, const SurfaceBatch& surface,
                               const Lanes<Sample>& samples, float returned, VectorLanes& light) {
  for (std::size_t i = 0; i < surface.count; ++i)
    add_to(light, i, s_.lighting.mean_sky(surface.normal.at(i)));
  if (s_.quality.sky == SkyLight::open) return;
  ask_sky(pattern, surface, samples);
  s_.scene.rays().unblocked(light_rays_, Coherence::mixed, free_);
  for (std::size_t i = 0; i < surface.count; ++i)
    if (free_[i] == 0)
      add_to(light, i, s_.lighting.sky(light_rays_.direction.at(i)) * (returned - 1));
}

// Instead of hidden sky, the light that the hiding surface itself receives and returns.
void TilePainter::add_bounced_skylight(VectorLanes& light) {
  for (std::size_t i = 0; i < seen_.count; ++i)
    add_to(light, i, s_.lighting.mean_sky(seen_.normal.at(i)));
  ask_sky(Pattern::sky, seen_, seen_samples_);
  s_.scene.rays().first_hits(light_rays_, Coherence::mixed, hits_);
  bounce_.count = 0;
  for (std::size_t i = 0; i < seen_.count; ++i) {
    if (hits_[i].body == Hit::Body::none) continue;
    add_to(light, i, -s_.lighting.sky(light_rays_.direction.at(i)));
    bounce_of_[bounce_.count] = static_cast<std::uint16_t>(i);
    bounce_samples_[bounce_.count] = seen_samples_[i];
    s_.scene.add_point(light_rays_, i, hits_[i], bounce_);
  }
  VectorLanes received;
  for (std::size_t i = 0; i < bounce_.count; ++i) received.x[i] = received.y[i] = received.z[i] = 0;
  add_sunlight(Pattern::sun_on_bounce, bounce_, bounce_samples_, received);
  add_skylight(Pattern::sky_on_bounce, bounce_, bounce_samples_, 0, received);
  for (std::size_t i = 0; i < bounce_.count; ++i)
    add_to(light, bounce_of_[i], received.at(i).array() * bounce_.albedo.at(i).array());
}

void TilePainter::count_in(const Sample& sample, const Eigen::Array4f& shown) {
  PixelSums& sums = sums_[sample.pixel];
  const float light = luminance(shown);
  sums.shown += shown;
  sums.shown[3] += 1;
  sums.position[3] += light * light;
}

// A pixel shows the mean of its samples; sRGB is near enough to a square root here.
float TilePainter::error(int column, int row) const {
  const PixelSums& sums = pixel(column, row);
  const float count = sums.shown[3];
  assert(count >= 2);
  const float mean = luminance(sums.shown) / count;
  const float variance = std::max(0.0F, sums.position[3] / count - mean * mean) / (count - 1);
  constexpr float darkest = 0.002F;
  return 127.5F * std::sqrt(variance / std::max(mean, darkest));
}

// Each pixel has patterns of its own.
void TilePainter::set_keys() {
  const bool bounces = s_.quality.sky == SkyLight::bounced;
  const bool asks_sky = s_.quality.sky != SkyLight::open;
  const Pattern last = bounces ? Pattern::sky_on_bounce : asks_sky ? Pattern::sky : Pattern::sun;
  for (auto pattern = static_cast<std::size_t>(Pattern::sun);
       pattern <= static_cast<std::size_t>(last); ++pattern)
    for (int row = 0; row < height_; ++row)
      for (int column = 0; column < width_; ++column) {
        const auto pixel =
            static_cast<std::uint32_t>((top_ + row) * s_.size.width + left_ + column);
        const std::uint32_t key =
            scramble(pattern_count * pixel + static_cast<std::uint32_t>(pattern));
        keys_[pattern][static_cast<std::size_t>(row * tile_side + column)] = {key, scramble(key)};
      }
}

}  // namespace ribbon

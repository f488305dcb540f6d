#include "player/render/tile_painter.h"

#include <algorithm>

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"
#include "player/render/light_directions.h"

namespace ribbon {

namespace {

constexpr int block_side = 4;  // pixels whose rays travel together

// Light from all sides mixes what it comes from: a pattern there would only be noise.
constexpr float bounce_spread = 0.5F;

Eigen::Array4f four(const Color& color) {
  return {color[0], color[1], color[2], 0};
}

Eigen::Array4f sum_of(const VectorLanes& lanes, std::size_t begin, std::size_t end) {
  LaneVector sum = lane_of(lanes, begin);
  for (std::size_t i = begin + 1; i < end; ++i) sum = sum + lane_of(lanes, i);
  return {sum.x, sum.y, sum.z, 0};
}

[[gnu::always_inline]] inline float luminance(LaneVector light) {
  return 0.2126F * light.x + 0.7152F * light.y + 0.0722F * light.z;
}

Color full_light_on_ground(const Lighting& lighting) {
  return lighting.sun * std::max(0.0F, lighting.sun_direction.y()) +
         lighting.mean_sky(Eigen::Vector3f::UnitY());
}

void clear(VectorLanes& lanes, std::size_t count) {
  for (Lanes<float>* lane : {&lanes.x, &lanes.y, &lanes.z}) std::fill_n(lane->begin(), count, 0.0F);
}

void add_to(VectorLanes& lanes, std::size_t lane, const Color& light) {
  lanes.x[lane] += light[0];
  lanes.y[lane] += light[1];
  lanes.z[lane] += light[2];
}

// The light of white cloth under the open sky.
void add_mean_sky(const Lighting& lighting, const SurfaceBatch& surface, VectorLanes& light) {
  if (lighting.environment) {
    for (std::size_t i = 0; i < surface.count; ++i)
      add_to(light, i, lighting.mean_sky(surface.normal.at(i)));
    return;
  }
  const LaneVector below = lane_vector(lighting.sky_below);
  const LaneVector rise = lane_vector(lighting.sky_above - lighting.sky_below);
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < surface.count; ++i)
      set_lane(light, i, lane_of(light, i) + (below + (0.5F + surface.normal.y[i] / 3) * rise));
  });
}

float& samples_of_body(Body body, PixelSums& sums) {
  if (body == Body::ribbon) return sums.albedo[3];
  return body == Body::obstacle ? sums.sky[3] : sums.direct[3];
}

}  // namespace

void TilePainter::Samples::set(std::size_t first, const Samples& others, const LaneList& list) {
  for (std::size_t i = 0; i < list.count; ++i) {
    place[first + i] = others.place[list.lanes[i]];
    pixel[first + i] = others.pixel[list.lanes[i]];
    number[first + i] = others.number[list.lanes[i]];
  }
}

TilePainter::TilePainter(const Setting& setting) : s_(setting) {
  rays_.spread = s_.rays.spread();
  light_rays_.spread = bounce_spread;
}

void TilePainter::paint(int left, int top) {
  left_ = left;
  top_ = top;
  width_ = std::min(tile_side, s_.size.width - left);
  height_ = std::min(tile_side, s_.size.height - top);
  for (PixelSums& sums : sums_) sums.clear();
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column)
      backdrop_[place_in_tile(column, row)] = four(s_.backdrop.at(left_ + column, top_ + row));
  wanting_.set();
  if (!s_.quality.is_adaptive()) {
    sample_wanting(s_.quality.samples);
    return;
  }
  noise_.begin(width_, height_);
  const int first = s_.quality.samples / 2;
  sample_wanting(first);
  estimate_noise();
  do {
    sample_wanting(first);
    estimate_noise();
    wanting_ = worth_more();
  } while (wanting_.any());
}

// The pixels that are to get twice the samples that they have.
std::bitset<tile_pixels> TilePainter::worth_more() const {
  const Quality& quality = s_.quality;
  if (quality.least_gain > 0)
    return noise_.worth_doubling(quality.least_gain, quality.most_samples);
  if (noise_.error() <= quality.noise) return {};
  return noise_.most_worth_doubling(quality.most_samples);
}

// In small blocks, whose rays travel together.
void TilePainter::sample_wanting(int first_samples) {
  for (int top = 0; top < height_; top += block_side)
    for (int left = 0; left < width_; left += block_side)
      for (int row = top; row < std::min(top + block_side, height_); ++row)
        for (int column = left; column < std::min(left + block_side, width_); ++column)
          sample_again(row, column, first_samples);
  finish_batch();
}

// If it wants samples: its first ones, or as many again.
void TilePainter::sample_again(int row, int column, int first_samples) {
  if (!wanting_[place_in_tile(column, row)]) return;
  const PixelSums& sums = pixel(column, row);
  const int taken = static_cast<int>(sums.shown[3]);
  const int end = taken == 0 ? first_samples : 2 * taken;
  // Smoothing does the rest where there is a surface to smooth.
  asking_[place_in_tile(column, row)] =
      !s_.quality.smooth_sky || taken < s_.quality.samples || !sums.saw_one_surface();
  for (int number = taken; number < end; ++number) add(row, column, number);
}

void TilePainter::estimate_noise() {
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column) {
      if (!wanting_[place_in_tile(column, row)]) continue;
      const PixelSums& sums = pixel(column, row);
      noise_.update(column, row, sums.shown[3],
                    luminance({sums.shown[0], sums.shown[1], sums.shown[2]}), sums.position[3]);
    }
}

void TilePainter::add(int row, int column, int number) {
  const Eigen::Vector2f place = s_.rays.place(left_ + column, top_ + row, number);
  place_x_[sample_count_] = place.x();
  place_y_[sample_count_] = place.y();
  samples_.place[sample_count_] = static_cast<std::uint16_t>(place_in_tile(column, row));
  samples_.pixel[sample_count_] =
      static_cast<std::uint32_t>((top_ + row) * s_.size.width + left_ + column);
  samples_.number[sample_count_] = static_cast<std::uint32_t>(number);
  if (++sample_count_ == batch_size) finish_batch();
}

void TilePainter::finish_batch() {
  s_.rays.look(place_x_, place_y_, sample_count_, rays_);
  sample_count_ = 0;
  s_.scene.rays().first_hits(rays_, Coherence::similar, hits_);
  sort_hits();
  clear(sunlight_, seen_.count);
  clear(skylight_, seen_.count);
  add_sunlight(Pattern::sun, seen_, seen_samples_, sunlight_);
  if (s_.quality.sky == SkyLight::bounced)
    add_bounced_skylight(skylight_);
  else
    add_skylight(Pattern::sky, seen_, seen_samples_, s_.lighting.bounce, skylight_);
  add_up();
}

// The samples that see the backdrop are done; the others' surfaces are laid side by side, body by
// body.
void TilePainter::sort_hits() {
  on_ribbon_.count = on_obstacle_.count = on_nothing_.count = 0;
  for (std::size_t i = 0; i < rays_.count; ++i) {
    on_ribbon_.add_if(i, hits_.body[i] == Body::ribbon);
    on_obstacle_.add_if(i, hits_.body[i] == Body::obstacle);
    on_nothing_.add_if(i, hits_.body[i] == Body::none);
  }
  seen_.count = 0;
  seen_samples_.set(0, samples_, on_ribbon_);
  s_.scene.add_points(Body::ribbon, rays_, hits_, on_ribbon_, seen_);
  seen_samples_.set(seen_.count, samples_, on_obstacle_);
  s_.scene.add_points(Body::obstacle, rays_, hits_, on_obstacle_, seen_);
  for (std::size_t i = 0; i < on_nothing_.count; ++i)
    if (!s_.scene.has_ground() || !add_ground(on_nothing_.lanes[i]))
      add_backdrop(on_nothing_.lanes[i]);
}

void TilePainter::add_backdrop(std::size_t lane) {
  const std::size_t place = samples_.place[lane];
  const Eigen::Array4f& backdrop = backdrop_[place];
  const float light = luminance({backdrop[0], backdrop[1], backdrop[2]});
  PixelSums& sums = sums_[place];
  sums.shown += backdrop;
  sums.shown[3] += 1;
  sums.direct += backdrop;
  sums.position[3] += light * light;
}

bool TilePainter::add_ground(std::size_t lane) {
  const std::size_t to = seen_.count;
  if (!s_.scene.add_ground(rays_, lane, seen_)) return false;
  seen_samples_.set(to, samples_, {{static_cast<std::uint16_t>(lane)}, 1});
  // In full light the floor cannot be told from the backdrop.
  const Color backdrop = backdrop_[samples_.place[lane]].head<3>();
  seen_.albedo.set(to, (backdrop / full_light_on_ground(s_.lighting)).matrix());
  return true;
}

// Where the samples of a pattern look, as points of the unit disc. Each pixel has patterns of its
// own.
void TilePainter::look(Pattern pattern, const Samples& samples, std::size_t count) {
  Lanes<float> u;
  Lanes<float> v;
  s_.patterns.points(pattern, samples.pixel, samples.number, count, u, v);
  to_disc(u, v, count, disc_x_, disc_y_);
}

// Lays out the rays that go from the wanted surfaces towards_ a light.
template <class Wanted>
void TilePainter::send(const SurfaceBatch& surface, const Wanted& wanted) {
  asked_for_.count = 0;
  for (std::size_t i = 0; i < surface.count; ++i) {
    set_lane(light_rays_.origin, asked_for_.count, lane_of(surface.start, i));
    set_lane(light_rays_.direction, asked_for_.count, lane_of(towards_, i));
    asked_for_.add_if(i, wanted(i));
  }
  light_rays_.count = asked_for_.count;
}

// Light that the sun sends to each surface, as white cloth would show it.
void TilePainter::add_sunlight(Pattern pattern, const SurfaceBatch& surface, const Samples& samples,
                               VectorLanes& light) {
  look(pattern, samples, surface.count);
  to_sun(s_.lighting.sun_direction, s_.lighting.sun_radius, disc_x_, disc_y_, surface.count,
         towards_);
  Lanes<float> cosines;
  products(surface.normal, towards_, surface.count, cosines);
  send(surface, [&](std::size_t lane) { return cosines[lane] > 0; });
  s_.scene.rays().unblocked(light_rays_, Coherence::similar, free_);
  const LaneVector sun = lane_vector(s_.lighting.sun);
  for (std::size_t r = 0; r < light_rays_.count; ++r) {
    const std::size_t i = asked_for_.lanes[r];
    set_lane(light, i, lane_of(light, i) + (cosines[i] * free_[r]) * sun);
  }
}

// Of each surface one direction of the sky, as likely as its light counts.
void TilePainter::look_at_sky(Pattern pattern, const SurfaceBatch& surface,
                              const Samples& samples) {
  look(pattern, samples, surface.count);
  to_sky(surface.normal, disc_x_, disc_y_, surface.count, towards_);
}

// All of the sky's light, which has no noise, less what is hidden, where that is asked for. What
// hides it sends back the part `returned`.
void TilePainter::add_skylight(Pattern pattern, const SurfaceBatch& surface, const Samples& samples,
                               float returned, VectorLanes& light) {
  add_mean_sky(s_.lighting, surface, light);
  if (s_.quality.sky == SkyLight::open) return;
  look_at_sky(pattern, surface, samples);
  send(surface, [&](std::size_t lane) { return asking_[samples.place[lane]]; });
  s_.scene.rays().unblocked(light_rays_, Coherence::mixed, free_);
  for (std::size_t r = 0; r < light_rays_.count; ++r)
    if (free_[r] == 0)
      add_to(light, asked_for_.lanes[r],
             s_.lighting.sky(light_rays_.direction.at(r)) * (returned - 1));
}

// Instead of hidden sky, the light that the hiding surface itself receives and returns.
void TilePainter::add_bounced_skylight(VectorLanes& light) {
  add_mean_sky(s_.lighting, seen_, light);
  look_at_sky(Pattern::sky, seen_, seen_samples_);
  send(seen_, [](std::size_t) { return true; });
  s_.scene.rays().first_hits(light_rays_, Coherence::mixed, hits_);
  bounce_.count = 0;
  bounce_of_.count = 0;
  for (const Body body : {Body::ribbon, Body::obstacle}) {
    LaneList& hit = body == Body::ribbon ? on_ribbon_ : on_obstacle_;
    hit.count = 0;
    for (std::size_t i = 0; i < seen_.count; ++i) hit.add_if(i, hits_.body[i] == body);
    bounce_samples_.set(bounce_.count, seen_samples_, hit);
    s_.scene.add_points(body, light_rays_, hits_, hit, bounce_);
    for (std::size_t i = 0; i < hit.count; ++i) bounce_of_.add_if(hit.lanes[i], true);
  }
  for (std::size_t i = 0; i < bounce_.count; ++i) {
    const std::size_t to = bounce_of_.lanes[i];
    add_to(light, to, -s_.lighting.sky(light_rays_.direction.at(to)));
  }
  VectorLanes received;
  clear(received, bounce_.count);
  add_sunlight(Pattern::sun_on_bounce, bounce_, bounce_samples_, received);
  add_skylight(Pattern::sky_on_bounce, bounce_, bounce_samples_, 0, received);
  for (std::size_t i = 0; i < bounce_.count; ++i)
    add_to(light, bounce_of_.lanes[i], received.at(i).array() * bounce_.albedo.at(i).array());
}

void TilePainter::add_up() {
  VectorLanes direct;
  VectorLanes shown;
  Lanes<float> squared_light;
  const bool smooth = s_.quality.smooth_sky;
  const LaneVector even_sky = lane_vector(Color::Constant(0.5F));
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < seen_.count; ++i) {
      const LaneVector albedo = lane_of(seen_.albedo, i);
      const LaneVector returned = albedo * lane_of(sunlight_, i);
      // What smoothing takes away is no noise that takes samples.
      const LaneVector sky = smooth ? even_sky : lane_of(skylight_, i);
      const LaneVector all = returned + albedo * sky;
      set_lane(direct, i, returned);
      set_lane(shown, i, all);
      squared_light[i] = luminance(all) * luminance(all);
    }
  });
  // The samples of a pixel that saw the same body lie side by side.
  for (std::size_t begin = 0, end = 0; begin < seen_.count; begin = end) {
    const std::uint16_t place = seen_samples_.place[begin];
    const Body body = seen_.body[begin];
    while (end < seen_.count && seen_samples_.place[end] == place && seen_.body[end] == body) ++end;
    PixelSums& sums = sums_[place];
    const auto samples = static_cast<float>(end - begin);
    sums.shown += sum_of(shown, begin, end);
    sums.shown[3] += samples;
    for (std::size_t i = begin; i < end; ++i) sums.position[3] += squared_light[i];
    if (!s_.quality.smooth_sky) continue;
    samples_of_body(body, sums) += samples;
    if (asking_[place]) {
      sums.sky += sum_of(skylight_, begin, end);
      sums.normal[3] += samples;
    }
    sums.direct += sum_of(direct, begin, end);
    sums.albedo += sum_of(seen_.albedo, begin, end);
    sums.normal += sum_of(seen_.normal, begin, end);
    sums.position += sum_of(seen_.position, begin, end);
  }
}

}  // namespace ribbon

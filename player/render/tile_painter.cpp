#include "player/render/tile_painter.h"

#include <algorithm>

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"
#include "player/render/light_directions.h"
#include "player/render/light_lanes.h"

namespace ribbon {

namespace {

// Pixels of a tile are gone through in small blocks, whose rays travel together: pixel `number` of
// that order has this place in the tile.
[[gnu::always_inline]] constexpr std::uint32_t place_in_blocks(std::uint32_t number) {
  static_assert(tile_side == 16, "four blocks of four");
  const std::uint32_t column = (number & 3U) | (number >> 2U & 12U);
  const std::uint32_t row = (number >> 2U & 3U) | (number >> 4U & 12U);
  return row * tile_side + column;
}

// Light from all sides mixes what it comes from: a pattern there would only be noise.
constexpr float bounce_spread = 0.5F;

Eigen::Array4f four(const Color& color) {
  return {color[0], color[1], color[2], 0};
}

void copy(const VectorLanes& from, std::size_t count, VectorLanes& to) {
  std::copy_n(from.x.begin(), count, to.x.begin());
  std::copy_n(from.y.begin(), count, to.y.begin());
  std::copy_n(from.z.begin(), count, to.z.begin());
}

Color full_light_on_ground(const Lighting& lighting) {
  return lighting.sun * std::max(0.0F, lighting.sun_direction.y()) +
         lighting.mean_sky(Eigen::Vector3f::UnitY());
}

}  // namespace

void TilePainter::Samples::set(std::size_t first, const Samples& others, const MarkedLanes& list) {
  move_together(others.place, list, &place[first]);
  move_together(others.number, list, &number[first]);
}

TilePainter::TilePainter(const Setting& setting) : sums_(setting.quality), s_(setting) {
  rays_.spread = s_.rays.spread();
  light_rays_.spread = bounce_spread;
}

void TilePainter::paint(int left, int top) {
  left_ = left;
  top_ = top;
  width_ = std::min(tile_side, s_.size.width - left);
  height_ = std::min(tile_side, s_.size.height - top);
  sums_.clear();
  const bool whole = width_ == tile_side && height_ == tile_side;
  // Bit after bit takes longer than all at once.
  if (whole)
    wanting_.set();
  else
    wanting_.reset();
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column) {
      const std::size_t place = place_in_tile(column, row);
      backdrop_[place] = four(s_.backdrop.at(left_ + column, top_ + row));
      if (!whole) wanting_.set(place);
    }
  if (!s_.quality.is_adaptive()) {
    sample_evenly(0, s_.quality.samples);
    return;
  }
  noise_.begin(width_, height_);
  const int first = s_.quality.first_samples();
  sample_evenly(0, first);
  sums_.surfaces_are_known();
  noise_.update(sums_.shown(), sums_.squared_light());
  sample_evenly(first, first);
  noise_.update(sums_.shown(), sums_.squared_light());
  for (wanting_ = worth_more(); wanting_.any(); wanting_ = worth_more()) {
    sample_wanting(first);
    noise_.update(sums_.shown(), sums_.squared_light());
  }
}

// The pixels that are to get twice the samples that they have.
std::bitset<tile_pixels> TilePainter::worth_more() const {
  const Quality& quality = s_.quality;
  if (quality.least_gain > 0)
    return noise_.worth_doubling(quality.least_gain, quality.most_samples);
  if (noise_.error() <= quality.noise) return {};
  return noise_.most_worth_doubling(quality.most_samples);
}

// All pixels, which have `taken` samples, get `more`.
void TilePainter::sample_evenly(int taken, int more) {
  const auto each = static_cast<std::uint32_t>(more);
  if (wanting_.all() && register_lanes % each == 0)
    sample_whole_tile(static_cast<std::uint32_t>(taken), each);
  else
    sample_wanting(more);
}

// Each register holds all new samples of some pixels.
void TilePainter::sample_whole_tile(std::uint32_t taken, std::uint32_t each) {
  const std::uint32_t pixels_at_once = register_lanes / each;
  std::array<std::uint32_t, register_lanes> pixels;  // from the register's first pixel
  std::array<std::uint32_t, register_lanes> numbers;
  std::array<float, register_lanes> offsets_x;
  std::array<float, register_lanes> offsets_y;
  for (std::uint32_t lane = 0; lane < register_lanes; ++lane) {
    pixels[lane] = lane / each;
    numbers[lane] = taken + lane % each;
    offsets_x[lane] = s_.rays.offset(numbers[lane]).x();
    offsets_y[lane] = s_.rays.offset(numbers[lane]).y();
  }
  asking_.fill(true);
  const auto pixels_a_batch = static_cast<std::uint32_t>(batch_size / each);
  for (std::uint32_t begin = 0; begin < tile_pixels; begin += pixels_a_batch) {
    vectorised([&]() RIBBON_INLINED {
      const auto left = static_cast<float>(left_);
      const auto top = static_cast<float>(top_);
      std::uint32_t first_pixel = begin;
      for (std::size_t first = 0; first < batch_size; first += register_lanes) {
        float* const place_x = &place_x_[first];
        float* const place_y = &place_y_[first];
        std::uint32_t* const places = &samples_.place[first];
        std::uint32_t* const sample_numbers = &samples_.number[first];
        RIBBON_EACH_LANE
        RIBBON_EACH_LANE_OF_A_FEW
        for (std::size_t lane = 0; lane < register_lanes; ++lane) {
          const std::uint32_t place = place_in_blocks(first_pixel + pixels[lane]);
          const auto column = static_cast<float>(static_cast<int>(place % tile_side));
          const auto row = static_cast<float>(static_cast<int>(place / tile_side));
          place_x[lane] = offsets_x[lane] + (left + column);
          place_y[lane] = offsets_y[lane] + (top + row);
          places[lane] = place;
          sample_numbers[lane] = numbers[lane];
        }
        first_pixel += pixels_at_once;
      }
    });
    sample_count_ = batch_size;
    finish_batch();
  }
}

void TilePainter::sample_wanting(int first_samples) {
  for (std::uint32_t number = 0; number < tile_pixels; ++number) {
    const std::size_t place = place_in_blocks(number);
    if (wanting_[place]) sample_again(place, first_samples);
  }
  finish_batch();
}

// Its first samples, or as many again.
void TilePainter::sample_again(std::size_t place, int first_samples) {
  const float samples = sums_.shown()[place][3];
  const auto taken = static_cast<std::uint32_t>(samples);
  const std::uint32_t end = taken == 0 ? static_cast<std::uint32_t>(first_samples) : 2 * taken;
  // Smoothing does the rest where there is a surface to smooth.
  asking_[place] = !s_.quality.smooth_sky || samples < static_cast<float>(s_.quality.samples) ||
                   !sums_.surface(place).saw_one_surface(samples);
  const auto x = static_cast<float>(left_ + static_cast<int>(place % tile_side));
  const auto y = static_cast<float>(top_ + static_cast<int>(place / tile_side));
  for (std::uint32_t number = taken; number < end;) {
    const std::size_t room = batch_size - sample_count_;
    const std::size_t count = std::min<std::size_t>(end - number, room);
    float* const place_x = &place_x_[sample_count_];
    float* const place_y = &place_y_[sample_count_];
    std::uint32_t* const places = &samples_.place[sample_count_];
    std::uint32_t* const numbers = &samples_.number[sample_count_];
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector2f& offset = s_.rays.offset(number + i);
      place_x[i] = offset.x() + x;
      place_y[i] = offset.y() + y;
      places[i] = static_cast<std::uint32_t>(place);
      numbers[i] = number + static_cast<std::uint32_t>(i);
    }
    number += static_cast<std::uint32_t>(count);
    sample_count_ += count;
    if (sample_count_ == batch_size) finish_batch();
  }
}

void TilePainter::finish_batch() {
  s_.rays.look(place_x_, place_y_, sample_count_, rays_);
  sample_count_ = 0;
  s_.scene.rays().first_hits(rays_, Coherence::similar, hits_);
  sort_hits();
  find_sunlight(Pattern::sun, seen_, seen_samples_, sunlight_);
  clear(skylight_, seen_.count);
  if (s_.quality.sky == SkyLight::bounced)
    add_bounced_skylight(skylight_);
  else
    add_skylight(Pattern::sky, seen_, seen_samples_, s_.lighting.bounce, skylight_);
  sums_.add({seen_, seen_samples_.place, sunlight_, skylight_, asking_});
}

// The samples that see the backdrop are done; the others' surfaces are laid side by side, body by
// body.
void TilePainter::sort_hits() {
  list_marked(hits_.body, Body::ribbon, rays_.count, on_ribbon_);
  list_marked(hits_.body, Body::obstacle, rays_.count, on_obstacle_);
  list_marked(hits_.body, Body::none, rays_.count, on_nothing_);
  seen_.count = 0;
  seen_samples_.set(0, samples_, on_ribbon_);
  s_.scene.add_points(Body::ribbon, rays_, hits_, on_ribbon_, seen_);
  seen_samples_.set(seen_.count, samples_, on_obstacle_);
  s_.scene.add_points(Body::obstacle, rays_, hits_, on_obstacle_, seen_);
  const bool has_ground = s_.scene.has_ground();
  for (std::size_t i = 0; i < on_nothing_.count; ++i) {
    const std::size_t lane = on_nothing_.lanes[i];
    if (has_ground && add_ground(lane)) continue;
    const std::size_t place = samples_.place[lane];
    sums_.add_backdrop(place, backdrop_[place]);
  }
}

// Whether a sample that met nothing sees the ground.
bool TilePainter::add_ground(std::size_t lane) {
  const std::size_t to = seen_.count;
  if (!s_.scene.add_ground(rays_, lane, seen_)) return false;
  seen_samples_.place[to] = samples_.place[lane];
  seen_samples_.number[to] = samples_.number[lane];
  // In full light the floor cannot be told from the backdrop.
  const Color backdrop = backdrop_[samples_.place[lane]].head<3>();
  seen_.albedo.set(to, (backdrop / full_light_on_ground(s_.lighting)).matrix());
  return true;
}

// Where the samples of a pattern look, as points of the unit disc. Each pixel has patterns of its
// own.
void TilePainter::look(Pattern pattern, const Samples& samples, std::size_t count) {
  Lanes<std::uint32_t> pixels;
  vectorised([&]() RIBBON_INLINED {
    const auto first = static_cast<std::uint32_t>(top_ * s_.size.width + left_);
    const auto width = static_cast<std::uint32_t>(s_.size.width);
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i)
      pixels[i] = first + samples.place[i] / tile_side * width + samples.place[i] % tile_side;
  });
  Lanes<float> u;
  Lanes<float> v;
  s_.patterns.points(pattern, pixels, samples.number, count, u, v);
  to_disc(u, v, count, disc_x_, disc_y_);
}

// Lays out the rays that go from the surfaces that are marked by 1 towards_ a light.
void TilePainter::send(const SurfaceBatch& surface, const Lanes<std::uint8_t>& wanted) {
  list_marked(wanted.data(), 1, surface.count, asked_for_);
  const std::size_t count = asked_for_.count;
  light_rays_.count = count;
  if (count == surface.count) {
    copy(surface.start, count, light_rays_.origin);
    copy(towards_, count, light_rays_.direction);
    return;
  }
  move_together(surface.start, asked_for_, light_rays_.origin);
  move_together(towards_, asked_for_, light_rays_.direction);
}

// Of each surface 1 where it sent a ray that is free_, else 0; valid until the next call.
const Lanes<float>& TilePainter::of_surfaces(std::size_t count) {
  if (light_rays_.count == count) return free_;
  move_apart(free_, asked_for_, free_of_surfaces_);
  return free_of_surfaces_;
}

// Light that the sun sends to each surface, as white cloth would show it.
void TilePainter::find_sunlight(Pattern pattern, const SurfaceBatch& surface,
                                const Samples& samples, VectorLanes& light) {
  look(pattern, samples, surface.count);
  to_sun(s_.lighting.sun_direction, s_.lighting.sun_radius, disc_x_, disc_y_, surface.count,
         towards_);
  Lanes<float> cosines;
  products(surface.normal, towards_, surface.count, cosines);
  Lanes<std::uint8_t> wanted;
  vectorised([&]() RIBBON_INLINED {
    // Bytes that are stored may lie anywhere, as compilers see it.
    const float* const cosine = cosines.data();
    std::uint8_t* const marks = wanted.data();
    const std::size_t end = filled_up(surface.count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) marks[i] = cosine[i] > 0 ? 1 : 0;
  });
  send(surface, wanted);
  s_.scene.rays().unblocked(light_rays_, Coherence::similar, free_);
  const float* const arrives = of_surfaces(surface.count).data();
  const LaneVector sun = lane_vector(s_.lighting.sun);
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(surface.count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      const float facing = cosines[i] > 0 ? cosines[i] : 0.0F;
      set_lane(light, i, facing * arrives[i] * sun);
    }
  });
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
  add_mean_sky(s_.lighting, surface.normal, surface.count, light);
  if (s_.quality.sky == SkyLight::open) return;
  look_at_sky(pattern, surface, samples);
  Lanes<std::uint8_t> wanted;
  for (std::size_t i = 0; i < surface.count; ++i) wanted[i] = asking_[samples.place[i]] ? 1 : 0;
  send(surface, wanted);
  s_.scene.rays().unblocked(light_rays_, Coherence::mixed, free_);
  const float* const arrives = of_surfaces(surface.count).data();
  Lanes<float> shares;
  vectorised([&]() RIBBON_INLINED {
    const std::uint8_t* const asked = wanted.data();
    float* const share = shares.data();
    const std::size_t end = filled_up(surface.count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i)
      share[i] = (static_cast<float>(asked[i]) - arrives[i]) * (returned - 1);
  });
  add_sky_shares(s_.lighting, shares, towards_, surface.count, light);
}

// Instead of hidden sky, the light that the hiding surface itself receives and returns.
void TilePainter::add_bounced_skylight(VectorLanes& light) {
  add_mean_sky(s_.lighting, seen_.normal, seen_.count, light);
  look_at_sky(Pattern::sky, seen_, seen_samples_);
  Lanes<std::uint8_t> wanted;
  std::fill_n(wanted.begin(), seen_.count, std::uint8_t{1});
  send(seen_, wanted);
  s_.scene.rays().first_hits(light_rays_, Coherence::mixed, hits_);
  bounce_.count = 0;
  bounce_of_.count = 0;
  for (const Body body : {Body::ribbon, Body::obstacle}) {
    MarkedLanes& hit = body == Body::ribbon ? on_ribbon_ : on_obstacle_;
    list_marked(hits_.body, body, seen_.count, hit);
    bounce_samples_.set(bounce_.count, seen_samples_, hit);
    s_.scene.add_points(body, light_rays_, hits_, hit, bounce_);
    for (std::size_t i = 0; i < hit.count; ++i) bounce_of_.add_if(hit.lanes[i], true);
  }
  Lanes<float> shares;
  std::fill_n(shares.begin(), seen_.count, 0.0F);
  for (std::size_t i = 0; i < bounce_.count; ++i) shares[bounce_of_.lanes[i]] = -1;
  add_sky_shares(s_.lighting, shares, light_rays_.direction, seen_.count, light);
  VectorLanes received;
  find_sunlight(Pattern::sun_on_bounce, bounce_, bounce_samples_, received);
  add_skylight(Pattern::sky_on_bounce, bounce_, bounce_samples_, 0, received);
  for (std::size_t i = 0; i < bounce_.count; ++i)
    add_to(light, bounce_of_.lanes[i], received.at(i).array() * bounce_.albedo.at(i).array());
}

}  // namespace ribbon

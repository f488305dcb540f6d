#include "player/measure/value_colors.h"

#include <algorithm>
#include <cmath>

#include "player/picture/round_ticks.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// What is near shows where all is dark that is far.
ColorMap map_for(Quantity quantity) {
  if (quantity == Quantity::contact) return diverging_map();
  return quantity == Quantity::gap ? sequential_map().reversed() : sequential_map();
}

double largest(const std::vector<float>& values) {
  double most = 0;
  for (const float value : values)
    if (std::isfinite(value)) most = std::max(most, static_cast<double>(value));
  return most;
}

Result<double> largest_in(RecordingReader& reader, Quantity quantity,
                          const std::vector<int>& frames) {
  ParticleMeasure measure(reader, quantity, 0);
  Eigen::Matrix3Xf positions;
  double most = 0;
  for (const int index : frames) {
    if (auto read = reader.read(index, positions); !read) return tl::unexpected(read.error());
    most = std::max(most, largest(measure.values(index, positions)));
  }
  return most;
}

// Of the distance of the nearest particles. Layers rest at about a fifth of it; with this, as many
// rows touch as the simulation counts, which asks all features and not only the particles.
constexpr double touching = 0.4;

Result<double> automatic_end(RecordingReader& reader, Quantity quantity,
                             const std::vector<int>& frames) {
  const RecordingHeader& header = reader.header();
  if (quantity == Quantity::gap) return header.ribbon_width_m / 10;
  if (quantity == Quantity::contact) return touching * rest_size(header).shortest_edge_m();
  return largest_in(reader, quantity, frames);
}

}  // namespace

Result<ValueColors> ValueColors::create(RecordingReader& reader, Quantity quantity,
                                        const std::optional<ValueRange>& chosen,
                                        const std::vector<int>& frames) {
  if (chosen) return ValueColors(reader, quantity, *chosen, true);
  const auto end = automatic_end(reader, quantity, frames);
  if (!end) return tl::unexpected(end.error());
  // Where nothing is strained or moves, all is 0 of 1.
  const double high = *end > 0 ? notation(quantity).factor * *end : 1;
  return ValueColors(reader, quantity, {0, high}, false);
}

ValueColors::ValueColors(RecordingReader& reader, Quantity quantity, const ValueRange& range,
                         bool chosen)
    : quantity_(quantity),
      range_(range),
      is_chosen_(chosen),
      map_(map_for(quantity)),
      measure_(reader, quantity, range.high / notation(quantity).factor) {}

float ValueColors::place(double value) const {
  return static_cast<float>(
      std::clamp((value - range_.low) / (range_.high - range_.low), 0.0, 1.0));
}

std::vector<float> ValueColors::places(int index, const Eigen::Matrix3Xf& positions) {
  std::vector<float> values = measure_.values(index, positions);
  if (quantity_ == Quantity::contact) return values;
  const double factor = notation(quantity_).factor;
  for (float& value : values) value = place(factor * value);
  return values;
}

Legend ValueColors::legend() const {
  const QuantityNotation told = notation(quantity_);
  const std::string high = short_number(range_.high, 3);
  if (quantity_ == Quantity::contact)
    return {filled_in("nearer than {} {}: touches", high, told.unit),
            map_,
            {{ParticleMeasure::touches_obstacle, "obstacle"},
             {ParticleMeasure::touches_nothing, "nothing"},
             {ParticleMeasure::touches_ribbon, "ribbon"}},
            true};
  // What lies beyond a range that was not measured has the colour of its end.
  const bool more_above = is_chosen_ || quantity_ == Quantity::gap;
  const std::string below = is_chosen_ && range_.low > 0 ? "≤ " : "";
  Legend legend{filled_in("{}, {}", told.title, told.unit), map_, {}};
  legend.marks.push_back({0, below + short_number(range_.low, 3)});
  const Ticks ticks = round_ticks(range_.low, range_.high, 6);
  for (const double value : ticks.values)
    if (place(value) > 0.15F && place(value) < 0.85F)
      legend.marks.push_back({place(value), ticks.text(value)});
  legend.marks.push_back({1, (more_above ? "≥ " : "") + high});
  return legend;
}

}  // namespace ribbon

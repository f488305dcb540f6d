#include "player/chart/time_charts.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "text/number_text.h"

namespace ribbon {

namespace {

using Frames = std::vector<std::optional<FrameNumbers>>;
using Value = std::function<std::optional<double>(const FrameNumbers&)>;

// A ribbon is tight whose progress lies in here; see the glossary.
constexpr double tight = 0.03;
// Single frames, as the first of a stage, may tell ten times the progress of a ribbon that is free.
constexpr double most_progress = 1.5;

Chart chart(std::string title, const Frames& frames, const Value& value) {
  Chart result;
  result.title = std::move(title);
  bool is_broken = true;
  for (const auto& frame : frames) {
    const auto told = frame ? value(*frame) : std::nullopt;
    const bool is_point = told && std::isfinite(*told) && std::isfinite(frame->time_s);
    if (is_point) {
      if (is_broken) result.lines.emplace_back();
      result.lines.back().emplace_back(frame->time_s, *told);
    }
    is_broken = !is_point;
  }
  return result;
}

Chart count_chart(std::string title, const Frames& frames, std::uint32_t FrameNumbers::*number) {
  Chart result = chart(std::move(title), frames, [number](const FrameNumbers& numbers) {
    return static_cast<double>(numbers.*number);
  });
  result.counts = true;
  return result;
}

Chart tightness_chart(std::string title, const Frames& frames, float TightnessNumbers::*number,
                      double factor) {
  return chart(std::move(title), frames,
               [number, factor](const FrameNumbers& numbers) -> std::optional<double> {
                 if (!numbers.tightness) return std::nullopt;
                 return factor * static_cast<double>((*numbers.tightness).*number);
               });
}

// There is none while the ribbon does not touch itself.
Chart rope_length_chart(const Frames& frames) {
  return chart("rope length, widths", frames,
               [](const FrameNumbers& numbers) -> std::optional<double> {
                 if (!numbers.tightness || numbers.tightness->rope_length == 0) return std::nullopt;
                 return static_cast<double>(numbers.tightness->rope_length);
               });
}

Chart strain_chart(const RecordingHeader& header, const Frames& frames) {
  Chart result = chart("largest strain, %", frames,
                       [](const FrameNumbers& numbers) { return 100 * numbers.worst_strain; });
  const double limit = 100 * header.strain_limit;
  if (limit > 0) result.zone = {limit, limit, filled_in("limit {} %", short_number(limit, 3))};
  return result;
}

void add_tightness(const Frames& frames, std::vector<Chart>& charts) {
  const auto tells = [](const auto& frame) { return frame && frame->tightness; };
  if (std::none_of(frames.begin(), frames.end(), tells)) return;
  Chart progress = tightness_chart("progress, %", frames, &TightnessNumbers::progress, 100);
  progress.zone = {-100 * tight, 100 * tight, "tight"};
  progress.most_shown = 100 * most_progress;
  charts.push_back(std::move(progress));
  charts.push_back(tightness_chart("pull of the hands, %", frames, &TightnessNumbers::pull, 100));
  charts.push_back(tightness_chart("rows in contact, %", frames, &TightnessNumbers::contact, 100));
  charts.push_back(rope_length_chart(frames));
  charts.push_back(
      tightness_chart("truncated particles, %", frames, &TightnessNumbers::truncated, 100));
}

}  // namespace

std::vector<Chart> time_charts(const RecordingHeader& header, const Frames& frames) {
  std::vector<Chart> charts{strain_chart(header, frames)};
  add_tightness(frames, charts);
  charts.push_back(count_chart("penetrating edges", frames, &FrameNumbers::penetrating_edges));
  charts.push_back(count_chart("recovery iterations", frames, &FrameNumbers::recovery_iterations));
  return charts;
}

}  // namespace ribbon

#include "player/write_plot.h"

#include <algorithm>

#include "commandline/extension.h"
#include "files/files.h"
#include "player/chart/chart_page.h"
#include "player/picture/png_encoder.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// So that PNG is as sharp as print.
constexpr int png_scale = 2;

std::string subtitle(const RecordingInfo& info, std::size_t frames, std::size_t lost) {
  const RibbonGrid& grid = info.header.grid;
  std::string text = filled_in("{} × {} particles, {} {}", grid.across, grid.along, frames,
                               frames == 1 ? "frame" : "frames");
  if (lost > 0) text += filled_in(", the numbers of {} lost to damage", lost);
  if (info.outcome) text += " · " + outcome_text(*info.outcome);
  return text;
}

}  // namespace

Result<std::string> write_plot(const RecordingInfo& info, std::vector<int> frames,
                               const Options& options) {
  std::sort(frames.begin(), frames.end());
  std::vector<std::optional<FrameNumbers>> numbers;
  numbers.reserve(frames.size());
  for (const int index : frames) numbers.push_back(info.numbers[index]);
  const auto lost =
      static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), std::nullopt));
  const ChartDrawing page = chart_page(info.header.scene_name, subtitle(info, frames.size(), lost),
                                       time_charts(info.header, numbers));
  const bool is_svg = lower_case_extension(options.plot) == ".svg";
  return write_file(options.plot, is_svg ? svg_text(page) : png_bytes(painted(page, png_scale)),
                    options.replaceable.later())
      .map([&] { return "charts: " + options.plot.string(); });
}

}  // namespace ribbon

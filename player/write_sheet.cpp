#include "player/write_sheet.h"

#include <algorithm>
#include <utility>

#include "commandline/interrupt.h"
#include "commandline/progress.h"
#include "player/frame_painter.h"
#include "player/picture/contact_sheet.h"
#include "player/picture/png_encoder.h"
#include "player/view/camera_work.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr int usual_columns = 5;
constexpr int most_columns = 12;

// All that the user named, where there is room for them. Of a ribbon that is fastened in stages:
// its start, how each of them ended, and its end.
std::vector<int> frames_to_show(const std::vector<int>& frames, const RecordingInfo& info,
                                bool are_named) {
  if (are_named && frames.size() <= most_columns) return frames;
  std::vector<int> ends;
  for (const StageFrames& stage : info.stages()) ends.push_back(stage.last - 1);
  const bool all_are_wanted = std::ranges::all_of(
      ends, [&](int end) { return std::ranges::find(frames, end) != frames.end(); });
  if (ends.empty() || !all_are_wanted) return spread_frames(frames, usual_columns);
  const int first = std::ranges::min(frames);
  if (first < ends.front()) ends.insert(ends.begin(), first);
  const int last = std::ranges::max(frames);
  if (last > ends.back() + 1) ends.push_back(last);
  return spread_frames(ends, most_columns);
}

// The whole and the knot, or what the user wants to see.
std::vector<Shot> shots_to_show(const Options& options) {
  if (options.views.empty()) return {{three_quarter_view, sheet_cell}, {knot_view, sheet_cell}};
  std::vector<Shot> shots;
  for (const NamedView& view : options.views) shots.push_back({view.view, sheet_cell});
  return shots;
}

}  // namespace

Result<std::string> write_sheet(RecordingReader& reader, const RecordingInfo& info,
                                const std::vector<int>& frames, const Options& options) {
  const std::vector<Shot> shots = shots_to_show(options);
  const std::vector<int> shown = frames_to_show(frames, info, !options.frames.empty());
  const CameraWork cameras(reader, shots);
  auto painter = FramePainter::create(reader, options, frames);
  if (!painter) return tl::unexpected(painter.error());
  painter->set_lowest(cameras.lowest_m());
  std::vector<SheetColumn> columns;
  ProgressLine progress("frame", static_cast<int>(shown.size()), options.progress);
  const Interrupt interrupt;
  for (const int index : shown) {
    if (interrupt.requested())
      return passing_failure("", filled_in("interrupted before frame {}", index + 1),
                             "run it again");
    if (auto loaded = painter->show(index); !loaded) return tl::unexpected(loaded.error());
    SheetColumn column{index + 1, reader.numbers(index).value_or(FrameNumbers{}), {}};
    column.stage = stage_name(reader.header(), column.numbers);
    for (std::size_t shot = 0; shot < shots.size(); ++shot) {
      auto picture = painter->picture(cameras.camera(shot, {index}), sheet_cell);
      if (!picture) return tl::unexpected(picture.error());
      column.views.push_back(*std::move(picture));
    }
    columns.push_back(std::move(column));
    progress.update(static_cast<int>(columns.size()));
  }
  progress.end();
  const RecordingHeader& header = reader.header();
  std::string ribbon = filled_in("{} × {} particles, {} frames recorded", header.grid.across,
                                 header.grid.along, reader.frame_count());
  if (info.outcome) ribbon += " · " + outcome_text(*info.outcome);
  const Picture sheet = contact_sheet(header.scene_name, ribbon, columns, painter->legend());
  return write_png(options.sheet, sheet, options.replaceable.later()).map([&] {
    return filled_in("contact sheet: {}, {} of {} frames", options.sheet.string(), shown.size(),
                     frames.size());
  });
}

}  // namespace ribbon

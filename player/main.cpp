// ribbon-play: renders a recording into pictures, or tells what it holds.
#include <chrono>
#include <cstdio>

#include "commandline/frame_pattern.h"
#include "commandline/frame_range.h"
#include "commandline/interrupt.h"
#include "commandline/progress.h"
#include "commandline/tool.h"
#include "contact_sheet.h"
#include "files/files.h"
#include "film.h"
#include "info.h"
#include "options.h"
#include "parallel/parallel.h"
#include "png_encoder.h"

namespace ribbon {

namespace {

constexpr int sheet_columns = 6;

Result<void> write_png(const std::filesystem::path& path, const Picture& picture) {
  return write_file(path, png_bytes(picture));
}

Result<void> write_pictures(RecordingReader& reader, const std::vector<int>& frames,
                            const FramePattern& pattern, const Options& options) {
  const auto cameras = place_cameras(reader, {{three_quarter_view, options.size}});
  if (!cameras) return tl::unexpected(cameras.error());
  Film film(reader, options.samples);
  ProgressLine progress("picture", static_cast<int>(frames.size()), options.quiet);
  const Interrupt interrupt;
  const auto start = std::chrono::steady_clock::now();
  int done = 0;
  for (const int index : frames) {
    if (interrupt.requested())
      return failure("", "interrupted before frame " + std::to_string(index + 1),
                     "run it again with --frames to go on");
    if (auto shown = film.show(index); !shown) return shown;
    const Picture picture = film.picture(cameras->front(), options.size);
    if (auto written = write_png(pattern.file(index + 1), picture); !written) return written;
    progress.update(++done);
  }
  progress.clear();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (!options.quiet)
    std::printf("%d pictures, %.2f s each: %s\n", done, elapsed.count() / done,
                pattern.file(frames.front() + 1).c_str());
  return {};
}

Result<void> write_sheet(RecordingReader& reader, const std::vector<int>& frames,
                         const Options& options) {
  const auto cameras =
      place_cameras(reader, {{three_quarter_view, sheet_cell}, {top_view, sheet_cell}});
  if (!cameras) return tl::unexpected(cameras.error());
  Film film(reader, options.samples);
  std::vector<SheetColumn> columns;
  for (const int index : spread_frames(frames, sheet_columns)) {
    if (auto shown = film.show(index); !shown) return shown;
    SheetColumn column{index + 1, reader.numbers(index).value_or(FrameNumbers{}), {}};
    for (const Camera& camera : *cameras) column.views.push_back(film.picture(camera, sheet_cell));
    columns.push_back(std::move(column));
  }
  const RecordingHeader& header = reader.header();
  const std::string ribbon = std::to_string(header.grid.across) + " × " +
                             std::to_string(header.grid.along) + " particles, " +
                             std::to_string(reader.frame_count()) + " frames recorded";
  auto written = write_png(options.sheet, contact_sheet(header.scene_name, ribbon, columns));
  if (written && !options.quiet) std::printf("contact sheet: %s\n", options.sheet.c_str());
  return written;
}

// Splits off what cannot be read and tells the user about it.
std::vector<int> readable_frames(const RecordingReader& reader, const std::vector<int>& frames) {
  std::vector<int> readable;
  std::vector<int> lost;
  for (const int index : frames) {
    if (reader.readable(index))
      readable.push_back(index);
    else
      lost.push_back(index + 1);
  }
  if (!lost.empty())
    std::fprintf(stderr, "ribbon-play: lost to damage, not rendered: frames %s\n",
                 number_list(lost).c_str());
  return readable;
}

Result<ExitCode> render(RecordingReader& reader, const Options& options) {
  const auto frames = parse_frame_range(options.frames, reader.frame_count());
  if (!frames) return tl::unexpected(frames.error());
  if (frames->empty())
    return failure(options.recording.string(), "holds no frames", "record some first");
  const std::vector<int> readable = readable_frames(reader, *frames);
  const bool complete = readable.size() == frames->size();
  if (readable.empty()) return ExitCode::answer_is_no;
  if (!options.pictures.empty()) {
    const auto pattern = FramePattern::parse(options.pictures);
    if (!pattern) return tl::unexpected(pattern.error());
    if (auto done = write_pictures(reader, readable, *pattern, options); !done)
      return tl::unexpected(done.error());
  }
  if (!options.sheet.empty())
    if (auto done = write_sheet(reader, readable, options); !done)
      return tl::unexpected(done.error());
  return complete ? ExitCode::done : ExitCode::answer_is_no;
}

Result<ExitCode> play(const Options& options) {
  set_thread_limit(options.threads);
  auto reader = RecordingReader::open(options.recording);
  if (!reader) return tl::unexpected(reader.error());
  if (options.info || options.json) {
    const RecordingInfo info = recording_info(options.recording, *reader);
    std::fputs((options.json ? info_json(info) : info_text(info)).c_str(), stdout);
    if (!info.missing.empty() || !info.damage.empty()) return ExitCode::answer_is_no;
  }
  if (options.pictures.empty() && options.sheet.empty()) return ExitCode::done;
  return render(*reader, options);
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("ribbon-play", [&]() -> ribbon::Result<ribbon::ExitCode> {
    const auto options = ribbon::parse_options(argc, argv);
    if (!options) return tl::unexpected(options.error());
    return *options ? ribbon::play(**options) : ribbon::ExitCode::done;
  });
}

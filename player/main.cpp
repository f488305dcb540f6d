// ribbon-play: renders a recording into pictures, tells what it holds, or verifies it.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "commandline/frame_pattern.h"
#include "commandline/frame_range.h"
#include "commandline/interrupt.h"
#include "commandline/progress.h"
#include "commandline/tool.h"
#include "files/files.h"
#include "parallel/parallel.h"
#include "player/options.h"
#include "player/picture/contact_sheet.h"
#include "player/picture/png_encoder.h"
#include "player/render/sequence_renderer.h"
#include "player/report/follow.h"
#include "player/report/info.h"
#include "player/report/verification_report.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr int sheet_columns = 5;

Result<void> write_png(const std::filesystem::path& path, const Picture& picture) {
  return write_file(path, png_bytes(picture));
}

// One line when all is done; JSON stays alone on standard output.
void tell(const Options& options, const std::string& summary) {
  if (!options.quiet && !options.json) std::printf("%s\n", summary.c_str());
}

Result<void> write_pictures(RecordingReader& reader, const std::vector<int>& frames,
                            const FramePattern& pattern, const Options& options) {
  const auto cameras = frame_cameras(reader, {{three_quarter_view, options.size}});
  SequenceRenderer renderer(reader, options.samples);
  ProgressLine progress("picture", static_cast<int>(frames.size()), options.quiet);
  const Interrupt interrupt;
  const auto start = std::chrono::steady_clock::now();
  int done = 0;
  for (const int index : frames) {
    if (interrupt.requested())
      return failure("", filled_in("interrupted before frame {}", index + 1),
                     "run it again with --frames to go on");
    if (auto shown = renderer.show(index); !shown) return shown;
    const Picture picture = renderer.picture(cameras.front(), options.size);
    if (auto written = write_png(pattern.file(index + 1), picture); !written) return written;
    progress.update(++done);
  }
  progress.clear();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  tell(options,
       filled_in("{} {}, {:.2f} s each, last: {}", done, done == 1 ? "picture" : "pictures",
                 elapsed.count() / done, pattern.file(frames.back() + 1).string()));
  return {};
}

Result<void> write_sheet(RecordingReader& reader, const RecordingInfo& info,
                         const std::vector<int>& frames, const Options& options) {
  const auto cameras =
      frame_cameras(reader, {{three_quarter_view, sheet_cell}, {top_view, sheet_cell}});
  SequenceRenderer renderer(reader, options.samples);
  std::vector<SheetColumn> columns;
  for (const int index : spread_frames(frames, sheet_columns)) {
    if (auto shown = renderer.show(index); !shown) return shown;
    SheetColumn column{index + 1, reader.numbers(index).value_or(FrameNumbers{}), {}};
    for (const Camera& camera : cameras)
      column.views.push_back(renderer.picture(camera, sheet_cell));
    columns.push_back(std::move(column));
  }
  const RecordingHeader& header = reader.header();
  std::string ribbon = filled_in("{} × {} particles, {} frames recorded", header.grid.across,
                                 header.grid.along, reader.frame_count());
  if (info.outcome) ribbon += " · " + outcome_text(*info.outcome);
  auto written = write_png(options.sheet, contact_sheet(header.scene_name, ribbon, columns));
  if (written) tell(options, "contact sheet: " + options.sheet.string());
  return written;
}

// Leaves out what is lost and tells the user about it.
std::vector<int> readable_frames(const RecordingInfo& info, const std::vector<int>& frames) {
  std::vector<int> readable;
  std::vector<int> lost;
  for (const int index : frames) {
    if (std::binary_search(info.missing.begin(), info.missing.end(), index + 1))
      lost.push_back(index + 1);
    else
      readable.push_back(index);
  }
  std::sort(lost.begin(), lost.end());
  if (!lost.empty())
    std::fprintf(stderr, "ribbon-play: %s: lost to damage and not rendered: frames %s\n",
                 info.file.c_str(), number_list(lost).c_str());
  return readable;
}

Result<ExitCode> render(RecordingReader& reader, const RecordingInfo& info,
                        const Options& options) {
  const auto frames = parse_frame_range(options.frames, info.frame_count());
  if (!frames) return tl::unexpected(frames.error());
  if (frames->empty()) return failure(info.file.string(), "holds no frames", "record some first");
  const auto pattern = FramePattern::parse(options.pictures, static_cast<int>(frames->size()));
  if (!options.pictures.empty() && !pattern) return tl::unexpected(pattern.error());
  const std::vector<int> readable = readable_frames(info, *frames);
  const ExitCode answer =
      readable.size() == frames->size() ? ExitCode::done : ExitCode::answer_is_no;
  if (readable.empty()) return answer;
  if (!options.pictures.empty())
    if (auto done = write_pictures(reader, readable, *pattern, options); !done)
      return tl::unexpected(done.error());
  if (!options.sheet.empty())
    if (auto done = write_sheet(reader, info, readable, options); !done)
      return tl::unexpected(done.error());
  return answer;
}

// Renders frames as they come, all with the camera that the first look finds.
class LivePictures {
 public:
  LivePictures(RecordingReader& reader, const Options& options, FramePattern pattern)
      : reader_(reader),
        options_(options),
        pattern_(std::move(pattern)),
        renderer_(reader, options.samples) {}

  Result<void> show(int index) {
    if (cameras_.empty()) cameras_ = frame_cameras(reader_, {{three_quarter_view, options_.size}});
    if (auto shown = renderer_.show(index); !shown) return shown;
    return write_png(pattern_.file(index + 1), renderer_.picture(cameras_.front(), options_.size));
  }

 private:
  RecordingReader& reader_;
  const Options& options_;
  FramePattern pattern_;
  SequenceRenderer renderer_;
  std::vector<Camera> cameras_;  // one, once there is a frame
};

Result<ExitCode> follow_recording(RecordingReader& reader, const Options& options) {
  std::optional<LivePictures> pictures;
  if (!options.pictures.empty()) {
    auto pattern = FramePattern::parse(options.pictures);
    if (!pattern) return tl::unexpected(pattern.error());
    pictures.emplace(reader, options, std::move(*pattern));
  }
  const Interrupt interrupt;
  const auto tell_frame = [&](int index) -> Result<void> {
    if (pictures)
      if (auto shown = pictures->show(index); !shown) return shown;
    if (options.quiet) return {};
    std::printf("%s\n", frame_line(index, reader.numbers(index).value_or(FrameNumbers{})).c_str());
    std::fflush(stdout);
    return {};
  };
  auto followed = follow(reader, {tell_frame, [&] { return interrupt.requested(); }});
  if (!followed) return tl::unexpected(followed.error());
  const RecordingInfo info = recording_info(options.recording, reader);
  if (options.info) std::fputs(info_text(info).c_str(), stdout);
  if (!info.missing.empty())
    std::fprintf(stderr, "ribbon-play: %s: lost to damage: frames %s\n", info.file.c_str(),
                 number_list(info.missing).c_str());
  return info.missing.empty() && info.damage.empty() ? ExitCode::done : ExitCode::answer_is_no;
}

// In ascending order, whatever the order asked for.
Result<std::vector<int>> frames_to_verify(const RecordingReader& reader, const Options& options) {
  auto frames = parse_frame_range(options.frames, reader.frame_count());
  if (!frames) return frames;
  if (frames->empty())
    return failure(options.recording.string(), "holds no frames", "record some first");
  std::sort(frames->begin(), frames->end());
  return frames;
}

Result<ExitCode> verify(RecordingReader& reader, const Options& options) {
  const auto frames = frames_to_verify(reader, options);
  if (!frames) return tl::unexpected(frames.error());
  ProgressLine progress("frame", frames->back() - frames->front() + 1, options.quiet);
  const Interrupt interrupt;
  const auto verification = verify_recording(reader, *frames, options.certify_every, [&](int done) {
    progress.update(done);
    return !interrupt.requested();
  });
  progress.clear();
  if (!verification) return tl::unexpected(verification.error());
  const std::string file = options.recording.string();
  std::fputs((options.json ? verification_json(file, *verification)
                           : verification_text(file, *verification))
                 .c_str(),
             stdout);
  return verification->complaints().empty() ? ExitCode::done : ExitCode::answer_is_no;
}

Result<ExitCode> play(const Options& options) {
  set_thread_limit(options.threads);
  auto reader = RecordingReader::open(options.recording);
  if (!reader) return tl::unexpected(reader.error());
  if (options.pictures.empty() && options.sheet.empty() && !options.info && !options.json &&
      !options.verify && !options.follow)
    return failure("", "nothing to do",
                   "ask for pictures (-o), a --sheet, --info, --follow or --verify");
  if (options.verify) return verify(*reader, options);
  if (options.follow) return follow_recording(*reader, options);
  const RecordingInfo info = recording_info(options.recording, *reader);
  if (options.info || options.json)
    std::fputs((options.json ? info_json(info) : info_text(info)).c_str(), stdout);
  if (!options.pictures.empty() || !options.sheet.empty()) return render(*reader, info, options);
  return info.missing.empty() && info.damage.empty() ? ExitCode::done : ExitCode::answer_is_no;
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

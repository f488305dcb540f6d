// ribbon-play: renders a recording into pictures, tells what it holds, or verifies it.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "commandline/frame_range.h"
#include "commandline/interrupt.h"
#include "commandline/progress.h"
#include "commandline/tool.h"
#include "parallel/instruction_set.h"
#include "parallel/parallel.h"
#include "playback/unfinished.h"
#include "player/bench.h"
#include "player/follow_recording.h"
#include "player/memory_forecast.h"
#include "player/options.h"
#include "player/output/existing_file.h"
#include "player/output/picture_format.h"
#include "player/page/page_options.h"
#include "player/page/write_page.h"
#include "player/places.h"
#include "player/report/info.h"
#include "player/report/verification_report.h"
#include "player/write_pictures.h"
#include "player/write_plot.h"
#include "player/write_sheet.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// One line when all is done; JSON and raw frames stay alone on standard output.
void tell(const Options& options, const std::string& summary) {
  if (!options.quiet && !options.json)
    std::fprintf(options.pictures == "-" ? stderr : stdout, "%s\n", summary.c_str());
}

// Those of the recording that are lost, as indices from 0; tells the user about those that were
// asked for.
std::vector<int> lost_frames(const RecordingInfo& info, const std::vector<int>& asked) {
  std::vector<int> lost;
  std::vector<int> told;
  for (const int number : info.missing) {
    lost.push_back(number - 1);
    if (std::find(asked.begin(), asked.end(), number - 1) != asked.end()) told.push_back(number);
  }
  if (!told.empty())
    std::fprintf(stderr, "ribbon-play: %s: lost to damage and not rendered: frames %s\n",
                 info.file.c_str(), number_list(told).c_str());
  return lost;
}

ExitCode intact(const RecordingInfo& info) {
  return info.missing.empty() && info.damage.empty() ? ExitCode::done : ExitCode::answer_is_no;
}

tl::unexpected<Error> holds_no_frames(const Options& options) {
  return failure(options.recording.string(), "holds no frames", "record some first");
}

// Neither pictures nor lines about frames show that more are still to come, or never will.
void tell_unfinished(const RecordingReader& reader, const Options& options) {
  const std::string unfinished = unfinished_text(reader);
  if (!unfinished.empty())
    std::fprintf(stderr, "ribbon-play: %s: %s\n", options.recording.c_str(), unfinished.c_str());
}

// What shows frames themselves: pictures and a sheet.
Result<ExitCode> render_frames(RecordingReader& reader, const RecordingInfo& info,
                               const std::vector<int>& frames, const Options& options) {
  const std::vector<int> lost = lost_frames(info, frames);
  const std::vector<int> readable = readable_frames(frames, lost);
  const ExitCode answer =
      readable.size() == frames.size() ? ExitCode::done : ExitCode::answer_is_no;
  if (readable.empty()) return answer;
  if (!options.pictures.empty()) {
    const auto done = write_pictures(reader, frames, lost, options);
    if (!done) return tl::unexpected(done.error());
    tell(options, *done);
  }
  if (!options.sheet.empty()) {
    const auto done = write_sheet(reader, info, readable, options);
    if (!done) return tl::unexpected(done.error());
    tell(options, *done);
  }
  return answer;
}

Result<ExitCode> render(RecordingReader& reader, const RecordingInfo& info,
                        const Options& options) {
  const auto frames = parse_frame_range(options.frames, info.frame_count());
  if (!frames) return tl::unexpected(frames.error());
  if (frames->empty()) return holds_no_frames(options);
  // Before hours are spent on pictures.
  for (const auto& file : {options.plot, options.sheet})
    if (auto free = check_place(file, options.replaceable); !free)
      return tl::unexpected(free.error());
  tell_unfinished(reader, options);
  Result<ExitCode> answer = intact(info);
  if (!options.pictures.empty() || !options.sheet.empty())
    answer = render_frames(reader, info, *frames, options);
  if (!answer || options.plot.empty()) return answer;
  // Last, so that it is not in the way of another try where pictures were refused or interrupted.
  const auto done = write_plot(info, *frames, options);
  if (!done) return tl::unexpected(done.error());
  tell(options, *done);
  return answer;
}

// It plays all of the recording, and is looked at as whoever opens it likes.
Result<ExitCode> render_page(RecordingReader& reader, const Options& options) {
  const auto free =
      check_single_name(options.pictures)
          .and_then([&] { return check_place(options.pictures, options.replaceable); })
          .and_then([&] { return check_page_options(options.given); });
  if (!free) return tl::unexpected(free.error());
  const RecordingInfo info = recording_info(options.recording, reader);
  const auto frames = parse_frame_range("", info.frame_count());
  if (!frames) return tl::unexpected(frames.error());
  if (frames->empty()) return holds_no_frames(options);
  tell_unfinished(reader, options);
  if (readable_frames(*frames, lost_frames(info, *frames)).empty()) return ExitCode::answer_is_no;
  const Interrupt interrupt;
  const auto done =
      write_page(reader, options.recording, options.pictures, options.replaceable.later(),
                 [&interrupt] { return interrupt.requested(); });
  if (!done) return tl::unexpected(done.error());
  tell(options, *done);
  return intact(info);
}

// In ascending order, whatever the order asked for.
Result<std::vector<int>> frames_to_verify(const RecordingReader& reader, const Options& options) {
  auto frames = parse_frame_range(options.frames, reader.frame_count());
  if (!frames) return frames;
  if (frames->empty()) return holds_no_frames(options);
  std::sort(frames->begin(), frames->end());
  return frames;
}

Result<VerificationOrder> order_of(const RecordingReader& reader, const Options& options) {
  auto frames = frames_to_verify(reader, options);
  if (!frames) return tl::unexpected(frames.error());
  VerificationOrder order{*std::move(frames), options.certify_every};
  if (options.between.first.empty()) return order;
  const auto shares = shares_of(reader.header().marks, options.between);
  if (!shares) return tl::unexpected(shares.error());
  order.between = *shares;
  return order;
}

Result<ExitCode> verify(RecordingReader& reader, const Options& options) {
  const auto order = order_of(reader, options);
  if (!order) return tl::unexpected(order.error());
  const int frames = order->frames.back() - order->frames.front() + 1;
  ProgressLine progress("frame", frames, options.progress);
  const Interrupt interrupt;
  const auto verification = verify_recording(reader, *order, [&](int done) {
    progress.update(done);
    return !interrupt.requested();
  });
  progress.end();
  if (!verification) return tl::unexpected(verification.error());
  const std::string file = options.recording.string();
  std::fputs((options.json ? verification_json(file, *verification)
                           : verification_text(file, *verification))
                 .c_str(),
             stdout);
  return verification->complaints().empty() ? ExitCode::done : ExitCode::answer_is_no;
}

Result<ExitCode> print_bench(RecordingReader& reader, const Options& options) {
  const auto table = bench(reader, options);
  if (!table) return tl::unexpected(table.error());
  std::fputs(table->c_str(), stdout);
  return ExitCode::done;
}

Result<void> pin_instruction_set(const std::string& isa) {
  if (isa.empty()) return {};
  const InstructionSet set = isa == "avx512" ? InstructionSet::avx512
                             : isa == "avx2" ? InstructionSet::avx2
                                             : InstructionSet::baseline;
  if (!is_available(set))
    return failure("--isa " + isa, "is not what this processor has", "pin one that all have");
  choose_instruction_set(set);
  return {};
}

Result<ExitCode> play(const Options& options) {
  set_thread_limit(options.threads);
  if (auto pinned = pin_instruction_set(options.isa); !pinned)
    return tl::unexpected(pinned.error());
  auto reader = RecordingReader::open(options.recording);
  if (!reader) return tl::unexpected(reader.error());
  if (options.pictures.empty() && options.sheet.empty() && options.plot.empty() && !options.info &&
      !options.json && !options.verify && !options.follow && !options.bench)
    return failure("", "nothing to do",
                   "ask for pictures (-o), a --sheet, a --plot, --info, --follow or --verify");
  if (options.verify) return verify(*reader, options);
  if (options.bench) return print_bench(*reader, options);
  if (is_page(options.pictures)) return render_page(*reader, options);
  if (options.follow) {
    auto followed = follow_recording(*reader, options);
    if (followed) tell_unfinished(*reader, options);
    return followed;
  }
  RecordingInfo info = recording_info(options.recording, *reader);
  info.memory_bytes = memory_forecast(info.header, options);
  if (options.info || options.json || !options.sheet.empty() || !options.plot.empty())
    info.outcome = outcome(*reader);
  if (options.info || options.json)
    std::fputs((options.json ? info_json(info) : info_text(info)).c_str(), stdout);
  if (!options.pictures.empty() || !options.sheet.empty() || !options.plot.empty())
    return render(*reader, info, options);
  return intact(info);
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("ribbon-play", [&]() -> ribbon::Result<ribbon::ExitCode> {
    const auto options = ribbon::parse_player_options(argc, argv);
    if (!options) return tl::unexpected(options.error());
    return *options ? ribbon::play(**options) : ribbon::ExitCode::done;
  });
}

#include "player/follow_recording.h"

#include <cstdio>
#include <optional>

#include "commandline/interrupt.h"
#include "player/report/follow.h"
#include "player/report/info.h"
#include "player/write_pictures.h"
#include "text/number_text.h"

namespace ribbon {

Result<ExitCode> follow_recording(RecordingReader& reader, const Options& options) {
  const Interrupt interrupt;
  std::optional<LivePictures> pictures;
  if (!options.pictures.empty()) {
    pictures.emplace(reader, options);
    if (auto begun = pictures->begin(interrupt); !begun) return tl::unexpected(begun.error());
  }
  // Raw frames stay alone on standard output.
  std::FILE* const told = options.pictures == "-" ? stderr : stdout;
  const auto tell_frame = [&](int index) -> Result<void> {
    if (pictures)
      if (auto shown = pictures->show(index); !shown) return shown;
    if (options.quiet) return {};
    std::fprintf(told, "%s\n",
                 frame_line(index, reader.numbers(index).value_or(FrameNumbers{})).c_str());
    std::fflush(told);
    return {};
  };
  const auto pass_lost = [&] { return pictures ? pictures->pass_lost() : Result<void>(); };
  auto followed = follow(reader, {tell_frame, pass_lost, [&] { return interrupt.requested(); }});
  if (!followed) return tl::unexpected(followed.error());
  if (pictures)
    if (auto finished = pictures->finish(interrupt); !finished)
      return tl::unexpected(finished.error());
  RecordingInfo info = recording_info(options.recording, reader);
  if (options.info) {
    info.outcome = outcome(reader);
    std::fputs(info_text(info).c_str(), stdout);
  }
  if (!info.missing.empty())
    std::fprintf(stderr, "ribbon-play: %s: lost to damage: frames %s\n", info.file.c_str(),
                 number_list(info.missing).c_str());
  return info.missing.empty() && info.damage.empty() ? ExitCode::done : ExitCode::answer_is_no;
}

}  // namespace ribbon

#include "converter/remarks.h"

#include <algorithm>
#include <cstdint>

#include "playback/unfinished.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

struct Penetrations {
  int frames = 0;
  int first = 0;  // from 1, as `worst`
  int worst = 0;
  std::uint32_t edges = 0;  // of the worst
};

Penetrations penetrations_in(const ConversionJob& job) {
  Penetrations found;
  for (const int index : job.frames) {
    const auto numbers = job.reader.numbers(index);
    if (!numbers || numbers->penetrating_edges == 0) continue;
    if (found.frames++ == 0) found.first = index + 1;
    if (numbers->penetrating_edges <= found.edges) continue;
    found.worst = index + 1;
    found.edges = numbers->penetrating_edges;
  }
  return found;
}

std::string penetrations_text(const Penetrations& found, std::size_t frames) {
  return filled_in(
      "the recording intersects, and so do the files: in {} of {} frames, first in frame {}, worst "
      "in "
      "frame {}, where {} {} triangles",
      found.frames, frames, found.first, found.worst, found.edges,
      found.edges == 1 ? "edge pierces" : "edges pierce");
}

}  // namespace

std::vector<std::string> remarks_on(const ConversionJob& job) {
  std::vector<std::string> remarks;
  // A table lists penetrations itself, and a recording keeps them; who states a gap has none.
  const bool promised =
      job.format != OutputFormat::numbers && job.format != OutputFormat::recording;
  if (promised && job.reader.header().stated_gap_m == 0)
    if (const Penetrations found = penetrations_in(job); found.frames > 0)
      remarks.push_back(penetrations_text(found, job.frames.size()));
  const int recorded = job.reader.frame_count();
  const bool last_is_asked =
      std::find(job.frames.begin(), job.frames.end(), recorded - 1) != job.frames.end();
  if (const std::string text = unfinished_text(job.reader); !text.empty() && last_is_asked)
    remarks.push_back("the recording is " + text);
  return remarks;
}

}  // namespace ribbon

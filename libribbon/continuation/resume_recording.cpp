#include "continuation/resume_recording.h"

#include <algorithm>
#include <set>
#include <utility>

#include "playback/frame_decoder.h"
#include "playback/recording_contents.h"
#include "playback/recording_start.h"
#include "recording/writer/recording_writer.h"

namespace ribbon {

namespace {

// What no index record tells about: normally the frames since the last one, after damage also
// those whose index record is lost.
Index not_indexed(RecordingContents& contents) {
  std::set<std::uint64_t> indexed;  // by offset
  for (const IndexLocation& location : contents.indices()) {
    const auto index = contents.read_index(location);
    if (!index) continue;
    for (const IndexedFrame& frame : index->frames) indexed.insert(frame.offset);
    for (const IndexedOther& other : index->others) indexed.insert(other.offset);
  }
  Index rest;
  for (std::uint32_t number = 0; number < contents.frames_before_end(); ++number) {
    const IndexedFrame* frame = contents.find(number);
    if (frame != nullptr && !indexed.contains(frame->offset)) rest.frames.push_back(*frame);
  }
  std::sort(rest.frames.begin(), rest.frames.end(),
            [](const IndexedFrame& a, const IndexedFrame& b) { return a.offset < b.offset; });
  for (const IndexedOther& other : contents.others())
    if (!indexed.contains(other.offset)) rest.others.push_back(other);
  return rest;
}

}  // namespace

Result<RecordingWriter> resume_recording(const std::filesystem::path& path) {
  // Read before it is opened for writing, so that what is no recording is told as such,
  if (auto opened = open_recording(path); !opened) return tl::unexpected(std::move(opened.error()));
  auto target = RecordFile::open(path);
  if (!target) return tl::unexpected(std::move(target.error()));
  // and again now that nobody else can write it, or put another file under its name.
  auto opened = open_recording(path);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  RecordingContents contents(*std::move(opened));
  contents.check();

  RecordedSoFar so_far{.header = contents.start().header,
                       .recording_id = contents.start().recording_id,
                       .frames = contents.frames_before_end(),
                       .indices = contents.indices(),
                       .not_indexed = not_indexed(contents),
                       .last = {}};
  FrameDecoder decoder(so_far.header);
  if (const auto reference = reference_of(so_far.frames))
    if (const QuantisedFrame* quantised = decoder.decode(contents, *reference))
      so_far.last = {*reference, *quantised};
  if (contents.file().has_failed())
    return failure(path.string(), "could not be read to its end, and nothing was changed",
                   "check the disk, or the network that it is reached by, and try again");
  if (auto cut = target->cut(contents.end()); !cut) return tl::unexpected(std::move(cut.error()));
  return RecordingWriter(std::move(*target), std::move(so_far));
}

}  // namespace ribbon

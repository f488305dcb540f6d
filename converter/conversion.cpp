#include "converter/conversion.h"

#include <utility>

#include "commandline/frame_range.h"
#include "converter/cached_animation.h"
#include "converter/export/model.h"
#include "converter/frame_sequence.h"
#include "converter/output_format.h"

namespace ribbon {

namespace {

Result<ConversionReport> convert_frames(const ConversionRequest& request, OutputFormat format,
                                        RecordingReader reader, const std::vector<int>& frames) {
  const auto model = model_of_recording(reader.header(), request.model);
  if (!model)
    return failure(request.recording.string(), model.error().problem, model.error().remedy);
  if (format == OutputFormat::pc2)
    return write_cached_animation(request, std::move(reader), *model, frames);
  return write_frame_sequence(request, format, std::move(reader), *model, frames);
}

}  // namespace

Result<ConversionReport> convert(const ConversionRequest& request) {
  const auto format = output_format(request.output);
  if (!format) return tl::unexpected(format.error());
  auto reader = RecordingReader::open(request.recording);
  if (!reader) return tl::unexpected(reader.error());
  const auto frames = parse_frame_range(request.frames, reader->frame_count());
  if (!frames) return tl::unexpected(frames.error());
  if (frames->empty())
    return failure(request.recording.string(), "holds no frames", "record it again");
  return convert_frames(request, *format, std::move(*reader), *frames);
}

}  // namespace ribbon

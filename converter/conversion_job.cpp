#include "converter/conversion_job.h"

#include <utility>

#include "commandline/frame_range.h"
#include "converter/format_abilities.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// A request for the obstacle alone is one for a single file, whatever the frames.
Result<std::vector<int>> asked_frames(const ConversionRequest& request,
                                      const RecordingReader& reader) {
  return parse_frame_range(request.frames, reader.frame_count())
      .and_then([&](const std::vector<int>& frames) -> Result<std::vector<int>> {
        if (frames.empty())
          return failure(request.recording.string(), "holds no frames", "record it again");
        return frames;
      });
}

// Without numbers an FBX holds the whole motion of the ribbon.
OutputFormat format_of_frames(const ConversionRequest& request, OutputFormat format) {
  const bool numbered = request.output.find('{') != std::string::npos;
  const bool whole = format == OutputFormat::fbx && !numbered && request.model.with_ribbon;
  return whole ? OutputFormat::whole_motion : format;
}

}  // namespace

Result<ConversionJob> open_job(const ConversionRequest& request) {
  const auto format = output_format(request.output).map([&](OutputFormat of_name) {
    return format_of_frames(request, of_name);
  });
  if (!format) return tl::unexpected(format.error());
  if (auto able = check_abilities(request, *format); !able) return tl::unexpected(able.error());
  auto reader = RecordingReader::open(request.recording);
  if (!reader) return tl::unexpected(reader.error());
  auto frames = asked_frames(request, *reader);
  if (!frames) return tl::unexpected(frames.error());
  auto model = model_of_recording(reader->header(), request.model);
  if (!model)
    return failure(request.recording.string(), model.error().problem, model.error().remedy);
  return ConversionJob{*format, std::move(*reader), std::move(*frames), std::move(*model)};
}

tl::unexpected<Error> no_frames(bool some_refused) {
  if (some_refused)
    return failure("", "the cloth of no frame can be made a solid", "leave --thickness out");
  return failure("", "none of the frames can be read", "record it again");
}

std::string job_text(const ConversionRequest& request, const RecordingReader& reader) {
  const ModelSettings& model = request.model;
  const Placement& placement = model.placement;
  return filled_in("ribbon-convert {} writes {} frames '{}' from {}\n", RIBBON_VERSION,
                   request.output, request.frames, request.start_frame.value_or(0)) +
         filled_in("of recording {} with {} bytes\n", reader.recording_id(), reader.file_bytes()) +
         filled_in(
             "as {}, {:.17g} m thick, obstacle {}, normals {}, {} up, {:.17g} m a unit, scaled by "
             "{:.17g}, ",
             model.faces == RibbonFaces::quads ? "quads" : "triangles", model.thickness_m,
             model.with_obstacle ? "too" : "left out", model.with_normals ? "yes" : "no",
             placement.up == UpAxis::z ? "z" : "y", placement.metres_per_unit, placement.scale) +
         (model.frames_per_second > 0
              ? filled_in("{:.17g} frames a second stated\n", model.frames_per_second)
              : "frames a second as recorded\n");
}

}  // namespace ribbon

#include "converter/conversion_job.h"

#include <utility>

#include "commandline/frame_range.h"
#include "converter/export/picture_file.h"
#include "converter/format_abilities.h"
#include "converter/output_names.h"
#include "recording/coding/checksum.h"
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

// The settings of the model, with the picture that the texture's file holds. It is named after the
// output, as the material library is, so that no name that somebody gave it can trouble a format.
Result<ModelSettings> model_settings(const ConversionRequest& request) {
  ModelSettings settings = request.model;
  if (request.texture.empty()) return settings;
  return read_picture_file(request.texture).map([&](PictureFile picture) {
    const std::filesystem::path library = material_library_name(request.output);
    picture.name = library.stem().string() + picture.extension;
    settings.picture = std::make_shared<const PictureFile>(std::move(picture));
    return settings;
  });
}

std::string texture_text(const Model& model) {
  const auto& picture = model.objects.front().material.picture;
  if (!picture) return "without texture\n";
  return filled_in("with a texture of {} bytes and the checksum {}\n", picture->bytes.size(),
                   checksum(picture->bytes));
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
  const auto settings = model_settings(request);
  if (!settings) return tl::unexpected(settings.error());
  auto model = model_of_recording(reader->header(), *settings);
  if (!model)
    return failure(request.recording.string(), model.error().problem, model.error().remedy);
  return ConversionJob{*format, std::move(*reader), std::move(*frames), std::move(*model)};
}

tl::unexpected<Error> no_frames(bool some_refused) {
  if (some_refused)
    return failure("", "the cloth of no frame can be made a solid", "leave --thickness out");
  return failure("", "none of the frames can be read", "record it again");
}

std::string job_text(const ConversionRequest& request, const ConversionJob& job) {
  const ModelSettings& model = request.model;
  const Placement& placement = model.placement;
  return filled_in("ribbon-convert {} writes {} frames '{}' from {}\n", RIBBON_VERSION,
                   request.output, request.frames, request.start_frame.value_or(0)) +
         filled_in("of recording {} with {} bytes\n", job.reader.recording_id(),
                   job.reader.file_bytes()) +
         filled_in(
             "as {}, {:.17g} m thick, obstacle {}, normals {}, {} up, {:.17g} m a unit, scaled by "
             "{:.17g}, ",
             model.faces == RibbonFaces::quads ? "quads" : "triangles", model.thickness_m,
             model.with_obstacle ? "too" : "left out", model.with_normals ? "yes" : "no",
             placement.up == UpAxis::z ? "z" : "y", placement.metres_per_unit, placement.scale) +
         (model.frames_per_second > 0
              ? filled_in("{:.17g} frames a second stated\n", model.frames_per_second)
              : "frames a second as recorded\n") +
         texture_text(job.model);
}

}  // namespace ribbon

#include "converter/conversion_job.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "commandline/frame_range.h"
#include "converter/format_abilities.h"
#include "converter/output_names.h"
#include "model/picture_file.h"
#include "model/solid_ribbon.h"
#include "recording/coding/checksum.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// A request for the obstacle alone is one for a single file, whatever the frames.
Result<std::vector<int>> asked_frames(const ConversionRequest& request,
                                      const RecordingReader& reader) {
  const int count =
      std::min(reader.frame_count(), request.frame_count.value_or(reader.frame_count()));
  return parse_frame_range(request.frames, count)
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

// What a texture's file holds; none where no file is named. It is named after the output, as the
// material library is, so that no name that somebody gave it can trouble a format.
Result<std::shared_ptr<const PictureFile>> texture_of(const ConversionRequest& request,
                                                      const std::filesystem::path& file,
                                                      std::string_view name_end) {
  if (file.empty()) return nullptr;
  return read_picture_file(file).map([&](PictureFile picture) {
    const std::filesystem::path library = material_library_name(request.output);
    picture.name = library.stem().string().append(name_end) + picture.extension;
    return std::make_shared<const PictureFile>(std::move(picture));
  });
}

Result<ModelSettings> model_settings(const ConversionRequest& request) {
  auto front = texture_of(request, request.texture, "");
  if (!front) return tl::unexpected(front.error());
  auto back = texture_of(request, request.texture_back, "_back");
  if (!back) return tl::unexpected(back.error());
  ModelSettings settings = request.model;
  settings.picture = std::move(*front);
  settings.back_picture = std::move(*back);
  return settings;
}

std::string textures_text(const Model& model) {
  std::string text;
  for (const Material& material : materials_of(model))
    if (const auto& picture = material.picture)
      text += filled_in("'{}' shows {} bytes with the checksum {}\n", material.name,
                        picture->bytes.size(), checksum(picture->bytes));
  return text;
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

tl::unexpected<Error> no_frames(const Model& model, bool some_refused) {
  if (!some_refused) return failure("", "none of the frames can be read", "record it again");
  const std::string problem = "the cloth of no frame can be made a solid";
  const double told_m =
      model.solid ? model.solid->told_thickness().value_or(0) / model.placement.factor() : 0;
  if (told_m == 0 || told_m > ConversionRequest::most_thickness_m)
    return failure("", problem, "leave --thickness out");
  return failure(
      "", problem + " so thin: single precision does not tell its sides apart",
      "set --thickness to " + short_number(told_m, 2, Rounding::up) + " or more, or leave it out");
}

tl::unexpected<Error> interrupted_conversion() {
  return passing_failure("", "interrupted", "start again");
}

std::string job_text(const ConversionRequest& request, const ConversionJob& job) {
  const ModelSettings& model = request.model;
  const Placement& placement = model.placement;
  return filled_in(
             "ribbon-convert {} writes {} frames '{}' numbered {}\n", RIBBON_VERSION,
             request.output, request.frames,
             request.start_frame ? filled_in("from {}", *request.start_frame) : "as recorded") +
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
         textures_text(job.model);
}

}  // namespace ribbon

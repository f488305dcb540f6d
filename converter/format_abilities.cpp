#include "converter/format_abilities.h"

#include <string>

#include "converter/motion_format.h"

namespace ribbon {

namespace {

struct Abilities {
  std::string extension;
  bool frame_rate;  // it says how many frames a second
  bool numbers;     // its files are numbered
  bool normals;
  bool still;     // it can hold what does not move
  bool pictures;  // its materials can show them
};

Abilities abilities_of(OutputFormat format, const std::string& output) {
  switch (format) {
    case OutputFormat::obj:
      return {".obj", false, true, true, true, true};
    case OutputFormat::fbx:
      return {".fbx", true, true, true, true, true};
    case OutputFormat::numbers:
      return {".csv", false, false, false, false, false};
    case OutputFormat::recording:
      return {".rbn", false, false, false, false, false};
    case OutputFormat::whole_motion:
      break;
  }
  const MotionFormat& motion = *motion_format(output);
  const bool pictures = motion.picture != PicturePlace::nowhere;
  return {std::string(motion.extension),
          motion.states_rate,
          false,
          motion.has_normals,
          false,
          pictures};
}

Result<void> check_still(const ConversionRequest& request, const Abilities& format) {
  if (!format.still)
    return failure(request.output, "a " + format.extension + " file holds motion",
                   "write the obstacle as .obj or .fbx");
  if (request.output.find('{') != std::string::npos)
    return failure(request.output, "the obstacle does not move, so one file holds it",
                   "leave {frame} out");
  if (!request.frames.empty() || request.start_frame || request.model.thickness_m > 0)
    return failure("", "the obstacle is the same in all frames, and solid as it is",
                   "leave --frames, --start-frame and --thickness out");
  if (!request.texture.empty())
    return failure("", "the texture lies on the ribbon, not on the obstacle",
                   "leave --texture out");
  return {};
}

// A recording is in metres and y up, and holds both ribbon and obstacle; a table holds numbers of
// all that.
Result<void> check_as_recorded(const ConversionRequest& request, const char* because) {
  const ModelSettings& model = request.model;
  const bool as_recorded = model.placement.up == UpAxis::y && model.placement.factor() == 1;
  const bool whole = model.with_ribbon && model.with_obstacle && model.thickness_m == 0 &&
                     model.faces == RibbonFaces::triangles;
  if (as_recorded && whole) return {};
  return failure(request.output, because,
                 "leave --up, --unit, --scale, --object, --faces and --thickness out");
}

}  // namespace

Result<void> check_abilities(const ConversionRequest& request, OutputFormat output) {
  const Abilities format = abilities_of(output, request.output);
  const auto lacks = [&](const char* what, const char* option) {
    return failure(request.output, "a " + format.extension + " file " + what,
                   std::string("leave ") + option + " out");
  };
  if (request.model.frames_per_second > 0 && output == OutputFormat::recording)
    return lacks("keeps the rate of its frames", "--fps");
  if (request.model.frames_per_second > 0 && !format.frame_rate)
    return lacks("does not say how many frames a second it has", "--fps");
  if (request.resume && !(format.numbers && request.model.with_ribbon))
    return failure(request.output, "is one file, which appears complete or not at all",
                   "leave --resume out");
  if (request.start_frame && !format.numbers)
    return lacks("does not number its frames", "--start-frame");
  if (request.model.with_normals && !format.normals)
    return lacks("does not keep normals of every frame", "--normals");
  if (!request.texture.empty() && !format.pictures) return lacks("has no materials", "--texture");
  if (!request.texture_back.empty() && request.model.thickness_m == 0)
    return failure("", "a ribbon without thickness is one surface, which shows one texture",
                   "add --thickness, or leave --texture-back out");
  if (request.max_error_m > 0 && output != OutputFormat::recording)
    return lacks("holds positions as they were recorded", "--max-error");
  if (output == OutputFormat::recording)
    return check_as_recorded(request, "a recording stays in metres, y up, with all that it shows");
  if (output == OutputFormat::numbers)
    return check_as_recorded(request, "a .csv file holds numbers of frames, and no positions");
  if (!request.model.with_ribbon) return check_still(request, format);
  return {};
}

}  // namespace ribbon

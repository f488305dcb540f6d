#include "player/output/picture_format.h"

#include "commandline/extension.h"

namespace ribbon {

Result<void> check_single_name(const std::string& output) {
  if (output.find("{frame") != std::string::npos)
    return failure(output, "has a place for the frame number, but holds all frames",
                   "leave {frame} out");
  if (output.find("{view}") != std::string::npos)
    return failure(output, "has a place for the view, but there is only one file",
                   "leave {view} out");
  return {};
}

Result<PictureFormat> picture_format(const std::string& output) {
  if (output == "-") return PictureFormat::raw;
  const std::string extension = lower_case_extension(output);
  if (extension == ".png") return PictureFormat::png;
  if (extension == ".exr") return PictureFormat::exr;
  if (extension == ".mp4" || extension == ".webm" || extension == ".gif")
    return PictureFormat::video;
  return failure(
      output, extension.empty() ? "has no extension" : "is not written as " + extension,
      "choose .png or .exr (a file a picture), .mp4, .webm or .gif (by ffmpeg), .html (a "
      "page that plays the recording), or '-' for raw frames on standard output");
}

}  // namespace ribbon

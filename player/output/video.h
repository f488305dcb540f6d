// Pictures as a video or an animated GIF, by ffmpeg.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <string>

#include "files/descriptor.h"
#include "files/part_file.h"
#include "player/output/existing_file.h"
#include "player/output/picture_sink.h"
#include "player/output/reader_pipe.h"

namespace ribbon {

// Runs ffmpeg beside us and hands it the pixels. The file has another name until it is complete.
class Video final : public PictureSink {
 public:
  // file: its extension says what it becomes (.mp4: H.264, .webm: VP9, .gif). Fails where ffmpeg is
  // not there, the file exists and is not to be replaced, or a GIF would be too fast.
  static Result<std::unique_ptr<PictureSink>> open(const std::filesystem::path& file,
                                                   PictureSize size, double frames_per_second,
                                                   const Replaceable& replaceable, Stopped stopped);
  // Ends ffmpeg.
  ~Video() override;

  // Both fail, too, where it was stopped before ffmpeg was done.
  Result<void> put(OutputPicture picture) override;
  Result<void> finish() override;

 private:
  Video(std::filesystem::path file, PartFile part, Older older, Stopped stopped);
  Result<void> start(PictureSize size, double frames_per_second);
  [[nodiscard]] std::string complaint() const;
  [[nodiscard]] tl::unexpected<Error> interrupted() const;
  Result<void> wait_for_ffmpeg();

  std::filesystem::path file_;
  PartFile part_;
  Older older_;
  Stopped stopped_;
  FileDescriptor pixels_;      // into ffmpeg
  FileDescriptor complaints_;  // what ffmpeg says
  pid_t ffmpeg_ = -1;          // not running
};

}  // namespace ribbon

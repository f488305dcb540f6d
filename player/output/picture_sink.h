// Where rendered pictures go.
#pragma once

#include <variant>

#include "player/picture/picture.h"
#include "result/result.h"

namespace ribbon {

struct OutputPicture {
  int number = 1;    // in the order of playing, or of its frame: what stands in its file's name
  double frame = 1;  // that it shows, from 1; what is interpolated lies between two
  // As it is shown on a screen, or linear light where that is what is stored.
  std::variant<Picture, LightPicture> image = Picture{};
};

class PictureSink {
 public:
  PictureSink() = default;
  PictureSink(const PictureSink&) = delete;
  PictureSink& operator=(const PictureSink&) = delete;
  // Without finish(), what is not complete leaves nothing behind.
  virtual ~PictureSink() = default;

  // Takes the next picture; all have the same size.
  virtual Result<void> put(OutputPicture picture) = 0;
  // After the last one. Once.
  virtual Result<void> finish() = 0;
};

}  // namespace ribbon

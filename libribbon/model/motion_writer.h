// One file that holds a whole motion.
#pragma once

#include "files/part_file.h"
#include "model/model.h"
#include "result/result.h"

namespace ribbon {

// Written frame by frame, so that memory does not grow with the motion where the format allows
// that. Destroyed before finish(), it leaves nothing behind. Each format has a function that makes
// its writer; that takes the model in the pose of the first frame and the number of frames to come.
class MotionWriter {
 public:
  MotionWriter() = default;
  MotionWriter(const MotionWriter&) = delete;
  MotionWriter& operator=(const MotionWriter&) = delete;
  virtual ~MotionWriter() = default;

  // The next frame: the model that the writer was made with, posed anew.
  virtual Result<void> append(const Model& model) = 0;
  // All frames announced must have been appended. The file gets its name.
  virtual Result<void> finish(Older older = Older::is_replaced) = 0;
};

}  // namespace ribbon

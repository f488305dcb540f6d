// Readers of one recording, one for each thread that works on it.
#pragma once

#include <filesystem>
#include <mutex>
#include <vector>

#include "playback/recording_reader.h"
#include "result/result.h"

namespace ribbon {

// Opens readers as they are needed and lends them again, so that there are never more than threads.
class ReaderPool {
 public:
  // `first` is the first reader to be lent; more are opened from `recording`.
  ReaderPool(std::filesystem::path recording, RecordingReader first);

  Result<RecordingReader> take();
  void give_back(RecordingReader reader);

  // All the damage that the readers have met so far; they look for it where a frame cannot be read.
  std::vector<Damage> damage();

 private:
  std::filesystem::path recording_;
  std::mutex mutex_;
  std::vector<RecordingReader> idle_;
};

}  // namespace ribbon

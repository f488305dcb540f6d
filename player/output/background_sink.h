// Pictures are encoded and written while the next one is rendered.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>

#include "player/output/picture_sink.h"

namespace ribbon {

// Hands pictures on to another sink, in their order, by a thread of its own. A few wait at most, so
// that memory is bounded however slow the disk is.
class BackgroundSink final : public PictureSink {
 public:
  explicit BackgroundSink(std::unique_ptr<PictureSink> sink);
  // Waits until everything that was put is written; problems are lost.
  ~BackgroundSink() override;

  // Waits while too many wait. Fails with the first problem of any picture before; nothing is
  // written after that.
  Result<void> put(OutputPicture picture) override;
  // Waits until everything is written.
  Result<void> finish() override;

 private:
  void run();
  void end();

  std::unique_ptr<PictureSink> sink_;  // of the thread alone until it has ended

  std::mutex mutex_;  // guards everything below
  std::condition_variable changed_;
  std::deque<OutputPicture> waiting_;
  bool closing_ = false;
  Result<void> problem_;

  std::thread thread_;  // begins when all else is there
};

}  // namespace ribbon

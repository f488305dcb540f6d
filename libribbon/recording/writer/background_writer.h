// Writes a recording beside the simulation that makes it.
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "recording/writer/recording_writer.h"

namespace ribbon {

// What writing beside the simulation has taken so far.
struct BackgroundFigures {
  WriterFigures writer;           // wall time of the writing thread
  std::size_t longest_queue = 0;  // what waited at the same time, at most: frames, checkpoints
};

// Encodes and writes on a thread of its own, in the order of the calls. A call copies what it gets
// and returns; nothing is ever dropped, however long the queue gets. What finds the thread idle is
// written a tenth of a second later, or with seven others as soon as they have come; what is
// written reaches the disk at most a second later, so that a power cut costs no more.
class BackgroundWriter {
 public:
  explicit BackgroundWriter(RecordingWriter writer);
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;
  // Waits until everything is written.
  ~BackgroundWriter();

  // As in RecordingWriter. Problems are told by problem().
  void append(const FrameNumbers& numbers, const Eigen::Matrix3Xd& positions);
  void append_checkpoint(std::uint64_t steps, std::string state);
  void append_session(const SessionNote& note);

  // The first thing that went wrong, if anything did. Nothing is written after it.
  [[nodiscard]] Result<void> problem() const;

  // Waits until everything is written, then writes what ended the run and closes. Once.
  Result<void> finish(RunEnding ending);

  [[nodiscard]] BackgroundFigures figures() const;
  // The file's size, as far as it has been written.
  [[nodiscard]] std::uint64_t bytes_written() const;

 private:
  using Clock = std::chrono::steady_clock;
  using Task = std::function<Result<void>(RecordingWriter&)>;

  void add(Task task);
  std::optional<Task> next(std::optional<Clock::time_point> sync_at);
  void run();
  void note(Result<void> outcome);
  void end();

  RecordingWriter writer_;  // of the thread alone

  mutable std::mutex mutex_;  // guards everything below
  std::condition_variable changed_;
  std::deque<Task> queue_;
  bool closing_ = false;
  Result<void> problem_;
  BackgroundFigures figures_;
  std::uint64_t bytes_ = 0;

  std::thread thread_;  // begins when all else is there
};

}  // namespace ribbon

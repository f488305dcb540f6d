// Reads a recording, any frame at any time.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recording/recording.h"
#include "result/result.h"

namespace ribbon {

// A part of the file that could not be read.
struct Damage {
  std::uint64_t byte = 0;    // where it begins
  std::uint64_t length = 0;  // how many bytes were skipped
  std::string reason;
};

class RecordingReader {
 public:
  // Opens `path` and finds its frames, by the index where there is one and by scanning otherwise. A
  // cut-off tail is a normal end. Fails when the file cannot be read or its header is not valid.
  static Result<RecordingReader> open(const std::filesystem::path& path);

  RecordingReader(RecordingReader&&) noexcept;
  RecordingReader& operator=(RecordingReader&&) noexcept;
  ~RecordingReader();

  [[nodiscard]] const RecordingHeader& header() const;
  // Number of frames recorded, lost ones included, so that a frame keeps its index whatever
  // happened to its neighbours. Indices run from 0; users see frames numbered from 1.
  [[nodiscard]] int frame_count() const;
  // Can frame `index` be decoded? False where damage took it or a frame that it builds upon.
  [[nodiscard]] bool readable(int index) const;
  // The numbers of frame `index`, read without its geometry; nothing where its record is lost.
  [[nodiscard]] const std::optional<FrameNumbers>& numbers(int index) const;
  // Was the recording finished, or was its writer stopped on the way?
  [[nodiscard]] bool finished() const;
  // What ended the run; unknown where the recording is not finished or its writer did not tell.
  [[nodiscard]] RunEnding ending() const;
  // What is known to be damaged. An index tells nothing about the frames that it points to, so
  // damage to frames of a finished recording is noticed when one of them is read, or by check().
  [[nodiscard]] const std::vector<Damage>& damage() const;
  [[nodiscard]] std::uint64_t file_bytes() const;

  // Reads every record and compares its checksum, so that readable(), numbers() and damage() tell
  // all. Takes the time to read the file once; frames are not decoded.
  void check();

  // Decodes frame `index` into `positions` (resized to 3 x particles, metres, single precision).
  // The answer is the same whatever was read before. Cheapest in ascending order. Not thread-safe:
  // give each thread its own reader. Fails when the frame is not readable.
  Result<void> read(int index, Eigen::Matrix3Xf& positions);

 private:
  struct State;
  explicit RecordingReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace ribbon

// One line on standard error that says how far a long job is.
#pragma once

#include <chrono>
#include <string>

namespace ribbon {

// The line as drawn: "[####............] 123/600 frames, ETA 0:42, strain 4.1 %", cut off
// so that it fits `columns` of a terminal. The time left assumes that what is still to do goes as
// fast as what is done.
std::string progress_text(const std::string& unit, int done, int total, double elapsed_s,
                          const std::string& remark, int columns);

class ProgressLine {
 public:
  // `total` units of work of the named kind ("frame"). Draws only when standard error is a terminal
  // and `quiet` is false.
  ProgressLine(std::string unit, int total, bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Redraws at most ten times a second: bar, done/total, ETA and `remark` ("strain 4.1 %").
  void update(int done, const std::string& remark = "");
  // Removes the line, so that a summary can follow.
  void clear();

 private:
  std::string unit_;
  int total_;
  bool draws_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_draw_;
};

}  // namespace ribbon

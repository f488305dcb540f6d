// How far a long job is, told on standard error.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace ribbon {

struct JobState {
  int done = 0;
  int total = 0;
  double elapsed_s = 0;
  int done_before = 0;  // it was begun: where a job goes on

  // What is still to do, as fast as what was done since; nothing before anything was.
  [[nodiscard]] std::optional<double> left_s() const;
};

// The line as drawn for people: "[####............] 123/600 frames, ETA 0:42, strain 4.1 %", cut
// off so that it fits `columns` of a terminal.
std::string progress_text(const std::string& unit, const JobState& job, const std::string& remark,
                          int columns);

// The same for programs, a JSON object in one line without its end: {"unit":"frame","done":123,
// "total":600,"seconds":9.7,"eta_seconds":37.6,"remark":"strain 4.1 %"}. Seconds as elapsed; the
// time left is null where it is not known.
std::string progress_json(const std::string& unit, const JobState& job, const std::string& remark);

enum class ProgressStyle {
  line,  // one that is drawn again and again, where standard error is a terminal
  json,  // a line of JSON each time, wherever it goes
  none
};

// The style that --progress names by this word ("line" or "json"), or none with --quiet.
ProgressStyle progress_style(const std::string& word, bool quiet);

class ProgressLine {
 public:
  // `total` units of work of the named kind ("frame").
  ProgressLine(std::string unit, int total, ProgressStyle style);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // What was done before the first call, but for one unit, was done before the job was begun.
  // Redraws at most ten times a second: bar, done/total, ETA and `remark` ("strain 4.1 %"). As JSON
  // at most once a second.
  void update(int done, const std::string& remark = "");
  // Nothing more will be done, whether that is all or not: removes the line, so that a summary can
  // follow; as JSON tells how far the job came.
  void end();

 private:
  void tell();

  std::string unit_;
  JobState job_;
  ProgressStyle style_;
  std::string remark_;
  std::optional<int> told_;  // how much of it
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_told_;
};

}  // namespace ribbon

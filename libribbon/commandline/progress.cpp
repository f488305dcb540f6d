#include "commandline/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "text/json.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto draw_pause = std::chrono::milliseconds(100);
constexpr auto json_pause = std::chrono::milliseconds(1000);
constexpr int bar_cells = 16;
constexpr const char* erase_line = "\r\x1b[K";

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int terminal_columns() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

std::string bar(double share) {
  const std::size_t full = std::lround(share * bar_cells);
  return "[" + std::string(full, '#') + std::string(bar_cells - full, '.') + "]";
}

// "0:07", "12:30", "3:05:00".
std::string clock_text(double seconds) {
  const long long whole = std::llround(seconds);
  if (whole < 3600) return filled_in("{}:{:02}", whole / 60, whole % 60);
  return filled_in("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

std::optional<double> JobState::left_s() const {
  if (done <= done_before) return std::nullopt;
  return elapsed_s / (done - done_before) * (total - done);
}

std::string progress_text(const std::string& unit, const JobState& job, const std::string& remark,
                          int columns) {
  const int total = job.total;
  const double share =
      total > 0 ? std::clamp(static_cast<double>(job.done) / total, 0.0, 1.0) : 1.0;
  std::string text =
      filled_in("{} {}/{} {}{}", bar(share), job.done, total, unit, total == 1 ? "" : "s");
  if (const auto left_s = job.left_s(); left_s && job.done < total)
    text += ", ETA " + clock_text(*left_s);
  if (!remark.empty()) text += ", " + remark;
  // A line that fills the last column would wrap on some terminals and could not be erased.
  return text.substr(0, std::max(0, columns - 1));
}

std::string progress_json(const std::string& unit, const JobState& job, const std::string& remark) {
  Json told{{"unit", unit},
            {"done", job.done},
            {"total", job.total},
            {"seconds", job.elapsed_s},
            {"eta_seconds", job.left_s()}};
  if (!remark.empty()) told.set("remark", remark);
  return told.line();
}

ProgressStyle progress_style(const std::string& word, bool quiet) {
  if (quiet) return ProgressStyle::none;
  return word == "json" ? ProgressStyle::json : ProgressStyle::line;
}

ProgressLine::ProgressLine(std::string unit, int total, ProgressStyle style)
    : unit_(std::move(unit)),
      job_{.total = total},
      style_(style == ProgressStyle::line && ::isatty(STDERR_FILENO) != 1 ? ProgressStyle::none
                                                                          : style),
      start_(Clock::now()) {}

ProgressLine::~ProgressLine() {
  end();
}

void ProgressLine::update(int done, const std::string& remark) {
  if (style_ == ProgressStyle::none) return;
  if (job_.done == 0) job_.done_before = std::max(0, done - 1);
  job_.done = done;
  remark_ = remark;
  const auto pause = style_ == ProgressStyle::json ? json_pause : draw_pause;
  if (!told_ || Clock::now() - last_told_ >= pause) tell();
}

void ProgressLine::tell() {
  job_.elapsed_s = seconds_since(start_);
  const std::string text =
      style_ == ProgressStyle::json
          ? progress_json(unit_, job_, remark_) + "\n"
          : erase_line + progress_text(unit_, job_, remark_, terminal_columns());
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
  told_ = job_.done;
  last_told_ = Clock::now();
}

void ProgressLine::end() {
  if (style_ == ProgressStyle::json && told_ != job_.done) tell();
  if (style_ == ProgressStyle::line && told_) std::fputs(erase_line, stderr);
  style_ = ProgressStyle::none;
}

}  // namespace ribbon

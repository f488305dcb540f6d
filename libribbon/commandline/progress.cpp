#include "commandline/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "text/number_text.h"

namespace ribbon {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto shortest_pause = std::chrono::milliseconds(100);
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

std::string progress_text(const std::string& unit, int done, int total, double elapsed_s,
                          const std::string& remark, int columns) {
  const double share = total > 0 ? std::clamp(static_cast<double>(done) / total, 0.0, 1.0) : 1.0;
  std::string text =
      filled_in("{} {}/{} {}{}", bar(share), done, total, unit, total == 1 ? "" : "s");
  if (done > 0 && done < total) text += ", ETA " + clock_text(elapsed_s / done * (total - done));
  if (!remark.empty()) text += ", " + remark;
  // A line that fills the last column would wrap on some terminals and could not be erased.
  return text.substr(0, std::max(0, columns - 1));
}

ProgressLine::ProgressLine(std::string unit, int total, bool quiet)
    : unit_(std::move(unit)),
      total_(total),
      draws_(!quiet && ::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()) {}

ProgressLine::~ProgressLine() {
  clear();
}

void ProgressLine::update(int done, const std::string& remark) {
  if (!draws_) return;
  const Clock::time_point now = Clock::now();
  if (drawn_ && now - last_draw_ < shortest_pause) return;
  const std::string text =
      progress_text(unit_, done, total_, seconds_since(start_), remark, terminal_columns());
  std::fprintf(stderr, "%s%s", erase_line, text.c_str());
  std::fflush(stderr);
  drawn_ = true;
  last_draw_ = now;
}

void ProgressLine::clear() {
  if (drawn_) std::fputs(erase_line, stderr);
  drawn_ = false;
}

}  // namespace ribbon

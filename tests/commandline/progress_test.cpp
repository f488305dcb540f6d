#include "commandline/progress.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <thread>

#include "result/refusal.h"

namespace ribbon::progress_test {

TEST(ProgressText, tells_how_far_and_how_long_still) {
  // A quarter took 10 s, so three quarters take 30 s.
  EXPECT_EQ(progress_text("frame", {.done = 25, .total = 100, .elapsed_s = 10}, "strain 4.1 %", 80),
            "[####............] 25/100 frames, ETA 0:30, strain 4.1 %");
}

TEST(ProgressText, has_no_forecast_before_the_first_and_after_the_last) {
  EXPECT_EQ(progress_text("frame", {.done = 0, .total = 100, .elapsed_s = 10}, "", 80),
            "[................] 0/100 frames");
  EXPECT_EQ(progress_text("frame", {.done = 100, .total = 100, .elapsed_s = 10}, "", 80),
            "[################] 100/100 frames");
}

TEST(ProgressText, long_jobs_are_told_in_hours) {
  EXPECT_THAT(progress_text("frame", {.done = 1, .total = 2, .elapsed_s = 11105}, "", 80),
              HasSubstr("ETA 3:05:05"));
  EXPECT_THAT(progress_text("frame", {.done = 1, .total = 2, .elapsed_s = 754}, "", 80),
              HasSubstr("ETA 12:34"));
}

TEST(ProgressText, what_was_done_before_the_job_went_on_says_nothing_of_its_pace) {
  EXPECT_EQ(progress_text("frame", {.done = 75, .total = 100, .elapsed_s = 10, .done_before = 50},
                          "", 80),
            "[############....] 75/100 frames, ETA 0:10");
}

TEST(ProgressText, one_unit_is_singular) {
  EXPECT_EQ(progress_text("file", {.done = 1, .total = 1, .elapsed_s = 1}, "", 80),
            "[################] 1/1 file");
}

TEST(ProgressText, fits_the_terminal) {
  EXPECT_EQ(progress_text("frame", {.done = 25, .total = 100, .elapsed_s = 10}, "strain", 22),
            "[####............] 25");
  EXPECT_EQ(progress_text("frame", {.done = 25, .total = 100, .elapsed_s = 10}, "strain", 0), "");
}

TEST(ProgressText, survives_empty_and_overfull_jobs) {
  EXPECT_EQ(progress_text("frame", {.done = 0, .total = 0, .elapsed_s = 0}, "", 80),
            "[################] 0/0 frames");
  EXPECT_EQ(progress_text("frame", {.done = 5, .total = 4, .elapsed_s = 1}, "", 80),
            "[################] 5/4 frames");
}

// Standard error as `descriptor` while it lives.
class StandardErrorIs {
 public:
  explicit StandardErrorIs(int descriptor) : saved_(::dup(STDERR_FILENO)) {
    ::dup2(descriptor, STDERR_FILENO);
  }
  ~StandardErrorIs() {
    ::dup2(saved_, STDERR_FILENO);
    ::close(saved_);
  }
  StandardErrorIs(const StandardErrorIs&) = delete;
  StandardErrorIs& operator=(const StandardErrorIs&) = delete;

 private:
  int saved_;
};

// What `job` writes on standard error when that is a terminal of 60 columns.
std::string seen_on_a_terminal(const std::function<void()>& job) {
  const int screen = ::posix_openpt(O_RDWR | O_NOCTTY);
  EXPECT_EQ(::grantpt(screen) + ::unlockpt(screen), 0);
  const int terminal = ::open(::ptsname(screen), O_RDWR | O_NOCTTY);
  EXPECT_GE(terminal, 0);
  const winsize size{.ws_row = 24, .ws_col = 60, .ws_xpixel = 0, .ws_ypixel = 0};
  ::ioctl(terminal, TIOCSWINSZ, &size);
  {
    const StandardErrorIs redirected(terminal);
    job();
  }
  EXPECT_EQ(::write(terminal, "$", 1), 1);
  std::string seen;
  std::array<char, 4096> bytes{};
  while (seen.find('$') == std::string::npos) {
    const ssize_t count = ::read(screen, bytes.data(), bytes.size());
    if (count <= 0) break;
    seen.append(bytes.data(), count);
  }
  ::close(terminal);
  ::close(screen);
  return seen.substr(0, seen.find('$'));
}

const std::string erased = "\r\x1b[K";

TEST(ProgressLine, draws_on_a_terminal_and_removes_itself) {
  const std::string seen = seen_on_a_terminal([] {
    ProgressLine line("frame", 4, ProgressStyle::line);
    line.update(2, "a remark that is much too long for this narrow terminal");
  });
  ASSERT_GT(seen.size(), 2 * erased.size());
  EXPECT_EQ(seen.substr(0, 36), erased + "[########........] 2/4 frames, E");
  EXPECT_EQ(seen.size(), 59 + 2 * erased.size());
  EXPECT_EQ(seen.substr(seen.size() - erased.size()), erased);
}

TEST(ProgressLine, redraws_at_most_ten_times_a_second) {
  const std::string seen = seen_on_a_terminal([] {
    ProgressLine line("frame", 1000, ProgressStyle::line);
    for (int i = 0; i < 1000; ++i) line.update(i);
    std::this_thread::sleep_for(std::chrono::milliseconds(110));
    line.update(1000);
  });
  EXPECT_THAT(seen, HasSubstr(" 0/1000"));
  EXPECT_THAT(seen, Not(HasSubstr(" 1/1000")));
  EXPECT_THAT(seen, HasSubstr(" 1000/1000"));
}

TEST(ProgressLine, is_silent_when_quiet) {
  EXPECT_EQ(seen_on_a_terminal([] { ProgressLine("frame", 4, ProgressStyle::none).update(2); }),
            "");
}

TEST(ProgressLine, is_silent_when_standard_error_is_no_terminal) {
  testing::internal::CaptureStderr();
  ProgressLine("frame", 4, ProgressStyle::line).update(2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ProgressJson, is_one_object_with_seconds_and_forecast) {
  EXPECT_EQ(progress_json("frame", {.done = 25, .total = 100, .elapsed_s = 10}, "strain 4.1 %"),
            R"({"unit":"frame","done":25,"total":100,"seconds":10.0,"eta_seconds":30.0,)"
            R"("remark":"strain 4.1 %"})");
  EXPECT_EQ(progress_json("frame", {.done = 0, .total = 100, .elapsed_s = 0.5}, ""),
            R"({"unit":"frame","done":0,"total":100,"seconds":0.5,"eta_seconds":null})");
}

TEST(ProgressJson, is_told_wherever_standard_error_goes_at_the_first_and_when_all_is_done) {
  testing::internal::CaptureStderr();
  {
    ProgressLine line("frame", 50, ProgressStyle::json);
    for (int done = 1; done <= 50; ++done) line.update(done);
  }
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 2) << told;
  EXPECT_THAT(told, StartsWith(R"({"unit":"frame","done":1,)"));
  EXPECT_THAT(told, HasSubstr("\n{\"unit\":\"frame\",\"done\":50,"));
  EXPECT_THAT(told, EndsWith("}\n"));
}

// What is told of a job that ends before its total.
std::string last_told(const std::function<void(ProgressLine&)>& job) {
  testing::internal::CaptureStderr();
  {
    ProgressLine line("frame", 50, ProgressStyle::json);
    job(line);
  }
  std::string told = testing::internal::GetCapturedStderr();
  told.pop_back();
  return told.substr(told.rfind('\n') + 1);
}

TEST(ProgressJson, tells_in_the_end_how_far_it_came) {
  EXPECT_THAT(last_told([](ProgressLine& line) {
                for (int done = 1; done <= 20; ++done) line.update(done);
              }),
              StartsWith(R"({"unit":"frame","done":20,"total":50,)"))
      << "tight early";
  EXPECT_THAT(last_told([](ProgressLine&) {}), StartsWith(R"({"unit":"frame","done":0,)"))
      << "nothing was left to do";
  EXPECT_THAT(last_told([](ProgressLine& line) {
                line.update(1);
                line.end();
                line.update(2);
              }),
              StartsWith(R"({"unit":"frame","done":1,)"));
}

TEST(ProgressStyle, quiet_wins) {
  EXPECT_EQ(progress_style("json", false), ProgressStyle::json);
  EXPECT_EQ(progress_style("line", false), ProgressStyle::line);
  EXPECT_EQ(progress_style("json", true), ProgressStyle::none);
}

}  // namespace ribbon::progress_test

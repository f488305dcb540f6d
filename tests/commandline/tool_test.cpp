#include "commandline/tool.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

namespace ribbon::tool_test {

struct Outcome {
  int code;
  std::string standard_error;
};

Outcome outcome(const std::function<Result<ExitCode>()>& body) {
  testing::internal::CaptureStderr();
  const int code = run_tool("ribbon-test", body);
  return {code, testing::internal::GetCapturedStderr()};
}

TEST(RunTool, answers_become_exit_codes) {
  EXPECT_EQ(outcome([] { return ExitCode::done; }).code, 0);
  EXPECT_EQ(outcome([] { return ExitCode::answer_is_no; }).code, 1);
  EXPECT_EQ(outcome([] { return ExitCode::could_not; }).code, 2);
  EXPECT_EQ(outcome([] { return ExitCode::try_again; }).code, 3);
}

TEST(RunTool, an_answer_is_no_reason_to_write_to_standard_error) {
  EXPECT_EQ(outcome([] { return ExitCode::answer_is_no; }).standard_error, "");
}

TEST(RunTool, an_error_is_one_sentence_after_the_tools_name) {
  const auto [code, standard_error] = outcome([]() -> Result<ExitCode> {
    return failure("knot.toml:3:1", "unknown key 'widht'", "write 'width'");
  });
  EXPECT_EQ(code, 2);
  EXPECT_EQ(standard_error, "ribbon-test: knot.toml:3:1: unknown key 'widht'; write 'width'\n");
}

TEST(RunTool, an_error_that_may_pass_asks_for_another_try) {
  const auto [code, standard_error] = outcome(
      []() -> Result<ExitCode> { return passing_failure("", "interrupted", "start again"); });
  EXPECT_EQ(code, 3);
  EXPECT_EQ(standard_error, "ribbon-test: interrupted; start again\n");
}

TEST(RunTool, what_happens_to_a_file_is_no_bug) {
  const auto [code, standard_error] = outcome([]() -> Result<ExitCode> {
    return std::filesystem::file_size("/gone") > 0 ? ExitCode::done : ExitCode::answer_is_no;
  });
  EXPECT_EQ(code, 2);
  EXPECT_EQ(standard_error,
            "ribbon-test: /gone: cannot be used (No such file or directory); check that it is "
            "there, and its permissions\n");
}

// What is said on a closed stream would go into the file that is opened next.
TEST(RunToolDeathTest, closed_streams_are_no_files_of_the_job) {
  const auto open_a_file = []() -> Result<ExitCode> {
    return ::open("/dev/null", O_WRONLY) > STDERR_FILENO ? ExitCode::done : ExitCode::answer_is_no;
  };
  EXPECT_EXIT(
      {
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(stream);
        std::_Exit(run_tool("ribbon-test", open_a_file));
      },
      testing::ExitedWithCode(0), "");
}

TEST(RunTool, a_lack_of_memory_is_reported) {
  const auto [code, standard_error] = outcome([]() -> Result<ExitCode> { throw std::bad_alloc(); });
  EXPECT_EQ(code, 2);
  EXPECT_EQ(standard_error,
            "ribbon-test: not enough memory; close other programs or ask for less at once\n");
}

TEST(RunTool, a_lack_of_threads_is_no_bug) {
  const auto [code, standard_error] = outcome([]() -> Result<ExitCode> {
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  });
  EXPECT_EQ(code, 2);
  EXPECT_EQ(standard_error,
            "ribbon-test: the system gives it no more threads; close other programs, or allow more "
            "processes (ulimit -u) or memory (ulimit -v)\n");
}

TEST(RunTool, that_nobody_reads_any_more_ends_no_work) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  ::close(ends[0]);
  const auto write_to_nobody = [&] {
    EXPECT_EQ(::write(ends[1], "1", 1), -1);
    EXPECT_EQ(errno, EPIPE);
    return ExitCode::done;
  };
  std::signal(SIGPIPE, SIG_DFL);
  EXPECT_EQ(outcome(write_to_nobody).code, 0);
  ::close(ends[1]);
}

TEST(RunTool, an_escaped_exception_is_reported) {
  const auto [code, standard_error] =
      outcome([]() -> Result<ExitCode> { throw std::runtime_error("surprise"); });
  EXPECT_EQ(code, 2);
  EXPECT_EQ(standard_error,
            "ribbon-test: stopped by an unexpected problem (surprise); please report it\n");
}

}  // namespace ribbon::tool_test

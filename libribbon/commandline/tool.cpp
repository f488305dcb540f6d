#include "commandline/tool.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "result/caught.h"

namespace ribbon {

namespace {

int told(ExitCode code, const std::string& tool_name, const std::string& sentence) {
  std::fprintf(stderr, "%s: %s\n", tool_name.c_str(), sentence.c_str());
  return static_cast<int>(code);
}

// What was printed must have arrived, too.
Result<ExitCode> printed(ExitCode code) {
  const bool is_lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  if (!is_lost) return code;
  return passing_failure("standard output", "cannot be written, so that part of it is missing",
                         "make room where it goes or read it to its end, and call it again");
}

// A file that is opened next would get the number, and with it all that is said there.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", O_RDWR);
}

}  // namespace

int run_tool(const std::string& tool_name, const std::function<Result<ExitCode>()>& body) {
  occupy_closed_streams();
  // A limit on file sizes is a write error like a full disk, with a sentence.
  std::signal(SIGXFSZ, SIG_IGN);
  // Likewise that nobody reads any more. A run goes on without those who watched it.
  std::signal(SIGPIPE, SIG_IGN);
  const auto answer = caught([&] { return body().and_then(printed); });
  if (answer) return static_cast<int>(*answer);
  return told(answer.error().may_pass ? ExitCode::try_again : ExitCode::could_not, tool_name,
              answer.error().sentence());
}

}  // namespace ribbon

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "files/descriptor.h"
#include "obstacle/isolated.h"

namespace ribbon {

namespace {

[[noreturn]] void run_and_exit(const std::function<std::string()>& work, unsigned most_s,
                               const FileDescriptor& to) {
  // Nobody shall look for what went wrong: the other process tells.
  for (const int sign : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) signal(sign, SIG_DFL);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const rlimit limit{most_s, most_s};
  setrlimit(RLIMIT_CPU, &limit);
  // What assertions print is for programmers.
  const FileDescriptor nowhere(open("/dev/null", O_WRONLY | O_CLOEXEC));
  if (nowhere.is_open()) dup2(nowhere.number(), STDERR_FILENO);
  _exit(write_all(to, work()) ? 0 : 1);
}

std::string all_of(const FileDescriptor& from) {
  std::string bytes;
  std::array<char, 1 << 16> part;
  while (true) {
    const ssize_t count = read(from.number(), part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(part.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

std::optional<std::string> isolated(const std::function<std::string()>& work, unsigned most_s) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return work();
  const FileDescriptor from(ends[0]);
  FileDescriptor to(ends[1]);
  const pid_t process = fork();
  if (process < 0) return work();
  if (process == 0) run_and_exit(work, most_s, to);
  to.close();
  std::string bytes = all_of(from);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return bytes;
}

}  // namespace ribbon

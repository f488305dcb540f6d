// Processes that run beside a test.
#pragma once

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

namespace ribbon {

// The process; -1 where it could not be started.
inline pid_t spawned(std::vector<std::string> words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = -1;
  if (posix_spawn(&process, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
    return -1;
  return process;
}

// The exit code; -1 where a signal ended it.
inline int waited_for(pid_t process) {
  int status = 0;
  if (process < 0 || ::waitpid(process, &status, 0) != process) return -2;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace ribbon

// Processes that run beside a test.
#pragma once

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

namespace ribbon {

// The process; -1 where it could not be started. It heeds Ctrl-C even where the test, as a job in
// the background of a script, does not.
inline pid_t spawned(std::vector<std::string> words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawnattr_t heeding;
  sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGINT);
  ::sigaddset(&signals, SIGHUP);
  ::posix_spawnattr_init(&heeding);
  ::posix_spawnattr_setsigdefault(&heeding, &signals);
  ::posix_spawnattr_setflags(&heeding, POSIX_SPAWN_SETSIGDEF);
  pid_t process = -1;
  const int answer =
      ::posix_spawn(&process, arguments[0], nullptr, &heeding, arguments.data(), environ);
  ::posix_spawnattr_destroy(&heeding);
  return answer == 0 ? process : -1;
}

// The exit code; -1 where a signal ended it.
inline int waited_for(pid_t process) {
  int status = 0;
  if (process < 0 || ::waitpid(process, &status, 0) != process) return -2;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace ribbon

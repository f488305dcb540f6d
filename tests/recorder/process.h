// Processes that run beside a test.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

namespace ribbon {

enum class StandardOutput { shared, thrown_away };

// The process; -1 where it could not be started. It heeds Ctrl-C even where the test, as a job in
// the background of a script, does not.
inline pid_t spawned(std::vector<std::string> words,
                     StandardOutput output = StandardOutput::shared) {
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
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  if (output == StandardOutput::thrown_away)
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = -1;
  const int answer =
      ::posix_spawn(&process, arguments[0], &files, &heeding, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&files);
  ::posix_spawnattr_destroy(&heeding);
  return answer == 0 ? process : -1;
}

// Does it run no more? It can still be waited for.
inline bool has_ended(pid_t process) {
  siginfo_t ended{};
  return ::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         ended.si_pid == process;
}

// How a process came to its end.
struct Ended {
  int exit_code = -2;      // -1: by a signal; -2: there was none
  double most_memory = 0;  // bytes, that it had at any time
};

inline Ended end_of(pid_t process) {
  rusage usage{};
  int status = 0;
  if (process < 0 || ::wait4(process, &status, 0, &usage) != process) return {};
  return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .most_memory = 1024.0 * static_cast<double>(usage.ru_maxrss)};
}

inline int waited_for(pid_t process) {
  return end_of(process).exit_code;
}

}  // namespace ribbon

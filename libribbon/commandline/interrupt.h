// Ctrl-C as a question that a long job asks between two pieces of work.
#pragma once

#include <array>
#include <csignal>

namespace ribbon {

// While it lives, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP (the terminal was closed) only sets
// a flag, so that the job can finish what it is writing; the second one ends the process as usual,
// but for SIGHUP: both terminal and shell send one. A signal that was ignored when the process
// started (nohup, a background job) stays ignored. One at a time in a process.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] bool requested() const;

 private:
  static constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, signals.size()> old_ = {};
};

}  // namespace ribbon

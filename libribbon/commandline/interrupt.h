// Ctrl-C as a question that a long job asks between two pieces of work.
#pragma once

#include <csignal>

namespace ribbon {

// While it lives, the first Ctrl-C (SIGINT) or SIGTERM only sets a flag, so that the job can finish
// what it is writing; the second one ends the process as usual. A signal that was ignored when the
// process started (nohup, a background job) stays ignored. One at a time in a process.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] bool requested() const;

 private:
  struct sigaction old_interrupt_ {};
  struct sigaction old_terminate_ {};
};

}  // namespace ribbon

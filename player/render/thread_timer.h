// Processor time of one thread.
#pragma once

#include <ctime>

namespace ribbon {

// Does not count while other work has the processor.
class ThreadTimer {
 public:
  // Since it was made, in the thread that made it.
  [[nodiscard]] double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_ = now();
};

}  // namespace ribbon

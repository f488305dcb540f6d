// Processor time of one thread.
#pragma once

#include <algorithm>
#include <ctime>

namespace ribbon {

// Does not count while other work has the processor, nor what it takes itself: to ask for a
// thread's time is a call of the system, and a tile of a draft takes but thirty times as long.
class ThreadTimer {
 public:
  // Since it was made, in the thread that made it.
  [[nodiscard]] double seconds() const {
    static const double own = least_difference();
    return std::max(0.0, now() - start_ - own);
  }

 private:
  static double least_difference() {
    double least = 1;
    for (int i = 0; i < 100; ++i) {
      const double before = now();
      least = std::min(least, now() - before);
    }
    return least;
  }

  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_ = now();
};

}  // namespace ribbon

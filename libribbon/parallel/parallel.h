// Loops over all cores whose results do not depend on how many there are.
#pragma once

#include <cstddef>

namespace ribbon {

// Limits all parallel loops of the process to `threads` (0: all cores, the default).
void set_thread_limit(int threads);

// Refers to what a loop calls, body(begin, end), which must outlive it. Takes no memory.
class RangeBody {
 public:
  template <class Body>
  // NOLINTNEXTLINE(google-explicit-constructor): stands for the body
  RangeBody(const Body& body)
      : body_(&body), call_([](const void* of, std::size_t begin, std::size_t end) {
          (*static_cast<const Body*>(of))(begin, end);
        }) {}
  void operator()(std::size_t begin, std::size_t end) const { call_(body_, begin, end); }

 private:
  const void* body_;
  void (*call_)(const void* of, std::size_t begin, std::size_t end);
};

// Calls body(begin, end) for consecutive ranges that cover [0, count). The ranges are at most
// `grain` long and depend on count and grain alone, never on the number of threads: a body that
// writes only to slots of its own range gives the same bits for any number of threads.
void parallel_ranges(std::size_t count, std::size_t grain, RangeBody body);

}  // namespace ribbon

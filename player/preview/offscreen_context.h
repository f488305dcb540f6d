// OpenGL without a display: by OSMesa, which draws with the processor.
#pragma once

#include <memory>

#include "result/result.h"

namespace ribbon {

class OffscreenContext {
 public:
  // OpenGL 3.3, core profile, by at most so many threads (0: as many as there are cores; counts for
  // the first context of a process). Fails where OSMesa is not installed or cannot do it.
  static Result<OffscreenContext> create(int threads);

  OffscreenContext(OffscreenContext&&) noexcept;
  OffscreenContext& operator=(OffscreenContext&&) noexcept;
  ~OffscreenContext();

  // What this thread calls from now on belongs to this context. To be called before any drawing.
  void make_current() const;

  // A function of OpenGL, to be cast to its type; nullptr where there is none of that name.
  using Function = void (*)();
  [[nodiscard]] Function function(const char* name) const;

 private:
  struct State;
  explicit OffscreenContext(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace ribbon

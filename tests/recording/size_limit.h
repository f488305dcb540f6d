// A disk that fills up.
#pragma once

#include <sys/resource.h>

#include <csignal>
#include <cstdint>

namespace ribbon {

// Files of this process end at `bytes` while one of these lives: a write beyond stops half-way and
// the next one fails, as on a full disk.
class SizeLimit {
 public:
  explicit SizeLimit(std::uint64_t bytes) {
    previous_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &previous_);
    const rlimit limit{bytes, previous_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;
  ~SizeLimit() {
    setrlimit(RLIMIT_FSIZE, &previous_);
    std::signal(SIGXFSZ, previous_handler_);
  }

 private:
  rlimit previous_{};
  void (*previous_handler_)(int) = nullptr;
};

}  // namespace ribbon

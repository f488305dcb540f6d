// A file without a name, for readers that want one.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/must.h"

namespace ribbon {

class MemoryFile {
 public:
  explicit MemoryFile(const char* what) : descriptor_(memfd_create(what, 0)) {
    must(descriptor_ >= 0, "there are files in memory");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  void append(const std::uint8_t* data, std::size_t size) const {
    must(write(descriptor_, data, size) == static_cast<ssize_t>(size), "memory files take bytes");
  }
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace ribbon

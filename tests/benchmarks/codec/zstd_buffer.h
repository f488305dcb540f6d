// One buffer through zstd and back.
#pragma once

#include <memory>
#include <span>
#include <vector>

namespace ribbon {

class ZstdBuffer {
 public:
  explicit ZstdBuffer(int level);
  ~ZstdBuffer();
  ZstdBuffer(const ZstdBuffer&) = delete;
  ZstdBuffer& operator=(const ZstdBuffer&) = delete;

  // The bytes that are kept.
  std::size_t compress(std::span<const unsigned char> content);
  // content: as long as what was compressed.
  void decompress(std::span<unsigned char> content);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon

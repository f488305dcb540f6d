#include "benchmarks/codec/zstd_buffer.h"

#include <zstd.h>

namespace ribbon {

struct ZstdBuffer::State {
  explicit State(int its_level) : level(its_level) {}

  int level;
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> compressor{ZSTD_createCCtx(), ZSTD_freeCCtx};
  std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> decompressor{ZSTD_createDCtx(),
                                                                    ZSTD_freeDCtx};
  std::vector<unsigned char> bytes;
  std::size_t size = 0;
};

ZstdBuffer::ZstdBuffer(int level) : state_(std::make_unique<State>(level)) {}
ZstdBuffer::~ZstdBuffer() = default;

std::size_t ZstdBuffer::compress(std::span<const unsigned char> content) {
  State& s = *state_;
  s.bytes.resize(ZSTD_compressBound(content.size()));
  s.size = ZSTD_compressCCtx(s.compressor.get(), s.bytes.data(), s.bytes.size(), content.data(),
                             content.size(), s.level);
  return s.size;
}

void ZstdBuffer::decompress(std::span<unsigned char> content) {
  State& s = *state_;
  ZSTD_decompressDCtx(s.decompressor.get(), content.data(), content.size(), s.bytes.data(), s.size);
}

}  // namespace ribbon

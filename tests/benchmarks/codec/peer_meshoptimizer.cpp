#include <meshoptimizer.h>

#include <cassert>

#include "benchmarks/codec/integer_codec.h"
#include "benchmarks/codec/peers.h"
#include "benchmarks/codec/zstd_buffer.h"

namespace ribbon {

namespace {

constexpr std::size_t vertex_bytes = 3 * sizeof(std::uint32_t);

// Each frame is a vertex buffer of its own, behind one another.
class VertexCodec : public IntegerCodec {
 public:
  // zstd_level 0: without zstd.
  VertexCodec(float step, TimeDifference difference, SignForm sign, int zstd_level)
      : IntegerCodec(Layout::interleaved, step, difference, sign),
        zstd_(zstd_level),
        has_zstd_(zstd_level != 0) {}

 private:
  std::size_t pack(std::span<const std::uint32_t> residuals) override {
    const std::size_t vertices = frame_values() / 3;
    sizes_.clear();
    bytes_.resize(meshopt_encodeVertexBufferBound(vertices, vertex_bytes) *
                  (residuals.size() / frame_values()));
    std::size_t end = 0;
    for (std::size_t at = 0; at < residuals.size(); at += frame_values()) {
      sizes_.push_back(meshopt_encodeVertexBuffer(&bytes_[end], bytes_.size() - end, &residuals[at],
                                                  vertices, vertex_bytes));
      end += sizes_.back();
    }
    bytes_.resize(end);
    const std::size_t table = sizes_.size() * sizeof(std::uint32_t);
    return table + (has_zstd_ ? zstd_.compress(bytes_) : end);
  }

  void unpack(std::span<std::uint32_t> residuals) override {
    if (has_zstd_) zstd_.decompress(bytes_);
    std::size_t begin = 0;
    for (std::size_t frame = 0; frame < sizes_.size(); ++frame) {
      [[maybe_unused]] const int failed =
          meshopt_decodeVertexBuffer(&residuals[frame * frame_values()], frame_values() / 3,
                                     vertex_bytes, &bytes_[begin], sizes_[frame]);
      assert(failed == 0);
      begin += sizes_[frame];
    }
  }

  ZstdBuffer zstd_;
  bool has_zstd_;
  std::vector<unsigned char> bytes_;
  std::vector<std::size_t> sizes_;  // of each frame
};

}  // namespace

std::vector<CodecRow> meshoptimizer_rows() {
  return {{.name = "meshoptimizer", .settings = integer_settings<VertexCodec>(0)},
          {.name = "meshoptimizer + zstd 3", .settings = integer_settings<VertexCodec>(3)}};
}

}  // namespace ribbon

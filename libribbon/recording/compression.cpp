#include "recording/compression.h"

#include <zstd.h>

#include <algorithm>
#include <cassert>

namespace ribbon {

namespace {

// What is compressed here is mostly noise. Its entropy coding is all the gain there is; repetitions
// are accidents whose description costs more than it saves. Long matches only and a tiny table
// leave those that are real, such as a ribbon at rest.
constexpr int level = 1;
constexpr int shortest_match = 7;
constexpr int match_table_log = 6;

// Above every window that this level uses; a file that asks for more memory is not one of ours.
constexpr int largest_window_log = 23;

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

}  // namespace

struct Compressor::State {
  std::unique_ptr<ZSTD_CCtx, FreeContext> context{ZSTD_createCCtx()};
};

Compressor::Compressor() : state_(std::make_unique<State>()) {
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_contentSizeFlag, 0);
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_minMatch, shortest_match);
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_hashLog, match_table_log);
}
Compressor::Compressor(Compressor&&) noexcept = default;
Compressor& Compressor::operator=(Compressor&&) noexcept = default;
Compressor::~Compressor() = default;

std::string Compressor::compress(std::span<const std::string_view> parts) {
  std::size_t room = 64;
  for (const std::string_view part : parts) room += ZSTD_compressBound(part.size()) + 16;
  std::string bytes(room, '\0');
  ZSTD_outBuffer out{bytes.data(), bytes.size(), 0};
  ZSTD_CCtx_reset(state_->context.get(), ZSTD_reset_session_only);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    ZSTD_inBuffer in{parts[i].data(), parts[i].size(), 0};
    const auto end = i + 1 == parts.size() ? ZSTD_e_end : ZSTD_e_flush;
    [[maybe_unused]] const std::size_t left =
        ZSTD_compressStream2(state_->context.get(), &out, &in, end);
    assert(left == 0);  // the room is enough for the worst case
  }
  bytes.resize(out.pos);
  return bytes;
}

struct Decompressor::State {
  std::unique_ptr<ZSTD_DCtx, FreeContext> context{ZSTD_createDCtx()};
  std::string content;
};

Decompressor::Decompressor() : state_(std::make_unique<State>()) {
  ZSTD_DCtx_setParameter(state_->context.get(), ZSTD_d_windowLogMax, largest_window_log);
}
Decompressor::Decompressor(Decompressor&&) noexcept = default;
Decompressor& Decompressor::operator=(Decompressor&&) noexcept = default;
Decompressor::~Decompressor() = default;

std::optional<std::string_view> Decompressor::decompress(std::string_view bytes,
                                                         std::size_t limit) {
  std::string& content = state_->content;
  ZSTD_DCtx_reset(state_->context.get(), ZSTD_reset_session_only);
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t filled = 0;
  while (true) {
    // One byte more than allowed, so that a frame that holds too much is noticed.
    if (filled == content.size())
      content.resize(std::min(limit + 1, std::max<std::size_t>(2 * content.size(), 1 << 16)));
    if (filled > limit) return std::nullopt;
    ZSTD_outBuffer out{content.data(), content.size(), filled};
    const std::size_t left = ZSTD_decompressStream(state_->context.get(), &out, &in);
    const bool stuck = in.pos == in.size && out.pos < out.size;
    filled = out.pos;
    if (ZSTD_isError(left) != 0) return std::nullopt;
    if (left == 0) break;
    if (stuck) return std::nullopt;  // cut off
  }
  if (in.pos != in.size || filled > limit) return std::nullopt;
  return std::string_view(content).substr(0, filled);
}

}  // namespace ribbon

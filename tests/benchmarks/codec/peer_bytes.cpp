// Codecs of bytes. Levels of zstd: 3 is what it does unasked, 19 the strongest without much memory.
#include <cstring>
#include <string>

#include "benchmarks/codec/integer_codec.h"
#include "benchmarks/codec/peers.h"
#include "benchmarks/codec/zstd_buffer.h"

namespace ribbon {

namespace {

class Copy : public FrameCodec {
 public:
  void take(FrameSpan frames) override {
    floats_.take(frames);
    kept_.resize(floats_.values().size());
  }
  std::size_t encode() override {
    kept_ = floats_.values();
    return kept_.size() * sizeof(float);
  }
  void decode() override {
    std::memcpy(floats_.decoded().data(), kept_.data(), kept_.size() * sizeof(float));
  }
  [[nodiscard]] Eigen::Matrix3Xf decoded(int index) const override {
    return floats_.decoded(index);
  }

 private:
  FloatGroup floats_{Layout::interleaved};
  std::vector<float> kept_;
};

class ZstdAlone : public FrameCodec {
 public:
  ZstdAlone(Layout layout, int level) : floats_(layout), zstd_(level) {}

  void take(FrameSpan frames) override { floats_.take(frames); }
  std::size_t encode() override {
    const auto* bytes = reinterpret_cast<const unsigned char*>(floats_.values().data());
    return zstd_.compress({bytes, floats_.values().size() * sizeof(float)});
  }
  void decode() override {
    auto* bytes = reinterpret_cast<unsigned char*>(floats_.decoded().data());
    zstd_.decompress({bytes, floats_.decoded().size() * sizeof(float)});
  }
  [[nodiscard]] Eigen::Matrix3Xf decoded(int index) const override {
    return floats_.decoded(index);
  }

 private:
  FloatGroup floats_;
  ZstdBuffer zstd_;
};

class ShuffledZstd : public IntegerCodec {
 public:
  ShuffledZstd(float step, TimeDifference difference, SignForm sign, int level)
      : IntegerCodec(Layout::planar, step, difference, sign), zstd_(level) {}

 private:
  std::size_t pack(std::span<const std::uint32_t> residuals) override {
    planes_.resize(4 * residuals.size());
    part_bytes(residuals, planes_);
    return zstd_.compress(planes_);
  }
  void unpack(std::span<std::uint32_t> residuals) override {
    zstd_.decompress(planes_);
    join_bytes(planes_, residuals);
  }

  ZstdBuffer zstd_;
  std::vector<unsigned char> planes_;
};

CodecRow::Make lossless(std::function<std::unique_ptr<FrameCodec>()> make) {
  return [make = std::move(make)](const CodecTask& task) {
    return task.bound_m == 0 ? make() : nullptr;
  };
}

CodecRow zstd_alone(int level) {
  CodecRow row{.name = "zstd " + std::to_string(level)};
  for (const Layout layout : {Layout::planar, Layout::interleaved})
    row.settings.push_back(lossless([=] { return std::make_unique<ZstdAlone>(layout, level); }));
  return row;
}

// The floats as they are.
CodecRow shuffled_floats(int level) {
  return {.name = "byte shuffle + zstd " + std::to_string(level),
          .settings = {lossless([=] {
            return std::make_unique<ShuffledZstd>(0.0F, TimeDifference::none, SignForm::zigzag,
                                                  level);
          })}};
}

CodecRow shuffled_integers(int level) {
  return {.name = "integers, time difference, byte shuffle + zstd " + std::to_string(level),
          .settings = integer_settings<ShuffledZstd>(level)};
}

}  // namespace

std::vector<CodecRow> byte_rows() {
  std::vector<CodecRow> rows;
  rows.push_back(
      {.name = "memcpy", .settings = {lossless([] { return std::make_unique<Copy>(); })}});
  for (const int level : {3, 19}) rows.push_back(zstd_alone(level));
  for (const int level : {3, 19}) rows.push_back(shuffled_floats(level));
  for (const int level : {3, 19}) rows.push_back(shuffled_integers(level));
  return rows;
}

}  // namespace ribbon

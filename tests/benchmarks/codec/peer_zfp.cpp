#include <zfp.h>

#include <cassert>
#include <memory>

#include "benchmarks/codec/float_group.h"
#include "benchmarks/codec/peers.h"

namespace ribbon {

namespace {

using Field = std::unique_ptr<zfp_field, decltype(&zfp_field_free)>;
using Stream = std::unique_ptr<zfp_stream, decltype(&zfp_stream_close)>;
using BitStream = std::unique_ptr<bitstream, decltype(&stream_close)>;

// Each component by itself: of each frame (2D), or of all frames of the group at once (3D).
class Zfp : public FrameCodec {
 public:
  // tolerance_m 0: reversible.
  Zfp(const RibbonGrid& grid, bool takes_time, double tolerance_m)
      : grid_(grid), takes_time_(takes_time), tolerance_m_(tolerance_m) {}

  void take(FrameSpan frames) override {
    floats_.take(frames);
    const Stream stream = make_stream(nullptr);
    const Field field = make_field(floats_.values().data());
    bytes_.resize(zfp_stream_maximum_size(stream.get(), field.get()) * fields());
  }

  std::size_t encode() override {
    const BitStream bits{stream_open(bytes_.data(), bytes_.size()), stream_close};
    const Stream stream = make_stream(bits.get());
    zfp_stream_rewind(stream.get());
    std::size_t size = 0;
    for (int f = 0; f < fields(); ++f)
      size = zfp_compress(stream.get(), make_field(&floats_.values()[begin(f)]).get());
    return size;
  }

  void decode() override {
    const BitStream bits{stream_open(bytes_.data(), bytes_.size()), stream_close};
    const Stream stream = make_stream(bits.get());
    zfp_stream_rewind(stream.get());
    for (int f = 0; f < fields(); ++f) {
      [[maybe_unused]] const std::size_t read =
          zfp_decompress(stream.get(), make_field(&floats_.decoded()[begin(f)]).get());
      assert(read != 0);
    }
  }

  [[nodiscard]] Eigen::Matrix3Xf decoded(int index) const override {
    return floats_.decoded(index);
  }

 private:
  [[nodiscard]] int fields() const { return takes_time_ ? 3 : 3 * floats_.frames(); }
  [[nodiscard]] std::size_t begin(int field) const {
    return static_cast<std::size_t>(field) * static_cast<std::size_t>(grid_.particle_count());
  }

  [[nodiscard]] Stream make_stream(bitstream* bits) const {
    Stream stream{zfp_stream_open(bits), zfp_stream_close};
    if (tolerance_m_ > 0)
      zfp_stream_set_accuracy(stream.get(), tolerance_m_);
    else
      zfp_stream_set_reversible(stream.get());
    return stream;
  }

  // Frames follow one another with two other components in between.
  [[nodiscard]] Field make_field(float* values) const {
    const auto across = static_cast<std::size_t>(grid_.across);
    const auto along = static_cast<std::size_t>(grid_.along);
    if (!takes_time_) return {zfp_field_2d(values, zfp_type_float, across, along), zfp_field_free};
    Field field{zfp_field_3d(values, zfp_type_float, across, along, floats_.frames()),
                zfp_field_free};
    zfp_field_set_stride_3d(field.get(), 1, grid_.across,
                            std::ptrdiff_t{3} * grid_.particle_count());
    return field;
  }

  FloatGroup floats_{Layout::planar};
  RibbonGrid grid_;
  bool takes_time_;
  double tolerance_m_;
  std::vector<unsigned char> bytes_;
};

CodecRow::Make with_tolerance(bool takes_time, double times_bound) {
  return [=](const CodecTask& task) -> std::unique_ptr<FrameCodec> {
    return std::make_unique<Zfp>(task.grid, takes_time, times_bound * task.bound_m);
  };
}

}  // namespace

std::vector<CodecRow> zfp_rows() {
  std::vector<CodecRow> rows;
  for (const bool takes_time : {false, true}) {
    const std::string name = takes_time ? "zfp 3D" : "zfp 2D";
    rows.push_back(
        {.name = name + ", tolerance = bound", .settings = {with_tolerance(takes_time, 1)}});
    // It counts in powers of two, so doubles find the best.
    CodecRow tuned{.name = name + ", best tolerance"};
    for (const double times_bound : {1, 2, 4, 8, 16, 32})
      tuned.settings.push_back(with_tolerance(takes_time, times_bound));
    rows.push_back(tuned);
  }
  return rows;
}

}  // namespace ribbon

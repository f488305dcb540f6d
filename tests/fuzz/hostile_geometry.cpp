// Whatever the bytes, the decoder answers with a whole frame or with none.

#include "fuzz/fuzz_input.h"
#include "fuzz/must.h"
#include "fuzz/reference_frames.h"
#include "recording/codec/position_decoder.h"
#include "recording/codec/position_encoder.h"

namespace ribbon {
namespace {

void decode(const CodecParameters& parameters, bool is_predicted, FrameEncoding encoding,
            std::string_view geometry) {
  const QuantisedFrame before = reference_frame(parameters);
  QuantisedFrame decoded;
  if (!PositionDecoder(parameters)
           .decode(encoding, geometry, is_predicted ? &before : nullptr, decoded))
    return;
  Eigen::Matrix3Xf positions;
  decoded.positions(positions);
  must(positions.cols() == parameters.grid.particle_count(), "a decoded frame has all particles");
}

}  // namespace
}  // namespace ribbon

// libFuzzer gives the name. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ribbon;
  FuzzInput input(data, size);
  const int along = input.between(2, 48);
  const int across = input.between(2, 33);
  const bool uniform = input.between(0, 3) > 0;
  const auto encoding = static_cast<FrameEncoding>(input.between(0, 1));
  const bool is_predicted = input.between(0, 1) > 0;
  const ExactCopy geometry(input.rest());
  decode(parameters_for({along, across}, uniform), is_predicted, encoding, geometry.view());
  return 0;
}

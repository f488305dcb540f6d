// Residuals as bytes: small numbers near zero, sorted by how large they probably are.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/prediction.h"

namespace ribbon {

// One plane per component; a border as in Field, unused.
using Residuals = std::array<Field, 3>;

// How large residuals have been lately at each particle: what was restless will be restless. Both
// sides keep it, so that residuals of different size are packed apart without a word about it.
class Activity {
 public:
  static constexpr int classes = 8;

  explicit Activity(const PaddedGrid& grid);
  void forget();  // before each key frame
  void remember(const Residuals& residuals);
  // The class of a particle's residual: 0 where residuals have been smallest.
  [[nodiscard]] int expected_class(int component, std::size_t at) const;

 private:
  PaddedGrid grid_;
  std::array<std::vector<std::uint16_t>, 3> recent_;
  std::array<std::vector<std::uint8_t>, 3> class_;
};

// Parts for the compressor, to be followed by nothing else.
std::vector<std::string> pack_residuals(const PaddedGrid& grid, const Activity& activity,
                                        const Residuals& residuals);

// The inverse, from the parts one after the other. False where `bytes` does not hold exactly the
// residuals of a whole frame.
bool unpack_residuals(const PaddedGrid& grid, const Activity& activity, std::string_view bytes,
                      Residuals& residuals);

// More bytes than the parts of a valid frame ever have together.
std::size_t packed_residuals_limit(const PaddedGrid& grid);

// Numbers of any size, seven bits to a byte, low bits first, the high bit set on all but the last.
void put_varint(std::string& bytes, std::uint32_t number);
std::optional<std::uint32_t> take_varint(std::string_view& bytes);

// 0 -1 1 -2 2 ... as 0 1 2 3 4 ...
inline std::uint32_t zigzag(std::int32_t number) {
  return (static_cast<std::uint32_t>(number) << 1) ^ static_cast<std::uint32_t>(number >> 31);
}
inline std::int32_t unzigzag(std::uint32_t number) {
  return static_cast<std::int32_t>((number >> 1) ^ (0 - (number & 1)));
}

}  // namespace ribbon

#include "recording/residuals.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace ribbon {

namespace {

constexpr std::uint32_t escape = 255;

template <class Visit>
void for_each_particle(const PaddedGrid& grid, Visit visit) {
  for (int i = 0; i < grid.along; ++i)
    for (std::size_t at = grid.at(i, 0); at < grid.at(i, grid.across); ++at) visit(at);
}

// Low bits that are noise anyway, side by side.
class BitPacker {
 public:
  void put_bits(std::uint32_t number, int count) {
    pending_ |= static_cast<std::uint64_t>(number & ((std::uint64_t{1} << count) - 1)) << filled_;
    for (filled_ += count; filled_ >= 8; filled_ -= 8, pending_ >>= 8)
      bytes_.push_back(static_cast<char>(static_cast<std::uint8_t>(pending_)));
  }
  std::string finish() {
    if (filled_ > 0) put_bits(0, 8 - filled_);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  std::uint64_t pending_ = 0;
  int filled_ = 0;
};

class BitTaker {
 public:
  explicit BitTaker(std::string_view bytes) : bytes_(bytes) {}
  // Zeros beyond the end.
  std::uint32_t take_bits(int count) {
    for (; filled_ < count; filled_ += 8) {
      const std::uint64_t byte =
          next_ < bytes_.size() ? static_cast<std::uint8_t>(bytes_[next_]) : 0;
      ++next_;
      pending_ |= byte << filled_;
    }
    const auto number = static_cast<std::uint32_t>(pending_ & ((std::uint64_t{1} << count) - 1));
    pending_ >>= count;
    filled_ -= count;
    return number;
  }

 private:
  std::string_view bytes_;
  std::size_t next_ = 0;
  std::uint64_t pending_ = 0;
  int filled_ = 0;
};

struct Members {
  std::array<std::uint64_t, Activity::classes> count{};
  std::array<std::uint64_t, Activity::classes> sum{};  // of the residuals, zigzagged
};

Members members(const PaddedGrid& grid, const Activity& activity, const Residuals* residuals) {
  Members result;
  for (int component = 0; component < 3; ++component)
    for_each_particle(grid, [&](std::size_t at) {
      const auto c = static_cast<std::size_t>(activity.expected_class(component, at));
      ++result.count[c];
      if (residuals) result.sum[c] += zigzag((*residuals)[static_cast<std::size_t>(component)][at]);
    });
  return result;
}

}  // namespace

Activity::Activity(const PaddedGrid& grid) : grid_(grid) {
  forget();
}

void Activity::forget() {
  for (auto& plane : recent_) plane.assign(grid_.size(), 0);
  for (auto& plane : class_) plane.assign(grid_.size(), 0);
}

void Activity::remember(const Residuals& residuals) {
  const auto stride = static_cast<std::size_t>(grid_.stride);
  for (std::size_t component = 0; component < 3; ++component) {
    auto& recent = recent_[component];
    for_each_particle(grid_, [&](std::size_t at) {
      const auto size = std::min<std::uint32_t>(
          zigzag(residuals[component][at]) / 2 + zigzag(residuals[component][at]) % 2, 2047);
      recent[at] = static_cast<std::uint16_t>((recent[at] + 16 * size + 1) / 2);
    });
    for_each_particle(grid_, [&](std::size_t at) {
      const auto around =
          static_cast<std::uint32_t>(2 * recent[at] + recent[at - stride] + recent[at + stride] +
                                     recent[at - 1] + recent[at + 1]);
      class_[component][at] = static_cast<std::uint8_t>(
          std::clamp(static_cast<int>(std::bit_width(around)) - 4, 0, classes - 1));
    });
  }
}

int Activity::expected_class(int component, std::size_t at) const {
  return class_[static_cast<std::size_t>(component)][at];
}

std::vector<std::string> pack_residuals(const PaddedGrid& grid, const Activity& activity,
                                        const Residuals& residuals) {
  const Members members_of = members(grid, activity, &residuals);
  std::vector<std::string> parts(Activity::classes + 3);
  std::array<int, Activity::classes> low_bits{};
  for (std::size_t c = 0; c < low_bits.size(); ++c) {
    const std::uint64_t mean = members_of.count[c] ? members_of.sum[c] / members_of.count[c] : 0;
    low_bits[c] = std::max(0, static_cast<int>(std::bit_width(mean)) - 5);
    parts[0].push_back(static_cast<char>(low_bits[c]));
    parts[c + 1].reserve(members_of.count[c]);
  }
  BitPacker packer;
  std::string& escapes = parts[Activity::classes + 1];
  for (int component = 0; component < 3; ++component)
    for_each_particle(grid, [&](std::size_t at) {
      const auto c = static_cast<std::size_t>(activity.expected_class(component, at));
      const std::uint32_t number = zigzag(residuals[static_cast<std::size_t>(component)][at]);
      const std::uint32_t high = number >> low_bits[c];
      parts[c + 1].push_back(static_cast<char>(std::min(high, escape)));
      if (high >= escape) put_varint(escapes, high - escape);
      packer.put_bits(number, low_bits[c]);
    });
  parts.back() = packer.finish();
  return parts;
}

bool unpack_residuals(const PaddedGrid& grid, const Activity& activity, std::string_view bytes,
                      Residuals& residuals) {
  const Members members_of = members(grid, activity, nullptr);
  if (bytes.size() < Activity::classes) return false;
  std::array<int, Activity::classes> low_bits{};
  for (int& bits : low_bits) {
    bits = static_cast<std::uint8_t>(bytes.front());
    bytes.remove_prefix(1);
    if (bits > 31) return false;
  }
  std::array<const char*, Activity::classes> next{};
  std::size_t escape_count = 0;
  std::uint64_t packed_bits = 0;
  for (std::size_t c = 0; c < next.size(); ++c) {
    if (bytes.size() < members_of.count[c]) return false;
    const std::string_view symbols = bytes.substr(0, members_of.count[c]);
    escape_count += static_cast<std::size_t>(std::count(symbols.begin(), symbols.end(), '\xFF'));
    packed_bits += members_of.count[c] * static_cast<std::uint64_t>(low_bits[c]);
    next[c] = symbols.data();
    bytes.remove_prefix(symbols.size());
  }
  std::vector<std::uint32_t> escapes(escape_count);
  for (std::uint32_t& number : escapes) {
    const auto taken = take_varint(bytes);
    if (!taken) return false;
    number = *taken;
  }
  if (bytes.size() != (packed_bits + 7) / 8) return false;
  BitTaker taker(bytes);
  auto escaped = escapes.begin();
  for (int component = 0; component < 3; ++component) {
    Field& plane = residuals[static_cast<std::size_t>(component)];
    plane.resize(grid.size());
    for_each_particle(grid, [&](std::size_t at) {
      const auto c = static_cast<std::size_t>(activity.expected_class(component, at));
      std::uint32_t high = static_cast<std::uint8_t>(*next[c]++);
      if (high == escape) high += *escaped++;
      plane[at] = unzigzag((high << low_bits[c]) | taker.take_bits(low_bits[c]));
    });
  }
  return true;
}

std::size_t packed_residuals_limit(const PaddedGrid& grid) {
  // A symbol, a varint and four bytes of low bits per number.
  return Activity::classes + 3 * grid.size() * 10;
}

void put_varint(std::string& bytes, std::uint32_t number) {
  for (; number >= 0x80; number >>= 7)
    bytes.push_back(static_cast<char>(static_cast<std::uint8_t>(number | 0x80)));
  bytes.push_back(static_cast<char>(number));
}

std::optional<std::uint32_t> take_varint(std::string_view& bytes) {
  std::uint32_t number = 0;
  for (int shift = 0; shift < 35; shift += 7) {
    if (bytes.empty()) return std::nullopt;
    const auto byte = static_cast<std::uint8_t>(bytes.front());
    bytes.remove_prefix(1);
    number |= static_cast<std::uint32_t>(byte & 0x7F) << shift;
    if (byte < 0x80) return number;
  }
  return std::nullopt;
}

}  // namespace ribbon

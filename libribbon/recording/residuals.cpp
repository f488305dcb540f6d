#include "recording/residuals.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace ribbon {

namespace {

// How the residuals of one class lie in bytes.
struct Form {
  int low_bits = 0;          // these go elsewhere, one beside the other
  int symbols_per_byte = 1;  // of the rest: 1, 2 or 4

  [[nodiscard]] int symbol_bits() const { return 8 / symbols_per_byte; }
  // Stands for itself and everything above.
  [[nodiscard]] std::uint32_t escape() const { return (std::uint32_t{1} << symbol_bits()) - 1; }
  [[nodiscard]] std::uint64_t bytes(std::uint64_t symbols) const {
    const auto per_byte = static_cast<std::uint64_t>(symbols_per_byte);
    return (symbols + per_byte - 1) / per_byte;
  }
};

// Entropy coding spends at least one bit on a byte, so numbers that are nearly always zero share
// one; of large numbers it sees only the part that is not noise.
Form form_for(double mean) {
  if (mean < 0.5) return {0, 4};
  if (mean < 2) return {0, 2};
  return {std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(mean))) - 5), 1};
}

// One byte in the stream: the number of low bits, or 32 for two and 33 for four symbols a byte.
std::uint8_t form_code(const Form& form) {
  if (form.symbols_per_byte == 1) return static_cast<std::uint8_t>(form.low_bits);
  return form.symbols_per_byte == 2 ? 32 : 33;
}

std::optional<Form> form_of_code(std::uint8_t code) {
  if (code < 32) return Form{code, 1};
  if (code == 32) return Form{0, 2};
  if (code == 33) return Form{0, 4};
  return std::nullopt;
}

// Symbols that lie one to a byte, several to a byte; the first in the lowest bits.
std::string packed(std::string_view symbols, const Form& form) {
  std::string bytes(form.bytes(symbols.size()), '\0');
  const auto per_byte = static_cast<std::size_t>(form.symbols_per_byte);
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const int shift = static_cast<int>(i % per_byte) * form.symbol_bits();
    bytes[i / per_byte] = static_cast<char>(static_cast<std::uint8_t>(bytes[i / per_byte]) |
                                            (static_cast<std::uint8_t>(symbols[i]) << shift));
  }
  return bytes;
}

std::string unpacked(std::string_view bytes, const Form& form, std::uint64_t count) {
  std::string symbols(count, '\0');
  const auto per_byte = static_cast<std::size_t>(form.symbols_per_byte);
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const int shift = static_cast<int>(i % per_byte) * form.symbol_bits();
    symbols[i] = static_cast<char>((static_cast<std::uint8_t>(bytes[i / per_byte]) >> shift) &
                                   form.escape());
  }
  return symbols;
}

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
          std::clamp(static_cast<int>(std::bit_width(around)) - 5, 0, classes - 1));
    });
  }
}

int Activity::expected_class(int component, std::size_t at) const {
  return class_[static_cast<std::size_t>(component)][at];
}

std::vector<std::string> pack_residuals(const PaddedGrid& grid, const Activity& activity,
                                        const Residuals& residuals) {
  const Members members_of = members(grid, activity, &residuals);
  std::array<Form, Activity::classes> forms;
  std::array<std::string, Activity::classes> symbols;
  for (std::size_t c = 0; c < forms.size(); ++c) {
    const auto count = static_cast<double>(std::max<std::uint64_t>(members_of.count[c], 1));
    forms[c] = form_for(static_cast<double>(members_of.sum[c]) / count);
    symbols[c].reserve(members_of.count[c]);
  }
  BitPacker packer;
  std::string escapes;
  for (int component = 0; component < 3; ++component)
    for_each_particle(grid, [&](std::size_t at) {
      const auto c = static_cast<std::size_t>(activity.expected_class(component, at));
      const std::uint32_t number = zigzag(residuals[static_cast<std::size_t>(component)][at]);
      const std::uint32_t high = number >> forms[c].low_bits;
      const std::uint32_t escape = forms[c].escape();
      symbols[c].push_back(static_cast<char>(std::min(high, escape)));
      if (high >= escape) put_varint(escapes, high - escape);
      packer.put_bits(number, forms[c].low_bits);
    });
  std::vector<std::string> parts(1);
  for (std::size_t c = 0; c < forms.size(); ++c) {
    parts[0].push_back(static_cast<char>(form_code(forms[c])));
    parts.push_back(packed(symbols[c], forms[c]));
  }
  parts.push_back(std::move(escapes));
  parts.push_back(packer.finish());
  return parts;
}

bool unpack_residuals(const PaddedGrid& grid, const Activity& activity, std::string_view bytes,
                      Residuals& residuals) {
  const Members members_of = members(grid, activity, nullptr);
  std::array<Form, Activity::classes> forms;
  if (bytes.size() < forms.size()) return false;
  for (Form& form : forms) {
    const auto known = form_of_code(static_cast<std::uint8_t>(bytes.front()));
    bytes.remove_prefix(1);
    if (!known) return false;
    form = *known;
  }
  std::array<std::string, Activity::classes> symbols;
  std::size_t escape_count = 0;
  std::uint64_t low_bits = 0;
  for (std::size_t c = 0; c < forms.size(); ++c) {
    const std::uint64_t size = forms[c].bytes(members_of.count[c]);
    if (bytes.size() < size) return false;
    symbols[c] = unpacked(bytes.substr(0, size), forms[c], members_of.count[c]);
    bytes.remove_prefix(size);
    escape_count += static_cast<std::size_t>(
        std::count(symbols[c].begin(), symbols[c].end(), static_cast<char>(forms[c].escape())));
    low_bits += members_of.count[c] * static_cast<std::uint64_t>(forms[c].low_bits);
  }
  std::vector<std::uint32_t> escapes(escape_count);
  for (std::uint32_t& number : escapes) {
    const auto taken = take_varint(bytes);
    if (!taken) return false;
    number = *taken;
  }
  if (bytes.size() != (low_bits + 7) / 8) return false;
  BitTaker taker(bytes);
  auto escaped = escapes.begin();
  std::array<const char*, Activity::classes> next{};
  for (std::size_t c = 0; c < next.size(); ++c) next[c] = symbols[c].data();
  for (int component = 0; component < 3; ++component) {
    Field& plane = residuals[static_cast<std::size_t>(component)];
    plane.resize(grid.size());
    for_each_particle(grid, [&](std::size_t at) {
      const auto c = static_cast<std::size_t>(activity.expected_class(component, at));
      std::uint32_t high = static_cast<std::uint8_t>(*next[c]++);
      if (high == forms[c].escape()) high += *escaped++;
      plane[at] = unzigzag((high << forms[c].low_bits) | taker.take_bits(forms[c].low_bits));
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

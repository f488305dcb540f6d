#include "converter/read_back/ogawa_tree.h"

#include <string_view>

#include "converter/read_back/written_motion.h"
#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

constexpr std::uint64_t data_bit = std::uint64_t{1} << 63U;
constexpr std::uint64_t key_bytes = 16;

// How wide a header's numbers are is told by two bits of it.
std::uint32_t take_hinted(ByteTaker& taker, std::uint32_t hint) {
  if (hint == 0) return taker.take<std::uint8_t>();
  return hint == 1 ? taker.take<std::uint16_t>() : taker.take<std::uint32_t>();
}

OgawaProperty take_property(ByteTaker& headers, std::uint64_t group) {
  const auto info = headers.take<std::uint32_t>();
  const std::uint32_t kind = info & 3U;
  const std::uint32_t hint = info >> 2U & 3U;
  demand(hint < 3, "a header of unknown width");
  OgawaProperty property{.group = group,
                         .is_compound = kind == 0,
                         .is_array = kind >= 2,
                         .is_constant = (info & 0x800U) != 0,
                         .number = info >> 4U & 15U,
                         .extent = info >> 12U & 255U};
  if (kind != 0) property.samples = take_hinted(headers, hint);
  if ((info & 0x100U) != 0) property.times = take_hinted(headers, hint);
  property.name = headers.take_bytes(take_hinted(headers, hint));
  demand(headers.complete(), "a header that ends too early");
  return property;
}

}  // namespace

OgawaTree::OgawaTree(const std::filesystem::path& path) : bytes_(path) {
  demand(bytes_.at(0, 8) == std::string_view("Ogawa\xff\0\1", 8), "not a finished Ogawa file");
  const auto root = group(bytes_.number<std::uint64_t>(8));
  demand(root.size() == 6, "a root without six parts");
  top_ = root[2];
  const OgawaData table = data(root[4]);
  const std::string text = bytes_.at(table.begin, table.size);
  for (ByteTaker rows(text); !rows.rest().empty();) {
    rows.take<std::uint32_t>();
    OgawaTimes& times = times_.emplace_back();
    times.step_s = rows.take<double>();
    demand(rows.take<std::uint32_t>() == 1, "frames that are not evenly spaced");
    times.start_s = rows.take<double>();
    demand(rows.complete(), "a table of times that ends too early");
  }
}

std::vector<std::uint64_t> OgawaTree::group(std::uint64_t place) const {
  demand((place & data_bit) == 0, "data where a group should be");
  if (place == 0) return {};
  const auto count = bytes_.number<std::uint64_t>(place);
  const Eigen::MatrixX<std::uint64_t> children = bytes_.numbers<std::uint64_t>(place + 8, 1, count);
  return {children.data(), children.data() + children.size()};
}

OgawaData OgawaTree::data(std::uint64_t child) const {
  demand((child & data_bit) != 0, "a group where data should be");
  const std::uint64_t place = child & ~data_bit;
  if (place == 0) return {};
  return {.begin = place + 8, .size = bytes_.number<std::uint64_t>(place)};
}

// A group of an object: its properties, its children, their headers.
std::vector<std::uint64_t> OgawaTree::children(std::uint64_t object) const {
  std::vector<std::uint64_t> parts = group(object);
  demand(parts.size() >= 2, "an object without properties or headers");
  return {parts.begin() + 1, parts.end() - 1};
}

std::uint64_t OgawaTree::properties_of(std::uint64_t object) const {
  const auto parts = group(object);
  demand(!parts.empty(), "an object without properties");
  return parts.front();
}

std::vector<OgawaProperty> OgawaTree::properties(std::uint64_t place) const {
  const auto parts = group(place);
  if (parts.empty()) return {};
  const OgawaData headers = data(parts.back());
  const std::string text = bytes_.at(headers.begin, headers.size);
  ByteTaker taker(text);
  std::vector<OgawaProperty> properties;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
    properties.push_back(take_property(taker, parts[i]));
  demand(taker.rest().empty(), "more headers than properties");
  return properties;
}

// An array's sample is followed by its dimensions, which are not used.
OgawaData OgawaTree::sample(const OgawaProperty& property, int index) const {
  const auto stored = property.is_constant ? 0 : static_cast<std::uint64_t>(index);
  const std::uint64_t slot = stored * (property.is_array ? 2 : 1);
  demand(slot < bytes_.number<std::uint64_t>(property.group), "a sample that is not there");
  OgawaData found = data(bytes_.number<std::uint64_t>(property.group + 8 * (1 + slot)));
  demand(found.size >= key_bytes, "a sample without its key");
  return {.begin = found.begin + key_bytes, .size = found.size - key_bytes};
}

OgawaTimes OgawaTree::times(std::uint32_t row) const {
  demand(row < times_.size(), "a table of times that is too short");
  return times_[row];
}

}  // namespace ribbon

#include "converter/export/alembic_tree.h"

#include <algorithm>
#include <cassert>

#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

// Bits of the first word of a property's header.
constexpr std::uint32_t one_value_a_sample = 1;  // also of an array that happens to be so short
constexpr std::uint32_t is_array = 2;
constexpr std::uint32_t has_time_sampling = 0x100;
constexpr std::uint32_t all_of_one_size = 0x400;
constexpr std::uint32_t is_constant = 0x800;

// How many bytes the counts of a header take: hint 0: one, 1: two, 2: four.
std::uint32_t size_hint(std::size_t largest) {
  return largest < 0x100 ? 0 : (largest < 0x10000 ? 1 : 2);
}

void put_hinted(std::string& bytes, std::uint32_t number, std::uint32_t hint) {
  if (hint == 0)
    put<std::uint8_t>(bytes, static_cast<std::uint8_t>(number));
  else if (hint == 1)
    put<std::uint16_t>(bytes, static_cast<std::uint16_t>(number));
  else
    put<std::uint32_t>(bytes, number);
}

std::string bytes_of(const ContentKey& key) {
  std::string bytes;
  for (const std::uint64_t word : key) put<std::uint64_t>(bytes, word);
  return bytes;
}

std::string joined_headers(const std::vector<AlembicNode>& nodes) {
  std::string headers;
  for (const AlembicNode& node : nodes) headers += node.header;
  return headers;
}

std::vector<OgawaFile::Child> groups_of(const std::vector<AlembicNode>& nodes) {
  std::vector<OgawaFile::Child> groups(nodes.size());
  std::transform(nodes.begin(), nodes.end(), groups.begin(),
                 [](const AlembicNode& node) { return node.group; });
  return groups;
}

// Of what the headers and keys of the nodes say.
ContentKey joined_key(const std::vector<AlembicNode>& nodes) {
  std::string parts = joined_headers(nodes);
  for (const AlembicNode& node : nodes) parts += bytes_of(node.key);
  return content_key(parts);
}

std::size_t number_bytes(PlainType type) {
  return type == PlainType::float64 ? 8 : 4;
}

}  // namespace

std::uint32_t MetadataTable::number_of(std::string_view text) {
  if (text.empty()) return 0;
  auto found = std::find(texts_.begin(), texts_.end(), text);
  if (found == texts_.end()) found = texts_.emplace(found, text);
  assert(texts_.size() < 0xff && text.size() <= 0xff);
  return static_cast<std::uint32_t>(found - texts_.begin()) + 1;
}

std::string MetadataTable::bytes() const {
  std::string bytes;
  for (const std::string& text : texts_) {
    put<std::uint8_t>(bytes, static_cast<std::uint8_t>(text.size()));
    bytes += text;
  }
  return bytes;
}

void SampledProperty::append(OgawaFile& file, std::string_view values) {
  const ContentKey key = content_key(values);
  if (samples_ == 0 || key != sample_key_ || values.size() != sample_bytes_) {
    assert(samples_ == 0 || values.size() == sample_bytes_);
    is_constant_ = samples_ == 0;
    sample_ = file.add_data({bytes_of(key), values});
    sample_bytes_ = values.size();
    sample_key_ = key;
  }
  children_.push_back(sample_);
  if (type_.is_array) children_.push_back(file.add_data({}));  // dimensions: as the size tells
  key_ = content_key(bytes_of(key_) + bytes_of(key));
  ++samples_;
}

void SampledProperty::hold_until(std::uint32_t samples) {
  assert(is_constant_ && samples_ > 0 && samples_ <= samples);
  samples_ = samples;
}

AlembicNode SampledProperty::finish(OgawaFile& file, MetadataTable& metadata) {
  if (is_constant_) children_.resize(type_.is_array ? 2 : 1);
  return {.group = file.add_group(children_), .header = header(metadata), .key = key_};
}

std::string SampledProperty::header(MetadataTable& metadata) const {
  const std::uint32_t hint =
      size_hint(std::max({type_.metadata.size(), type_.name.size(), std::size_t{samples_}}));
  const bool one_value = sample_bytes_ == type_.extent * number_bytes(type_.number);
  std::string bytes;
  put<std::uint32_t>(bytes, (type_.is_array ? is_array : 0) | (one_value ? one_value_a_sample : 0) |
                                hint << 2U | static_cast<std::uint32_t>(type_.number) << 4U |
                                (time_sampling_ > 0 ? has_time_sampling : 0) | all_of_one_size |
                                (is_constant_ ? is_constant : 0) | type_.extent << 12U |
                                metadata.number_of(type_.metadata) << 20U);
  put_hinted(bytes, samples_, hint);
  if (time_sampling_ > 0) put_hinted(bytes, time_sampling_, hint);
  put_hinted(bytes, static_cast<std::uint32_t>(type_.name.size()), hint);
  return bytes.append(type_.name);
}

AlembicNode add_compound(OgawaFile& file, MetadataTable& metadata, std::string_view name,
                         std::string_view kind, const std::vector<AlembicNode>& properties) {
  std::vector<OgawaFile::Child> children = groups_of(properties);
  if (!properties.empty()) children.push_back(file.add_data({joined_headers(properties)}));
  const std::uint32_t hint = size_hint(std::max(kind.size(), name.size()));
  std::string header;
  put<std::uint32_t>(header, hint << 2U | metadata.number_of(kind) << 20U);
  put_hinted(header, static_cast<std::uint32_t>(name.size()), hint);
  header += name;
  return {.group = file.add_group(children), .header = header, .key = joined_key(properties)};
}

AlembicNode add_object(OgawaFile& file, MetadataTable& metadata, std::string_view name,
                       std::string_view kind, const std::vector<AlembicNode>& properties,
                       const std::vector<AlembicNode>& children) {
  const AlembicNode all_properties = add_compound(file, metadata, "", "", properties);
  std::vector<OgawaFile::Child> group = groups_of(children);
  group.insert(group.begin(), all_properties.group);
  const ContentKey children_key = children.empty() ? ContentKey{} : joined_key(children);
  const std::string keys = bytes_of(all_properties.key) + bytes_of(children_key);
  group.push_back(file.add_data({joined_headers(children), keys}));
  std::string header;
  put_string(header, name);
  put<std::uint8_t>(header, static_cast<std::uint8_t>(metadata.number_of(kind)));
  return {.group = file.add_group(group), .header = header, .key = content_key(keys)};
}

}  // namespace ribbon

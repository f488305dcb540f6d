// Alembic's properties and objects as groups and data of an Ogawa file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "converter/export/content_key.h"
#include "converter/export/ogawa_file.h"

namespace ribbon {

// The texts that tell what properties and objects are. Each stands once in the file and is named by
// its number, from 1; 0: no text.
class MetadataTable {
 public:
  std::uint32_t number_of(std::string_view text);  // at most 254 different ones of 255 bytes
  [[nodiscard]] std::string bytes() const;

 private:
  std::vector<std::string> texts_;
};

// A property or an object that is in the file.
struct AlembicNode {
  OgawaFile::Child group = 0;
  std::string header;  // stands in the group of its parent
  ContentKey key{};    // of all that it holds
};

enum class PlainType : std::uint32_t { int32 = 6, float32 = 10, float64 = 11 };

struct PropertyType {
  std::string_view name;
  std::string_view metadata;
  bool is_array = true;  // any number of values a sample; otherwise: one
  PlainType number = PlainType::float32;
  std::uint32_t extent = 1;  // numbers that a value consists of
};

// A property of values in time. A sample that equals the one before it is not written again.
class SampledProperty {
 public:
  SampledProperty(const PropertyType& type, std::uint32_t time_sampling)
      : type_(type), time_sampling_(time_sampling) {}

  void append(OgawaFile& file, std::string_view values);
  // What has had one value all the time keeps it until there are so many samples.
  void hold_until(std::uint32_t samples);
  // Nothing may be appended afterwards.
  AlembicNode finish(OgawaFile& file, MetadataTable& metadata);

 private:
  [[nodiscard]] std::string header(MetadataTable& metadata) const;

  PropertyType type_;
  std::uint32_t time_sampling_;
  std::uint32_t samples_ = 0;
  bool is_constant_ = true;
  std::size_t sample_bytes_ = 0;  // the last one's
  ContentKey sample_key_{};
  OgawaFile::Child sample_ = 0;
  ContentKey key_{};  // of all samples
  std::vector<OgawaFile::Child> children_;
};

// A property that consists of others.
AlembicNode add_compound(OgawaFile& file, MetadataTable& metadata, std::string_view name,
                         std::string_view kind, const std::vector<AlembicNode>& properties);

// An object with its property, the schema, and the objects below it.
AlembicNode add_object(OgawaFile& file, MetadataTable& metadata, std::string_view name,
                       std::string_view kind, const std::vector<AlembicNode>& properties,
                       const std::vector<AlembicNode>& children);

}  // namespace ribbon

// The tree of objects and properties in an Alembic file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "converter/read_back/written_bytes.h"

namespace ribbon {

struct OgawaProperty {
  std::string name = {};
  std::uint64_t group = 0;  // where its samples are named, or, of a compound, its properties
  bool is_compound = false;
  bool is_array = false;
  bool is_constant = false;
  std::uint32_t number = 0;  // the number of a type
  std::uint32_t extent = 0;  // numbers that a value consists of
  std::uint32_t samples = 0;
  std::uint32_t times = 0;  // which row of the table of time samplings
};

// Where the numbers of a sample are.
struct OgawaData {
  std::uint64_t begin = 0;
  std::uint64_t size = 0;
};

struct OgawaTimes {
  double step_s = 0;
  double start_s = 0;
};

// Objects and lists of properties are named by the place of their group. Every question throws
// Spoiled where the layout does not allow what is there.
class OgawaTree {
 public:
  explicit OgawaTree(const std::filesystem::path& path);

  [[nodiscard]] const WrittenBytes& bytes() const { return bytes_; }
  [[nodiscard]] std::uint64_t top() const { return top_; }
  [[nodiscard]] std::vector<std::uint64_t> children(std::uint64_t object) const;
  [[nodiscard]] std::uint64_t properties_of(std::uint64_t object) const;
  [[nodiscard]] std::vector<OgawaProperty> properties(std::uint64_t group) const;
  [[nodiscard]] OgawaData sample(const OgawaProperty& property, int index) const;
  [[nodiscard]] OgawaTimes times(std::uint32_t row) const;

 private:
  [[nodiscard]] std::vector<std::uint64_t> group(std::uint64_t place) const;
  [[nodiscard]] OgawaData data(std::uint64_t child) const;

  WrittenBytes bytes_;
  std::uint64_t top_ = 0;
  std::vector<OgawaTimes> times_;
};

}  // namespace ribbon

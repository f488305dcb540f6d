// Strict reading of a binary FBX file of version 7.4.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "converter/read_back/written_bytes.h"

namespace ribbon {

struct ReadFbxRecord {
  // A number, or text (of raw bytes, too), or an array.
  using Property = std::variant<double, std::string, std::vector<double>>;

  std::string name;
  std::vector<Property> properties;
  std::vector<ReadFbxRecord> nested;

  // The first nested record with a name; an empty one where there is none.
  [[nodiscard]] const ReadFbxRecord& operator[](std::string_view nested_name) const;
  [[nodiscard]] const std::vector<double>& array() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] std::string text(std::size_t property) const;
  // The last value of the property `P` with a name among Properties70.
  [[nodiscard]] double setting(std::string_view setting_name) const;
};

// Where a record begins, where what is nested in it begins, and where it ends, in the file.
struct FbxSpan {
  std::string name;
  std::uint64_t begin = 0;
  std::uint64_t nested = 0;
  std::uint64_t end = 0;
};

// The file's records one by one: files may be too long to be held in memory. Throws Spoiled with
// the place where a record does not end where it says, a list has no null record, or an array
// cannot be inflated to the length it states.
class FbxFileRecords {
 public:
  explicit FbxFileRecords(const std::filesystem::path& path);

  using Visit = std::function<void(const FbxSpan& span)>;
  // Each of the file itself, or each that is nested in one of them, in turn.
  void for_each(const Visit& visit) const { visit_list(first_record, visit); }
  void for_each_in(const FbxSpan& parent, const Visit& visit) const;
  [[nodiscard]] ReadFbxRecord read(const FbxSpan& span) const;

 private:
  static constexpr std::uint64_t first_record = 27;
  void visit_list(std::uint64_t begin, const Visit& visit) const;

  WrittenBytes bytes_;
};

}  // namespace ribbon

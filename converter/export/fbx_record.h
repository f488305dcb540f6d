// What a binary FBX file consists of: records with properties and nested records.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ribbon {

// A value as it lies in the file: a letter for its type, and its bytes.
class FbxProperty {
 public:
  FbxProperty(bool value);
  FbxProperty(int number);
  FbxProperty(std::int64_t number);
  FbxProperty(double number);
  FbxProperty(std::string_view text);
  FbxProperty(const std::string& text) : FbxProperty(std::string_view(text)) {}
  FbxProperty(const char* text) : FbxProperty(std::string_view(text)) {}

  // Bytes that are no text.
  static FbxProperty raw(std::string_view bytes);
  // An array, whose elements FbxArrays encodes.
  static FbxProperty array(char type, std::size_t elements, bool deflated, std::string_view bytes);

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  FbxProperty() = default;

  std::string bytes_;
};

struct FbxRecord {
  std::string name;
  std::vector<FbxProperty> properties;
  std::vector<FbxRecord> nested = {};
};

// The bytes of a file, record by record, without what was taken away already. Records tell where in
// the file they end; one that is open while bytes are taken is told of later.
class FbxBytes {
 public:
  // The file's first bytes, of version 7.4, whose offsets have 32 bits.
  FbxBytes();

  void add(const FbxRecord& record);
  // A record without properties whose nested records are added one by one.
  void open(std::string_view name);
  void close();
  // The end of the list of records, and what stands behind it in every file.
  void end();

  // Bytes that have come since it was asked last.
  std::string take();

  // An end that became known after its record's beginning was taken.
  struct LateEnd {
    std::uint64_t offset;  // in the file
    std::string bytes;
  };
  std::vector<LateEnd> take_late_ends();

  // False when the file is longer than its offsets can tell: it cannot be used then.
  [[nodiscard]] bool fits() const;

 private:
  [[nodiscard]] std::uint64_t size() const { return taken_ + bytes_.size(); }
  std::uint64_t begin_record(std::string_view name, const std::vector<FbxProperty>& properties);
  void end_record(std::uint64_t begin);
  void append_null_record();

  std::string bytes_;
  std::uint64_t taken_ = 0;
  std::vector<std::uint64_t> open_;  // where they begin
  std::vector<LateEnd> late_ends_;
};

}  // namespace ribbon

#include "converter/export/fbx_container.h"

#include <gtest/gtest.h>

#include "converter/export/fbx_records.h"
#include "files/flipped.h"

namespace ribbon::fbx_container_test {

std::string little_endian(std::uint64_t number, int bytes) {
  std::string text;
  for (int byte = 0; byte < bytes; ++byte) text += static_cast<char>(number >> (8 * byte));
  return text;
}

// A record with one property (a byte) or none.
std::string record(std::uint64_t end, const std::string& name, bool property,
                   const std::string& children) {
  const std::uint64_t count = property ? 1 : 0;
  return little_endian(end, 8) + little_endian(count, 8) + little_endian(2 * count, 8) +
         little_endian(name.size(), 1) + name + (property ? "C\1" : "") + children;
}

const std::string null_record(25, '\0');

std::string file(const std::string& records, int padding) {
  return std::string("Kaydara FBX Binary  \0\x1a\0", 23) + little_endian(7500, 4) + records +
         null_record + "0123456789abcdef" + std::string(padding, '\0') + little_endian(0, 4) +
         little_endian(7500, 4) + std::string(120, '\0') + "fedcba9876543210";
}

// A { B: 1 {C: 1} }, D: 1. A record of one letter takes 26 bytes, and 2 for its property.
std::string without_null_records() {
  // A 27, B 53, C 81 to 109, which ends all three; D 109 to 137; list end 162, identifier 178.
  return file(record(109, "A", false, record(109, "B", true, record(109, "C", true, ""))) +
                  record(137, "D", true, ""),
              14);
}

std::string with_null_records() {
  // C 81 to 109, null to 134 ends B, null to 159 ends A, D 159 to 187, list end 212, identifier
  // 228.
  return file(
      record(159, "A", false,
             record(134, "B", true, record(109, "C", true, "") + null_record) + null_record) +
          record(187, "D", true, ""),
      12);
}

TEST(FbxContainer, nested_lists_get_their_null_records) {
  EXPECT_EQ(fbx_top_list_end(without_null_records()), 0U);
  EXPECT_EQ(fbx_top_list_end(with_null_records()), 212U);
  EXPECT_EQ(repair_fbx_container(without_null_records()).value(), with_null_records());
}

TEST(FbxContainer, a_right_file_stays_as_it_is) {
  EXPECT_EQ(repair_fbx_container(with_null_records()).value(), with_null_records());
}

TEST(FbxContainer, an_empty_list_gets_its_null_record) {
  const std::string open = file(record(53, "A", false, ""), 2);
  const std::string closed = file(record(78, "A", false, null_record), 9);
  EXPECT_EQ(repair_fbx_container(open).value(), closed);
}

TEST(FbxContainer, an_aligned_identifier_is_padded_by_16_bytes) {
  // Header 27, record of a 7-letter name with property 34, list end 86, identifier 102: pad 10.
  const std::string shorter = file(record(61, "sevenxx", true, ""), 10);
  EXPECT_EQ(repair_fbx_container(shorter).value(), shorter);
  // With 17 letters the identifier ends at 112, a multiple of 16.
  const std::string aligned = file(record(71, "seventeen_letters", true, ""), 16);
  EXPECT_EQ(repair_fbx_container(aligned).value(), aligned);
}

TEST(FbxContainer, every_prefix_is_refused) {
  const std::string bytes = with_null_records();
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(repair_fbx_container(bytes.substr(0, length)).has_value()) << length;
}

TEST(FbxContainer, no_flipped_byte_reads_outside_the_file) {
  const std::string bytes = without_null_records();
  for (std::size_t offset = 0; offset < bytes.size(); ++offset)
    repair_fbx_container(flipped(bytes, offset));  // refused or not, the sanitizers watch
}

TEST(FbxContainer, a_record_that_ends_after_its_list_is_refused) {
  EXPECT_FALSE(repair_fbx_container(file(record(109, "A", false, record(110, "B", true, "")), 0)));
}

TEST(FbxContainer, deep_nesting_is_refused) {
  const std::uint64_t depth = 100;
  std::string records;
  for (std::uint64_t level = 0; level < depth; ++level)
    records = record(27 + 26 * depth, "A", false, records);
  EXPECT_FALSE(repair_fbx_container(file(records, 0)).has_value());
}

TEST(FbxContainer, a_file_with_32_bit_offsets_is_refused) {
  std::string bytes = with_null_records();
  bytes.replace(23, 4, little_endian(7400, 4));
  EXPECT_FALSE(repair_fbx_container(bytes).has_value());
}

}  // namespace ribbon::fbx_container_test

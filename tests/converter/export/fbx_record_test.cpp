#include "converter/export/fbx_record.h"

#include <gtest/gtest.h>

#include "converter/export/fbx_arrays.h"
#include "converter/export/read_fbx.h"
#include "files/flipped.h"

namespace ribbon::fbx_record_test {

std::string file_with(const std::vector<FbxRecord>& records) {
  FbxBytes bytes;
  for (const FbxRecord& record : records) bytes.add(record);
  bytes.end();
  return bytes.take();
}

TEST(FbxRecord, every_property_is_read_back) {
  FbxArrays arrays;
  const Eigen::VectorXd doubles = Eigen::VectorXd::LinSpaced(500, -1, 1);
  const ReadFbxRecord file = read_fbx(file_with(
      {{"A", {true, -7, std::int64_t{1} << 40, 0.1, "text", FbxProperty::raw("raw")}},
       {"B", {arrays.array(doubles), arrays.array(Eigen::VectorXi(Eigen::Vector2i(3, -4)))}}}));
  const auto& a = file["A"].properties;
  EXPECT_EQ(a, (std::vector<ReadFbxRecord::Property>{1.0, -7.0, double(std::int64_t{1} << 40), 0.1,
                                                     "text", "raw"}));
  EXPECT_EQ(file["B"].array(), std::vector<double>(doubles.begin(), doubles.end()));
  EXPECT_EQ(std::get<2>(file["B"].properties[1]), (std::vector<double>{3, -4}));
}

TEST(FbxRecord, the_bytes_are_as_the_format_says) {
  const std::string bytes = file_with({{"A", {7}, {{"B", {}}}}});
  const std::string null_record(13, '\0');
  // A begins at 27, takes 14 bytes and 5 for its property, then B's 14 and the two null records.
  EXPECT_EQ(bytes.substr(27, 73), std::string("\x56\0\0\0\1\0\0\0\5\0\0\0\1AI\7\0\0\0", 19) +
                                      std::string("\x49\0\0\0\0\0\0\0\0\0\0\0\1B", 14) +
                                      null_record + null_record + null_record +
                                      bytes.substr(99, 1));
  EXPECT_EQ((bytes.size() - 144 - 16) % 16, 0U);
}

TEST(FbxRecord, a_list_that_is_taken_piece_by_piece_is_the_same) {
  const FbxRecord record{"B", {"some text"}, {{"C", {}}}};
  const std::string whole = file_with({{"A", {}, {record, record}}, record});
  FbxBytes bytes;
  bytes.open("A");
  bytes.add(record);
  std::string pieces = bytes.take();
  bytes.add(record);
  pieces += bytes.take();
  bytes.close();
  bytes.add(record);
  bytes.end();
  pieces += bytes.take();
  EXPECT_NE(pieces, whole) << "nothing came late";
  for (const FbxBytes::LateEnd& late : bytes.take_late_ends())
    pieces.replace(late.offset, late.bytes.size(), late.bytes);
  EXPECT_EQ(pieces, whole);
}

TEST(FbxRecord, equal_numbers_give_equal_bytes_and_zeros_take_few) {
  FbxArrays arrays;
  const Eigen::Matrix3Xd zeros = Eigen::Matrix3Xd::Zero(3, 6400);
  EXPECT_EQ(arrays.array(zeros).bytes(), FbxArrays().array(zeros).bytes());
  EXPECT_LT(arrays.array(zeros).bytes().size(), 1000U);
}

TEST(FbxRecord, more_than_offsets_can_tell_does_not_fit) {
  FbxBytes bytes;
  const FbxRecord record{"A", {FbxProperty::raw(std::string(std::size_t{1} << 20, 'x'))}};
  for (int mb = 0; mb < 4095; ++mb) {
    bytes.add(record);
    bytes.take();
  }
  EXPECT_TRUE(bytes.fits());
  bytes.add(record);
  EXPECT_FALSE(bytes.fits());
}

// That the tests' own reader sees what is wrong.
TEST(FbxRecord, no_prefix_and_no_changed_length_is_read) {
  const std::string bytes = file_with({{"A", {7}, {{"B", {"x"}}, {"C", {}}}}, {"D", {1.0}}});
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(read_fbx(bytes.substr(0, length)), std::runtime_error) << length;
  for (std::size_t offset = 27; offset < 27 + 13; ++offset)
    EXPECT_THROW(read_fbx(flipped(bytes, offset)), std::runtime_error) << offset;
}

}  // namespace ribbon::fbx_record_test

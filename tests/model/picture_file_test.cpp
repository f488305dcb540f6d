#include "model/picture_file.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "model/sample_picture.h"
#include "result/refusal.h"

namespace ribbon::picture_file_test {

// As far as the frame that states 300 x 7 pixels, behind a segment of eight bytes.
std::string sample_jpeg() {
  constexpr std::string_view bytes(
      "\xff\xd8\xff\xe0\x00\x06JFIF\xff\xff\xc0\x00\x0b\x08\x00\x07\x01\x2c\x01\x00", 22);
  return std::string(bytes);
}

class PictureFiles : public TestInFolder {
 protected:
  [[nodiscard]] Result<PictureFile> read(const std::string& bytes) const {
    EXPECT_TRUE(write_file(file_, bytes));
    return read_picture_file(file_);
  }

  std::filesystem::path file_ = folder_ / "cloth.picture";
};

TEST_F(PictureFiles, a_png_is_handed_on_as_it_is) {
  const PictureFile picture = read(sample_png()).value();
  EXPECT_EQ(picture.bytes, sample_png());
  EXPECT_EQ(picture.media_type, "image/png");
  EXPECT_EQ(picture.extension, ".png");
  EXPECT_EQ(picture.width, 2);
  EXPECT_EQ(picture.height, 1);
}

TEST_F(PictureFiles, the_size_of_a_jpeg_stands_in_the_segment_that_begins_its_frame) {
  const PictureFile picture = read(sample_jpeg()).value();
  EXPECT_EQ(picture.media_type, "image/jpeg");
  EXPECT_EQ(picture.extension, ".jpg");
  EXPECT_EQ(picture.width, 300);
  EXPECT_EQ(picture.height, 7);
}

TEST_F(PictureFiles, what_is_cut_off_before_the_size_is_no_picture) {
  for (const std::string& whole : {sample_png().substr(0, 24), sample_jpeg().substr(0, 20)}) {
    EXPECT_TRUE(read(whole));
    for (std::size_t length = 0; length < whole.size(); ++length)
      EXPECT_THAT(refusal_of(read(whole.substr(0, length))),
                  AllOf(HasSubstr("cloth.picture"), HasSubstr("PNG or JPEG")))
          << length;
  }
}

TEST_F(PictureFiles, segments_that_lead_beyond_the_end_are_no_picture) {
  std::string jpeg = sample_jpeg();
  jpeg[4] = '\x7f';
  EXPECT_FALSE(read(jpeg));
}

TEST_F(PictureFiles, an_absurd_size_is_refused) {
  std::string png = sample_png();
  png[16] = '\x7f';
  EXPECT_THAT(refusal_of(read(png)), HasSubstr("2130706434 x 1 pixels"));
  png = sample_png();
  png[19] = '\0';
  EXPECT_THAT(refusal_of(read(png)), HasSubstr("PNG or JPEG"));
}

TEST_F(PictureFiles, a_file_that_is_huge_is_not_read) {
  ASSERT_TRUE(write_file(file_, sample_png()));
  std::filesystem::resize_file(file_, (256U << 20U) + 1);  // sparse
  EXPECT_THAT(refusal_of(read_picture_file(file_)), HasSubstr("256 MB"));
}

TEST_F(PictureFiles, a_file_that_is_not_there_is_named) {
  EXPECT_THAT(refusal_of(read_picture_file(folder_ / "none.png")), HasSubstr("none.png"));
}

}  // namespace ribbon::picture_file_test

#include "text/characters.h"

#include <gtest/gtest.h>

namespace ribbon::characters_test {

TEST(Characters, what_is_utf8_stays_as_it_is) {
  for (const char* text : {"", "bow", "\u00FCber \u7D50\u3073 \U0001F380", "\uFFFD", "\U0010FFFF"})
    EXPECT_EQ(as_utf8(text), text);
}

TEST(Characters, what_is_not_is_replaced) {
  EXPECT_EQ(as_utf8("kn\xF6t"), "kn\uFFFDt") << "Latin-1";
  EXPECT_EQ(as_utf8("\xC3"), "\uFFFD") << "cut off";
  EXPECT_EQ(as_utf8("\xE7\xB5"), "\uFFFD\uFFFD") << "cut off";
  EXPECT_EQ(as_utf8("\xE7\xB5x"), "\uFFFD\uFFFDx") << "cut off";
  EXPECT_EQ(as_utf8("\xC0\xAF"), "\uFFFD\uFFFD") << "longer than it need be";
  EXPECT_EQ(as_utf8("\xE0\x80\xAF"), "\uFFFD") << "likewise";
  EXPECT_EQ(as_utf8("\xF0\x80\x80\xAF"), "\uFFFD") << "likewise";
  EXPECT_EQ(as_utf8("\xED\xA0\x80"), "\uFFFD") << "half a character of UTF-16";
  EXPECT_EQ(as_utf8("\xF4\x90\x80\x80"), "\uFFFD") << "beyond Unicode";
}

}  // namespace ribbon::characters_test

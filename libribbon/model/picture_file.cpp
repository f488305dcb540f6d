#include "model/picture_file.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "files/files.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr std::uintmax_t most_bytes = 256U << 20U;
constexpr int largest_side = 16384;

struct Size {
  std::uint32_t width;
  std::uint32_t height;
};

std::uint32_t byte_at(std::string_view bytes, std::size_t place) {
  return static_cast<unsigned char>(bytes[place]);
}

std::uint32_t two_bytes_at(std::string_view bytes, std::size_t place) {
  return byte_at(bytes, place) << 8U | byte_at(bytes, place + 1);
}

std::uint32_t four_bytes_at(std::string_view bytes, std::size_t place) {
  return two_bytes_at(bytes, place) << 16U | two_bytes_at(bytes, place + 2);
}

// A signature, the length and name of the first chunk, and what that begins with.
constexpr std::string_view png_begin("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16);

std::optional<Size> png_size(std::string_view bytes) {
  if (!bytes.starts_with(png_begin) || bytes.size() < png_begin.size() + 8) return std::nullopt;
  return Size{four_bytes_at(bytes, png_begin.size()), four_bytes_at(bytes, png_begin.size() + 4)};
}

constexpr std::string_view jpeg_begin = "\xff\xd8\xff";

// Segments whose names lie in this range begin a frame, but for three of other use.
bool begins_frame(std::uint32_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

// From segment to segment: 0xff, a name, and the length of what follows, itself included. The size
// stands behind the precision of the frame, height first.
std::optional<Size> jpeg_size(std::string_view bytes) {
  if (!bytes.starts_with(jpeg_begin)) return std::nullopt;
  std::size_t place = 2;
  while (place + 9 <= bytes.size() && byte_at(bytes, place) == 0xff) {
    const std::uint32_t marker = byte_at(bytes, place + 1);
    if (begins_frame(marker))
      return Size{two_bytes_at(bytes, place + 7), two_bytes_at(bytes, place + 5)};
    place += marker == 0xff ? 1 : 2 + two_bytes_at(bytes, place + 2);  // 0xff may be repeated
  }
  return std::nullopt;
}

Result<std::string> bytes_of(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (!code && size > most_bytes)
    return failure(file.string(), "is larger than 256 MB", "use a smaller picture");
  return read_file(file);
}

Result<Size> checked_size(const std::filesystem::path& file, const std::optional<Size>& size) {
  if (!size || size->width == 0 || size->height == 0)
    return failure(file.string(), "is neither a PNG nor a JPEG picture, or is damaged",
                   "save the texture as PNG or JPEG");
  if (size->width > largest_side || size->height > largest_side)
    return failure(
        file.string(),
        filled_in("has {} x {} pixels, too many for a texture", size->width, size->height),
        "make it no larger than 16384 x 16384");
  return *size;
}

}  // namespace

Result<PictureFile> read_picture_file(const std::filesystem::path& file) {
  auto bytes = bytes_of(file);
  if (!bytes) return tl::unexpected(bytes.error());
  const bool is_jpeg = bytes->starts_with(jpeg_begin);
  return checked_size(file, is_jpeg ? jpeg_size(*bytes) : png_size(*bytes)).map([&](Size size) {
    return PictureFile{.bytes = std::move(*bytes),
                       .media_type = is_jpeg ? "image/jpeg" : "image/png",
                       .extension = is_jpeg ? ".jpg" : ".png",
                       .width = static_cast<int>(size.width),
                       .height = static_cast<int>(size.height)};
  });
}

}  // namespace ribbon

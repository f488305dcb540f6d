#include "converter/export/fbx_container.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace ribbon {

namespace {

static_assert(std::endian::native == std::endian::little, "FBX is little-endian");

constexpr std::string_view magic("Kaydara FBX Binary  \0\x1a\0", 23);
constexpr std::size_t file_header_bytes = magic.size() + 4;  // then the version
// A record: u64 end offset, u64 number of properties, u64 their bytes, u8 length of the name, name,
// properties, nested records. The null record that ends a list is a record header of zeros.
constexpr std::size_t record_header_bytes = 25;
constexpr std::size_t footer_id_bytes = 16;
constexpr std::size_t footer_end_bytes = 4 + 4 + 120 + 16;  // after the padding
constexpr int max_depth = 64;

template <class Number>
Number read_number(std::string_view bytes, std::size_t offset) {
  Number number{};
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

class ContainerCopy {
 public:
  explicit ContainerCopy(std::string_view bytes) : in_(bytes) { out_.reserve(2 * bytes.size()); }

  // False when the bytes are not a well-formed file.
  bool run() {
    if (in_.size() < file_header_bytes || !in_.starts_with(magic)) return false;
    version_ = read_number<std::uint32_t>(in_, magic.size());
    if (version_ < 7500) return false;
    take(file_header_bytes);
    return copy_list(in_.size(), 0) && copy_footer();
  }

  [[nodiscard]] std::string result() && { return std::move(out_); }

 private:
  void take(std::size_t count) {
    out_.append(in_, position_, count);
    position_ += count;
  }

  [[nodiscard]] bool at_null_record() const {
    return in_.substr(position_, record_header_bytes) == std::string(record_header_bytes, '\0');
  }

  // Copies records up to a null record or, where that is missing, up to `end`; the copy always gets
  // one.
  bool copy_list(std::size_t end, int depth) {
    while (position_ < end) {
      if (end - position_ < record_header_bytes || depth > max_depth) return false;
      if (at_null_record()) {
        position_ += record_header_bytes;
        break;
      }
      if (!copy_record(end, depth)) return false;
    }
    out_.append(record_header_bytes, '\0');
    return depth == 0 || position_ == end;
  }

  bool copy_record(std::size_t list_end, int depth) {
    const std::size_t out_begin = out_.size();
    const auto end = read_number<std::uint64_t>(in_, position_);
    const auto property_count = read_number<std::uint64_t>(in_, position_ + 8);
    const auto property_bytes = read_number<std::uint64_t>(in_, position_ + 16);
    const auto name_bytes = read_number<std::uint8_t>(in_, position_ + 24);
    const std::size_t name_end = position_ + record_header_bytes + name_bytes;
    if (end > list_end || name_end > end || property_bytes > end - name_end) return false;
    take(name_end + property_bytes - position_);
    // A record without properties is a list, even an empty one.
    if ((position_ < end || property_count == 0) && !copy_list(end, depth + 1)) return false;
    const std::uint64_t out_end = out_.size();
    std::memcpy(out_.data() + out_begin, &out_end, sizeof out_end);
    return true;
  }

  // An identifier, zeros up to a multiple of 16 (16 of them where it is one already), and an end of
  // fixed length that repeats the version.
  bool copy_footer() {
    if (in_.size() - position_ < footer_id_bytes + footer_end_bytes) return false;
    const std::size_t footer_end = in_.size() - footer_end_bytes;
    if (read_number<std::uint32_t>(in_, footer_end + 4) != version_) return false;
    take(footer_id_bytes);
    out_.append(16 - out_.size() % 16, '\0');
    position_ = footer_end;
    take(footer_end_bytes);
    return true;
  }

  std::string_view in_;
  std::size_t position_ = 0;
  std::uint32_t version_ = 0;
  std::string out_;
};

}  // namespace

Result<std::string> repair_fbx_container(std::string_view bytes) {
  ContainerCopy copy(bytes);
  if (!copy.run())
    return failure("", "the installed assimp wrote an FBX file whose structure is not understood",
                   "export .obj, or use another version of assimp");
  return std::move(copy).result();
}

}  // namespace ribbon

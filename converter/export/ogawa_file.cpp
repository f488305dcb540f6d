#include "converter/export/ogawa_file.h"

#include <utility>

#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

constexpr OgawaFile::Child data_bit = OgawaFile::Child{1} << 63U;
constexpr std::uint64_t place_of_frozen = 5;
constexpr std::uint64_t place_of_root = 8;

}  // namespace

Result<OgawaFile> OgawaFile::create(const std::filesystem::path& path) {
  return PendingFile::create(path).map(
      [](PendingFile&& file) { return OgawaFile(std::move(file)); });
}

OgawaFile::OgawaFile(PendingFile file) : file_(std::move(file)) {
  append({"Ogawa\x00\x00\x01", place_of_root});
  append_number(0);
}

OgawaFile::Child OgawaFile::add_data(std::initializer_list<std::string_view> pieces) {
  std::uint64_t size = 0;
  for (const std::string_view piece : pieces) size += piece.size();
  if (size == 0) return data_bit;
  const std::uint64_t begin = file_.size();
  append_number(size);
  for (const std::string_view piece : pieces) append(piece);
  return begin | data_bit;
}

OgawaFile::Child OgawaFile::add_group(const std::vector<Child>& children) {
  if (children.empty()) return 0;
  const std::uint64_t begin = file_.size();
  append_number(children.size());
  for (const Child child : children) append_number(child);
  return begin;
}

void OgawaFile::append(std::string_view bytes) {
  if (error_) return;
  if (auto appended = file_.append(bytes); !appended) error_ = appended.error();
}

void OgawaFile::append_number(std::uint64_t number) {
  std::string bytes;
  put<std::uint64_t>(bytes, number);
  append(bytes);
}

Result<void> OgawaFile::finish(Child root, Older older) {
  if (error_) return tl::unexpected(*error_);
  std::string place;
  put<std::uint64_t>(place, root);
  return file_.overwrite(place_of_root, place)
      .and_then([&] { return file_.overwrite(place_of_frozen, "\xff"); })
      .and_then([&] { return file_.finish(older); });
}

}  // namespace ribbon

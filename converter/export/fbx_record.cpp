#include "converter/export/fbx_record.h"

#include <limits>
#include <utility>

#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

constexpr std::string_view magic("Kaydara FBX Binary  \0\x1a\0", 23);
constexpr std::uint32_t version = 7400;
// A record: u32 end offset, u32 number of properties, u32 their bytes, u8 length of the name, name,
// properties, nested records. The null record that ends nested ones is a header of zeros.
constexpr std::size_t record_header_bytes = 13;
// The file's last bytes: always the same ones, and readers that look at them want these.
constexpr std::string_view footer_id(
    "\xfa\xbc\xab\x09\xd0\xc8\xd4\x66\xb1\x76\xfb\x83\x1c\xf7\x26\x7e");
constexpr std::string_view footer_end(
    "\xf8\x5a\x8c\x6a\xde\xf5\xd9\x7e\xec\xe9\x0c\xe3\x75\x8f\x29\x0b");

std::uint32_t as_u32(std::uint64_t number) {
  return static_cast<std::uint32_t>(number);
}

}  // namespace

FbxProperty::FbxProperty(bool value) : bytes_("C") {
  bytes_ += value ? '\1' : '\0';
}

FbxProperty::FbxProperty(int number) : bytes_("I") {
  put<std::int32_t>(bytes_, number);
}

FbxProperty::FbxProperty(std::int64_t number) : bytes_("L") {
  put<std::int64_t>(bytes_, number);
}

FbxProperty::FbxProperty(double number) : bytes_("D") {
  put<double>(bytes_, number);
}

FbxProperty::FbxProperty(std::string_view text) : bytes_("S") {
  put_string(bytes_, text);
}

FbxProperty FbxProperty::raw(std::string_view bytes) {
  FbxProperty property;
  property.bytes_ = "R";
  put_string(property.bytes_, bytes);
  return property;
}

FbxProperty FbxProperty::array(char type, std::size_t elements, bool deflated,
                               std::string_view bytes) {
  FbxProperty property;
  property.bytes_ = type;
  for (const std::size_t number : {elements, std::size_t{deflated}, bytes.size()})
    put<std::uint32_t>(property.bytes_, as_u32(number));
  property.bytes_ += bytes;
  return property;
}

FbxBytes::FbxBytes() : bytes_(magic) {
  put<std::uint32_t>(bytes_, version);
}

void FbxBytes::add(const FbxRecord& record) {
  const std::uint64_t begin = begin_record(record.name, record.properties);
  for (const FbxRecord& nested : record.nested) add(nested);
  // A record without properties is a list, even an empty one.
  if (!record.nested.empty() || record.properties.empty()) append_null_record();
  end_record(begin);
}

void FbxBytes::open(std::string_view name) {
  open_.push_back(begin_record(name, {}));
}

void FbxBytes::close() {
  append_null_record();
  end_record(open_.back());
  open_.pop_back();
}

// An identifier, zeros up to a multiple of 16 (16 of them where it is one already), four more, the
// version again, 120 zeros and a second identifier.
void FbxBytes::end() {
  append_null_record();
  bytes_ += footer_id;
  bytes_.append(16 - size() % 16 + 4, '\0');
  put<std::uint32_t>(bytes_, version);
  bytes_.append(120, '\0');
  bytes_ += footer_end;
}

std::string FbxBytes::take() {
  taken_ += bytes_.size();
  return std::exchange(bytes_, {});
}

std::vector<FbxBytes::LateEnd> FbxBytes::take_late_ends() {
  return std::exchange(late_ends_, {});
}

bool FbxBytes::fits() const {
  return size() <= std::numeric_limits<std::uint32_t>::max();
}

std::uint64_t FbxBytes::begin_record(std::string_view name,
                                     const std::vector<FbxProperty>& properties) {
  const std::uint64_t begin = size();
  std::size_t property_bytes = 0;
  for (const FbxProperty& property : properties) property_bytes += property.bytes().size();
  for (const std::size_t number : {std::size_t{0}, properties.size(), property_bytes})
    put<std::uint32_t>(bytes_, as_u32(number));
  put<std::uint8_t>(bytes_, static_cast<std::uint8_t>(name.size()));
  bytes_ += name;
  for (const FbxProperty& property : properties) bytes_ += property.bytes();
  return begin;
}

void FbxBytes::end_record(std::uint64_t begin) {
  std::string end;
  put<std::uint32_t>(end, as_u32(size()));
  if (begin < taken_)
    late_ends_.push_back({begin, end});
  else
    bytes_.replace(begin - taken_, end.size(), end);
}

void FbxBytes::append_null_record() {
  bytes_.append(record_header_bytes, '\0');
}

}  // namespace ribbon

#include "converter/read_back/fbx_records.h"

#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <new>

#include "converter/read_back/written_motion.h"
#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

constexpr std::string_view file_magic("Kaydara FBX Binary  \0\x1a\0", 23);
constexpr std::uint32_t version_read = 7400;
constexpr std::uint64_t head_bytes = 13;  // of a record, before its name
constexpr int deepest_record = 16;        // records in records

// Of a file from some place on.
class Reader {
 public:
  Reader(std::string_view bytes, std::uint64_t begin)
      : begin_(begin), size_(bytes.size()), taker_(bytes) {}

  ReadFbxRecord record(int depth = 0) {
    demand(depth < deepest_record, "records nested too deeply");
    const auto end = taker_.take<std::uint32_t>();
    const auto property_count = taker_.take<std::uint32_t>();
    const auto property_bytes = taker_.take<std::uint32_t>();
    ReadFbxRecord record{.name = std::string(taker_.take_bytes(taker_.take<std::uint8_t>())),
                         .properties = {},
                         .nested = {}};
    demand(!record.name.empty() && end <= begin_ + size_, "a record's head");
    const std::uint64_t properties = position();
    for (std::uint32_t i = 0; i < property_count; ++i) record.properties.push_back(property());
    demand(position() == properties + property_bytes, record.name + ": properties");
    if (position() < end || property_count == 0) record.nested = list(depth + 1);
    demand(position() == end, record.name + ": its end");
    return record;
  }

 private:
  [[nodiscard]] std::uint64_t position() const { return begin_ + size_ - taker_.rest().size(); }

  void demand(bool good, const std::string& what) const {
    if (!good || !taker_.complete())
      throw Spoiled(what + " before byte " + std::to_string(position()));
  }

  // Up to its null record.
  std::vector<ReadFbxRecord> list(int depth) {
    std::vector<ReadFbxRecord> records;
    while (taker_.rest().substr(0, head_bytes) != std::string(head_bytes, '\0'))
      records.push_back(record(depth));
    taker_.take_bytes(head_bytes);
    return records;
  }

  ReadFbxRecord::Property property() {
    const auto type = static_cast<char>(taker_.take<std::uint8_t>());
    switch (type) {
      case 'C':
        return number<std::uint8_t>();
      case 'I':
        return number<std::int32_t>();
      case 'L':
        return number<std::int64_t>();
      case 'D':
        return number<double>();
      case 'S':
      case 'R':
        return take_string(taker_);
      case 'd':
        return array<double>();
      case 'f':
        return array<float>();
      case 'l':
        return array<std::int64_t>();
      case 'i':
        return array<std::int32_t>();
      default:
        demand(false, "an unknown type");
        return 0.0;
    }
  }

  template <class Number>
  double number() {
    return static_cast<double>(taker_.take<Number>());
  }

  template <class Number>
  std::vector<double> array() {
    const auto count = taker_.take<std::uint32_t>();
    const bool deflated = taker_.take<std::uint32_t>() == 1;
    const std::string_view stored = taker_.take_bytes(taker_.take<std::uint32_t>());
    constexpr std::size_t best_ratio = 1032;  // of what deflate makes of zeros
    demand(count <= best_ratio * stored.size() / sizeof(Number) + 1, "the length of an array");
    const std::size_t bytes = count * sizeof(Number);
    const std::string plain = deflated ? inflated(stored, bytes) : std::string(stored);
    demand(plain.size() == bytes, "an array");
    std::vector<double> numbers;
    for (ByteTaker taker(plain); !taker.rest().empty();)
      numbers.push_back(static_cast<double>(taker.take<Number>()));
    return numbers;
  }

  [[nodiscard]] std::string inflated(std::string_view stored, std::size_t bytes) const {
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> inflater(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (!inflater) throw std::bad_alloc();
    std::string plain(bytes, '\0');
    demand(libdeflate_zlib_decompress(inflater.get(), stored.data(), stored.size(), plain.data(),
                                      bytes, nullptr) == LIBDEFLATE_SUCCESS,
           "a deflated array");
    return plain;
  }

  std::uint64_t begin_;
  std::size_t size_;
  ByteTaker taker_;
};

}  // namespace

const ReadFbxRecord& ReadFbxRecord::operator[](std::string_view nested_name) const {
  static const ReadFbxRecord none;
  const auto found = std::find_if(nested.begin(), nested.end(), [&](const ReadFbxRecord& record) {
    return record.name == nested_name;
  });
  return found == nested.end() ? none : *found;
}

const std::vector<double>& ReadFbxRecord::array() const {
  return std::get<std::vector<double>>(properties.at(0));
}

double ReadFbxRecord::number() const {
  return std::get<double>(properties.at(0));
}

std::string ReadFbxRecord::text(std::size_t property) const {
  return std::get<std::string>(properties.at(property));
}

double ReadFbxRecord::setting(std::string_view setting_name) const {
  for (const ReadFbxRecord& record : (*this)["Properties70"].nested)
    if (record.text(0) == setting_name) return std::get<double>(record.properties.back());
  throw Spoiled("no setting " + std::string(setting_name));
}

FbxFileRecords::FbxFileRecords(const std::filesystem::path& path) : bytes_(path) {
  demand(bytes_.at(0, file_magic.size()) == file_magic, "not a binary FBX");
  demand(bytes_.number<std::uint32_t>(file_magic.size()) == version_read, "another version of FBX");
}

void FbxFileRecords::for_each_in(const FbxSpan& parent, const Visit& visit) const {
  if (parent.nested < parent.end) visit_list(parent.nested, visit);
}

// Up to its null record.
void FbxFileRecords::visit_list(std::uint64_t begin, const Visit& visit) const {
  constexpr std::uint64_t longest_name = 255;
  while (true) {
    const std::string head = bytes_.up_to(begin, head_bytes + longest_name);
    ByteTaker taker(head);
    const auto end = taker.take<std::uint32_t>();
    taker.take<std::uint32_t>();
    const auto property_bytes = taker.take<std::uint32_t>();
    const std::string_view name = taker.take_bytes(taker.take<std::uint8_t>());
    demand(taker.complete(), "it ends too early");
    if (end == 0) return;
    const std::uint64_t nested = begin + head_bytes + name.size() + property_bytes;
    demand(nested <= end && end <= bytes_.size(), "a record's end");
    visit({.name = std::string(name), .begin = begin, .nested = nested, .end = end});
    begin = end;
  }
}

ReadFbxRecord FbxFileRecords::read(const FbxSpan& span) const {
  const std::string bytes = bytes_.at(span.begin, span.end - span.begin);
  return Reader(bytes, span.begin).record();
}

}  // namespace ribbon

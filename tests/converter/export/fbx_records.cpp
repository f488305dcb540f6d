#include "converter/export/fbx_records.h"

#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

class Reader {
 public:
  explicit Reader(std::string_view bytes) : size_(bytes.size()), taker_(bytes) {}

  ReadFbxRecord file() {
    demand(taker_.take_bytes(23) == std::string_view("Kaydara FBX Binary  \0\x1a\0", 23), "magic");
    demand(taker_.take<std::uint32_t>() == 7400, "version");
    ReadFbxRecord root{.name = "", .properties = {}, .nested = list()};
    taker_.take_bytes(16);  // an identifier
    const std::size_t padding = 16 - position() % 16;
    demand(taker_.take_bytes(padding + 4) == std::string(padding + 4, '\0'), "padding");
    demand(taker_.take<std::uint32_t>() == 7400, "version at the end");
    demand(taker_.take_bytes(120) == std::string(120, '\0'), "zeros at the end");
    demand(taker_.rest().size() == 16, "length");
    return root;
  }

 private:
  [[nodiscard]] std::size_t position() const { return size_ - taker_.rest().size(); }

  void demand(bool good, const std::string& what) const {
    if (!good || !taker_.complete())
      throw std::runtime_error(what + " before byte " + std::to_string(position()));
  }

  // Up to its null record.
  std::vector<ReadFbxRecord> list() {
    std::vector<ReadFbxRecord> records;
    while (taker_.rest().substr(0, 13) != std::string_view("\0\0\0\0\0\0\0\0\0\0\0\0\0", 13))
      records.push_back(record());
    taker_.take_bytes(13);
    return records;
  }

  ReadFbxRecord record() {
    const auto end = taker_.take<std::uint32_t>();
    const auto property_count = taker_.take<std::uint32_t>();
    const auto property_bytes = taker_.take<std::uint32_t>();
    ReadFbxRecord record{.name = std::string(taker_.take_bytes(taker_.take<std::uint8_t>())),
                         .properties = {},
                         .nested = {}};
    demand(!record.name.empty() && end <= size_, "a record's head");
    const std::size_t properties = position();
    for (std::uint32_t i = 0; i < property_count; ++i) record.properties.push_back(property());
    demand(position() == properties + property_bytes, record.name + ": properties");
    if (position() < end || property_count == 0) record.nested = list();
    demand(position() == end, record.name + ": its end");
    return record;
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
    std::string plain(bytes, '\0');
    demand(libdeflate_zlib_decompress(inflater.get(), stored.data(), stored.size(), plain.data(),
                                      bytes, nullptr) == LIBDEFLATE_SUCCESS,
           "a deflated array");
    return plain;
  }

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

std::vector<const ReadFbxRecord*> ReadFbxRecord::all(std::string_view nested_name,
                                                     std::string_view kind) const {
  std::vector<const ReadFbxRecord*> records;
  for (const ReadFbxRecord& record : nested)
    if (record.name == nested_name && record.text(record.properties.size() - 1) == kind)
      records.push_back(&record);
  return records;
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
  throw std::runtime_error("no setting " + std::string(setting_name));
}

ReadFbxRecord read_fbx(std::string_view bytes) {
  return Reader(bytes).file();
}

}  // namespace ribbon

#include "converter/read_back/written_bytes.h"

#include <algorithm>
#include <cstring>

#include "converter/read_back/written_motion.h"

namespace ribbon {

namespace {

static_assert(std::endian::native == std::endian::little, "the formats expect this order");

RandomAccessFile opened(const std::filesystem::path& path) {
  auto file = RandomAccessFile::open(path);
  if (!file) throw Spoiled(file.error().problem);
  return std::move(*file);
}

}  // namespace

WrittenBytes::WrittenBytes(const std::filesystem::path& path) : file_(opened(path)) {}

std::string WrittenBytes::at(std::uint64_t offset, std::uint64_t count) const {
  demand(offset <= size() && count <= size() - offset, "it ends too early");
  std::string bytes = file_.read(offset, count);
  demand(bytes.size() == count, "the disk does not give its bytes");
  return bytes;
}

template <class Number>
Eigen::MatrixX<Number> WrittenBytes::numbers(std::uint64_t offset, Eigen::Index rows,
                                             std::uint64_t columns, std::endian order) const {
  const std::uint64_t column_bytes = static_cast<std::uint64_t>(rows) * sizeof(Number);
  demand(columns <= size() / column_bytes, "it ends too early");
  std::string bytes = at(offset, columns * column_bytes);
  if (order != std::endian::native)
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(Number))
      std::reverse(bytes.data() + i, bytes.data() + i + sizeof(Number));
  Eigen::MatrixX<Number> numbers(rows, static_cast<Eigen::Index>(columns));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

template <class Number>
Number WrittenBytes::number(std::uint64_t offset, std::endian order) const {
  return numbers<Number>(offset, 1, 1, order)(0, 0);
}

template std::int32_t WrittenBytes::number(std::uint64_t, std::endian) const;
template std::uint16_t WrittenBytes::number(std::uint64_t, std::endian) const;
template std::uint32_t WrittenBytes::number(std::uint64_t, std::endian) const;
template std::uint64_t WrittenBytes::number(std::uint64_t, std::endian) const;
template float WrittenBytes::number(std::uint64_t, std::endian) const;
template double WrittenBytes::number(std::uint64_t, std::endian) const;
template Eigen::MatrixX<float> WrittenBytes::numbers(std::uint64_t, Eigen::Index, std::uint64_t,
                                                     std::endian) const;
template Eigen::MatrixX<std::int32_t> WrittenBytes::numbers(std::uint64_t, Eigen::Index,
                                                            std::uint64_t, std::endian) const;
template Eigen::MatrixX<std::uint32_t> WrittenBytes::numbers(std::uint64_t, Eigen::Index,
                                                             std::uint64_t, std::endian) const;
template Eigen::MatrixX<std::uint64_t> WrittenBytes::numbers(std::uint64_t, Eigen::Index,
                                                             std::uint64_t, std::endian) const;

}  // namespace ribbon

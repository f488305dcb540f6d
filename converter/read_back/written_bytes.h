// The bytes of a file that is read back, any part of it at any time.
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "playback/random_access_file.h"

namespace ribbon {

// Every question throws Spoiled where the file has no such bytes.
class WrittenBytes {
 public:
  explicit WrittenBytes(const std::filesystem::path& path);

  [[nodiscard]] std::uint64_t size() const { return file_.size(); }
  [[nodiscard]] std::string at(std::uint64_t offset, std::uint64_t count) const;
  // As many of them as there are.
  [[nodiscard]] std::string up_to(std::uint64_t offset, std::uint64_t count) const {
    return file_.read(offset, count);
  }

  template <class Number>
  [[nodiscard]] Number number(std::uint64_t offset, std::endian order = std::endian::little) const;
  // rows x columns, column after column.
  template <class Number>
  [[nodiscard]] Eigen::MatrixX<Number> numbers(std::uint64_t offset, Eigen::Index rows,
                                               std::uint64_t columns,
                                               std::endian order = std::endian::little) const;
  [[nodiscard]] Eigen::Matrix3Xd points(std::uint64_t offset, std::uint64_t count,
                                        std::endian order = std::endian::little) const {
    return numbers<float>(offset, 3, count, order).cast<double>();
  }

 private:
  RandomAccessFile file_;
};

}  // namespace ribbon

#include "converter/export/point_cache.h"

#include <unistd.h>

#include <array>
#include <bit>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace ribbon {

namespace {

static_assert(std::endian::native == std::endian::little, "PC2 is little-endian");

constexpr std::size_t header_bytes = 32;

std::string last_error_text() {
  return std::error_code(errno, std::generic_category()).message();
}

std::array<char, header_bytes> header_of(std::int32_t points, std::int32_t samples) {
  const std::int32_t version = 1;
  const float start = 0;
  const float sampling = 1;
  std::array<char, header_bytes> header{};
  std::memcpy(header.data(), "POINTCACHE2", 12);
  std::memcpy(header.data() + 12, &version, 4);
  std::memcpy(header.data() + 16, &points, 4);
  std::memcpy(header.data() + 20, &start, 4);
  std::memcpy(header.data() + 24, &sampling, 4);
  std::memcpy(header.data() + 28, &samples, 4);
  return header;
}

}  // namespace

Result<PointCacheWriter> PointCacheWriter::create(const std::filesystem::path& path, int points,
                                                  int samples) {
  std::error_code code;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
  if (code)
    return failure(path.parent_path().string(), "cannot be created (" + code.message() + ")",
                   "choose a folder that you may write to");
  std::filesystem::path temporary = path.string() + ".part" + std::to_string(::getpid());
  File file(std::fopen(temporary.c_str(), "wb"));
  if (!file)
    return failure(path.string(), "cannot be written (" + last_error_text() + ")",
                   "choose a folder that you may write to");
  PointCacheWriter writer(path, std::move(temporary), std::move(file), points, samples);
  const auto header = header_of(points, samples);
  if (auto written = writer.write(header.data(), header.size()); !written)
    return tl::unexpected(written.error());
  return writer;
}

PointCacheWriter::PointCacheWriter(std::filesystem::path path, std::filesystem::path temporary,
                                   File file, int points, int samples)
    : path_(std::move(path)),
      temporary_(std::move(temporary)),
      file_(std::move(file)),
      points_(points),
      samples_missing_(samples) {}

PointCacheWriter::~PointCacheWriter() {
  if (!file_) return;  // finished, or moved from
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

Result<void> PointCacheWriter::write(const void* bytes, std::size_t count) {
  if (std::fwrite(bytes, 1, count, file_.get()) != count)
    return failure(path_.string(), "cannot be written (" + last_error_text() + ")",
                   "free some space or choose another folder");
  return {};
}

Result<void> PointCacheWriter::append(const Eigen::Matrix3Xf& positions) {
  assert(positions.cols() == points_);
  assert(samples_missing_ > 0);
  --samples_missing_;
  return write(positions.data(), 3 * sizeof(float) * static_cast<std::size_t>(points_));
}

Result<void> PointCacheWriter::finish() {
  assert(samples_missing_ == 0);
  const bool on_disk = std::fflush(file_.get()) == 0 && ::fsync(::fileno(file_.get())) == 0;
  if (!on_disk || std::rename(temporary_.c_str(), path_.c_str()) != 0)
    return failure(path_.string(), "cannot be written (" + last_error_text() + ")",
                   "free some space or choose another folder");
  file_.reset();
  return {};
}

}  // namespace ribbon

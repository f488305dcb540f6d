// PC2: the positions of one object in every frame, in one file.
#pragma once

#include <Eigen/Core>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "result/result.h"

namespace ribbon {

// Streams a PC2 file sample by sample to a temporary beside its final name, which it gets in
// finish(). Destroyed earlier, it leaves nothing behind.
//
// Layout (little-endian): "POINTCACHE2\0", i32 version 1, i32 points, f32 start 0, f32 sampling 1
// (one sample per frame), i32 samples, then per sample and point 3 x f32.
class PointCacheWriter {
 public:
  // Creates missing parent folders and writes the header.
  static Result<PointCacheWriter> create(const std::filesystem::path& path, int points,
                                         int samples);

  PointCacheWriter(PointCacheWriter&&) noexcept = default;
  PointCacheWriter& operator=(PointCacheWriter&&) noexcept = delete;
  ~PointCacheWriter();

  // positions: 3 x points.
  Result<void> append(const Eigen::Matrix3Xf& positions);

  // All samples announced must have been appended.
  Result<void> finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;

  PointCacheWriter(std::filesystem::path path, std::filesystem::path temporary, File file,
                   int points, int samples);
  Result<void> write(const void* bytes, std::size_t count);

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  File file_;
  int points_;
  int samples_missing_;
};

}  // namespace ribbon

#include "converter/export/pc2_writer.h"

#include <bit>
#include <cassert>
#include <cstdint>
#include <string>
#include <utility>

#include "files/pending_file.h"

namespace ribbon {

namespace {

static_assert(std::endian::native == std::endian::little, "PC2 is little-endian");

template <class Number>
std::string_view bytes_of(const Number& number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string header(std::int32_t points, std::int32_t samples) {
  std::string bytes("POINTCACHE2\0", 12);
  bytes += bytes_of(std::int32_t{1});
  bytes += bytes_of(points);
  bytes += bytes_of(0.0F);
  bytes += bytes_of(1.0F);
  bytes += bytes_of(samples);
  return bytes;
}

class Pc2Writer : public MotionWriter {
 public:
  Pc2Writer(PendingFile file, Eigen::Index points, int samples)
      : file_(std::move(file)), points_(points), samples_missing_(samples) {}

  Result<void> append(const Model& model) override {
    const Eigen::Matrix3Xf& positions = model.objects.front().positions;
    assert(positions.cols() == points_ && samples_missing_ > 0);
    --samples_missing_;
    return file_.append({reinterpret_cast<const char*>(positions.data()),
                         static_cast<std::size_t>(positions.size()) * sizeof(float)});
  }

  Result<void> finish() override {
    assert(samples_missing_ == 0);
    return file_.finish();
  }

 private:
  PendingFile file_;
  Eigen::Index points_;
  int samples_missing_;
};

}  // namespace

Result<std::unique_ptr<MotionWriter>> new_pc2_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames) {
  auto file = PendingFile::create(path);
  if (!file) return tl::unexpected(file.error());
  const Eigen::Index points = model.objects.front().positions.cols();
  if (auto begun = file->append(header(static_cast<std::int32_t>(points), frames)); !begun)
    return tl::unexpected(begun.error());
  return std::make_unique<Pc2Writer>(std::move(*file), points, frames);
}

}  // namespace ribbon

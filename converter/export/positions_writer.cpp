#include "converter/export/positions_writer.h"

#include <cassert>
#include <utility>

#include "files/pending_file.h"
#include "model/raw_bytes.h"

namespace ribbon {

namespace {

class PositionsWriter : public MotionWriter {
 public:
  PositionsWriter(PendingFile file, Eigen::Index points, int frames, std::endian order)
      : file_(std::move(file)), points_(points), frames_missing_(frames), order_(order) {}

  Result<void> append(const Model& model) override {
    const Eigen::Matrix3Xf& positions = model.objects.front().positions;
    assert(positions.cols() == points_ && frames_missing_ > 0);
    --frames_missing_;
    if (order_ == std::endian::native) return file_.append(raw_bytes(positions));
    swapped_ = positions;
    swap_bytes(swapped_);
    return file_.append(raw_bytes(swapped_));
  }

  Result<void> finish(Older older) override {
    assert(frames_missing_ == 0);
    return file_.finish(older);
  }

 private:
  PendingFile file_;
  Eigen::Index points_;
  int frames_missing_;
  std::endian order_;
  Eigen::Matrix3Xf swapped_;
};

}  // namespace

Result<std::unique_ptr<MotionWriter>> new_positions_writer(const std::filesystem::path& path,
                                                           std::string_view header,
                                                           const Model& model, int frames,
                                                           std::endian order) {
  auto file = PendingFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (auto begun = file->append(header); !begun) return tl::unexpected(begun.error());
  const Eigen::Index points = model.objects.front().positions.cols();
  return std::make_unique<PositionsWriter>(std::move(*file), points, frames, order);
}

}  // namespace ribbon

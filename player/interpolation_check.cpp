#include "player/interpolation_check.h"

#include "text/number_text.h"

namespace ribbon {

Result<void> InterpolationCheck::add(const PlayedFrame& frame, Interpolated& interpolated) {
  if (auto read = between_.read(frame.index, frame.after, positions_); !read) return read;
  if (!verifier_) {
    const RecordingHeader& header = reader_.header();
    verifier_.emplace(rest_size(header), header.obstacle);
  }
  ++interpolated.moments;
  if (positions_.allFinite() && !verifier_->intersects(positions_)) return {};
  if (interpolated.intersecting++ == 0) interpolated.first_intersecting = frame.frame();
  return {};
}

std::string sentence_on(const Interpolated& interpolated) {
  std::string text =
      filled_in("{} {} between recorded frames, and interpolated: not certified; ",
                interpolated.moments, interpolated.moments == 1 ? "moment lies" : "moments lie");
  if (interpolated.intersecting == 0) return text + "nothing intersects there";
  return text + filled_in("cloth intersects in {}, first in that of frame {:.6g}",
                          interpolated.intersecting, interpolated.first_intersecting);
}

}  // namespace ribbon

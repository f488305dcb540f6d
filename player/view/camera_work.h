// The cameras of a recording: where each picture is taken from.
#pragma once

#include <optional>
#include <vector>

#include "playback/recording_reader.h"
#include "player/picture/picture.h"
#include "player/view/camera.h"
#include "player/view/camera_path.h"
#include "player/view/knot_sphere.h"
#include "player/view/view.h"

namespace ribbon {

struct Shot {
  View view;
  PictureSize size;
  double turns = 0;  // round the scene while all pictures are taken, anticlockwise from above
  std::optional<CameraPath> path = std::nullopt;
};

// Where a picture stands in the recording, and in the film that is made of it.
struct Moment {
  int frame = 0;        // index, from 0
  double progress = 0;  // through the film: 0 at the first picture, below 1 at the last
  double after = 0;     // of the way to the next frame
};

// Cameras stand about the model of the scene. A still one stands so that the obstacle and the
// ribbon of every frame that can be read just fit: a frame looks the same whichever others are
// rendered. One that looks at the knot follows it.
class CameraWork {
 public:
  // Reads every frame once. At least one must be readable.
  CameraWork(RecordingReader& reader, std::vector<Shot> shots);

  // Follows the knot into the frames that the recording has gained. Other cameras stand where those
  // before put them.
  void follow(RecordingReader& reader);
  // The recording gains no more.
  void end() { knot_.end(); }
  // Will camera() stay what it is for this frame, whatever the recording gains?
  [[nodiscard]] bool is_settled(int frame) const {
    return !follows_knot_ || knot_.is_settled(frame);
  }

  [[nodiscard]] Camera camera(std::size_t shot, const Moment& moment) const;
  // Of everything in any frame.
  [[nodiscard]] float lowest_m() const { return lowest_m_; }

 private:
  // Fills `positions` with a frame of the model; false where it cannot be read.
  bool read(RecordingReader& reader, int index, Eigen::Matrix3Xf& positions) const;
  // positions: of the next frame; null where it cannot be read. All of the ribbon stands for a knot
  // that has come apart, once nothing is left where it was.
  void add_knot(const RecordingHeader& header, const Eigen::Matrix3Xf* positions);
  [[nodiscard]] CameraPose pose(const Shot& shot, const Moment& moment) const;
  [[nodiscard]] Sphere subject(Subject subject, const Moment& moment) const;

  float scale_;  // of the model
  std::vector<Shot> shots_;
  std::vector<Camera> still_;     // of each shot, if nothing moves it
  std::vector<float> distances_;  // of each shot: from the middle of everything, that holds it
  double frames_per_second_;
  Sphere everything_;
  float lowest_m_ = 0;
  bool follows_knot_;  // some shot does
  FollowedKnot knot_;  // of all frames, where one does
  std::optional<Sphere> last_knot_;
};

}  // namespace ribbon

// A recording as the page shows it: arrays that go to the graphics card as they are.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "playback/recording_reader.h"
#include "player/render/surface.h"
#include "result/result.h"

namespace ribbon {

// Places are those of the model (scene_model.h).
class ShownRecording {
 public:
  // Of a particle: position, normal, largest strain of the edges that end there.
  static constexpr int floats_per_particle = 7;
  // Of a corner of the obstacle: position, normal.
  static constexpr int floats_per_corner = 6;
  // Of a frame; what is not known is no number.
  enum Number { time_s, strain, penetrations, stage, progress, pull, contact, readable };
  static constexpr int numbers_per_frame = 8;

  // Reads every record once. Fails where the file is no recording, or holds no frame that can be
  // read.
  static Result<ShownRecording> open(const std::filesystem::path& file);

  // What does not change from frame to frame, as JSON.
  [[nodiscard]] std::string description() const;
  [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }
  // Three particles a triangle, counter-clockwise about the front.
  [[nodiscard]] const Eigen::Matrix3Xi& triangles() const { return ribbon_.triangles; }
  // Two a particle, in ribbon widths: along from the first end, and across from 0 to 1.
  [[nodiscard]] const std::vector<float>& threads() const { return threads_; }
  // Three corners a triangle; smooth but where it has an edge.
  [[nodiscard]] const std::vector<float>& obstacle() const { return obstacle_; }

  // Finds out what a file that is being written has gained: numbers of more frames. Fails where it
  // has become shorter.
  Result<void> refresh();
  // Decodes frame `index` (from 0). Where it fails, what was shown before stays.
  Result<void> show(int index);
  // Of the frame that was shown last.
  [[nodiscard]] const std::vector<float>& particles() const { return particles_; }

 private:
  explicit ShownRecording(RecordingReader reader);
  void take_box();

  RecordingReader reader_;
  float scale_;  // of the model
  Surface ribbon_;
  Eigen::Matrix3Xf positions_;
  std::vector<double> numbers_;
  std::vector<float> threads_;
  std::vector<float> obstacle_;
  std::vector<float> particles_;
  Eigen::Vector3f box_min_ = Eigen::Vector3f::Zero();  // of some frames from the first to the last
  Eigen::Vector3f box_max_ = Eigen::Vector3f::Zero();
};

// The built-in cloth: pattern_along x pattern_across texels of the front, then as many of the back,
// four bytes each, square roots of linear light; a period along, all of the ribbon across.
std::vector<std::uint8_t> cloth_pattern_texels();

// From the least to the largest strain: 256 times red, green, blue, opaque, as on a screen.
std::vector<std::uint8_t> strain_colors();

// The player's light: direction of the sun, its radiance, that of the sky above and below.
std::vector<float> light();

}  // namespace ribbon

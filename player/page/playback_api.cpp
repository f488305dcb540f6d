// What worker.js asks of libribbon: C functions, whose arrays live until the next call that changes
// them. A number below 0 says that it did not work; playback_text() then says why.
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "player/page/shown_recording.h"

namespace {

std::string text;
std::unique_ptr<ribbon::ShownRecording> shown;

template <class Array>
int length_of(const Array& array) {
  return static_cast<int>(array.size());
}

const std::vector<std::uint8_t>& pattern() {
  static const auto texels = ribbon::cloth_pattern_texels();
  return texels;
}

}  // namespace

extern "C" {

const char* playback_text() {
  return text.c_str();
}

// How many frames; the text then describes the recording. Otherwise the one that was open stays.
int playback_open(const char* file) {
  auto opened = ribbon::ShownRecording::open(file);
  if (!opened) {
    text = opened.error().sentence();
    return -1;
  }
  shown = std::make_unique<ribbon::ShownRecording>(*std::move(opened));
  text = shown->description();
  return length_of(shown->numbers()) / ribbon::ShownRecording::numbers_per_frame;
}

// What a recording that is being written has gained: how many frames it has now.
int playback_refresh() {
  if (auto done = shown->refresh(); !done) {
    text = done.error().sentence();
    return -1;
  }
  return length_of(shown->numbers()) / ribbon::ShownRecording::numbers_per_frame;
}

// From 0. How many floats its particles have.
int playback_show(int frame) {
  if (auto done = shown->show(frame); !done) {
    text = done.error().sentence();
    return -1;
  }
  return length_of(shown->particles());
}

const float* playback_particles() {
  return shown->particles().data();
}

const double* playback_numbers() {
  return shown->numbers().data();
}

const int* playback_triangles() {
  return shown->triangles().data();
}
int playback_triangles_length() {
  return length_of(shown->triangles());
}

const float* playback_threads() {
  return shown->threads().data();
}
int playback_threads_length() {
  return length_of(shown->threads());
}

const float* playback_obstacle() {
  return shown->obstacle().data();
}
int playback_obstacle_length() {
  return length_of(shown->obstacle());
}

const unsigned char* playback_pattern() {
  return pattern().data();
}
int playback_pattern_length() {
  return length_of(pattern());
}

const unsigned char* playback_strain_colors() {
  static const auto colors = ribbon::strain_colors();
  return colors.data();
}

const float* playback_light() {
  static const auto floats = ribbon::light();
  return floats.data();
}
}

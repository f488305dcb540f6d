// A recording as Python sees it.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <filesystem>

#include "playback/recording_reader.h"

namespace ribbon::python {

class Recording {
 public:
  explicit Recording(const std::filesystem::path& path);

  [[nodiscard]] const RecordingHeader& header() const { return reader_.header(); }
  [[nodiscard]] RecordingReader& reader() { return reader_; }
  [[nodiscard]] const RecordingReader& reader() const { return reader_; }

  // Of a frame as Python counts, where -1 is the last; IndexError where there is none.
  [[nodiscard]] int index_of(int frame) const;

  // along x across x 3, metres.
  pybind11::array positions(int frame);

  // Name -> an array with one number for each frame, which is no number where it is not known.
  [[nodiscard]] pybind11::dict numbers() const;

  // How many frames there are now.
  int refresh();

 private:
  RecordingReader reader_;
};

void bind_recording(pybind11::module_& module);

}  // namespace ribbon::python

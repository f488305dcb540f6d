// A scene that records in a moment: a short band with one loop, drawn tight round nothing.
#pragma once

#include <filesystem>
#include <string>

#include "files/files.h"

namespace ribbon {

inline std::string small_scene_text() {
  return "name = 'small loop'\n"
         "[curve]\n"
         "points = [[-300, 100], [-120, 60], [60, -20], [120, -120], [0, -200], [-120, -120],\n"
         "          [-60, -20], [120, 60], [300, 100]]\n"
         "[ribbon]\nwidth = 0.03\nalong = 60\nacross = 4\nmass = 0.1\n"
         "[springs]\nstretch = 10\nshear = 10\nbend = 5\n"
         "[air]\nresistance = 5\n"
         "[fastening]\nspeed = 0.2\n"
         "[time]\nstep = 0.01\nduration = 0.2\n"
         "[recording]\nframes_per_second = 30\n";
}

// Writes it as `folder`/small.toml.
inline std::filesystem::path write_small_scene(const std::filesystem::path& folder) {
  auto file = folder / "small.toml";
  (void)write_file(file, small_scene_text());
  return file;
}

}  // namespace ribbon

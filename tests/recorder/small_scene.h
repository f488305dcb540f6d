// A scene that records in a moment: a short band with one loop, drawn tight round nothing.
#pragma once

#include <filesystem>
#include <string>

#include "files/files.h"

namespace ribbon {

inline std::string small_scene_text(const std::string& duration_s = "0.2") {
  return "name = 'small loop'\n"
         "[curve]\n"
         "points = [[-300, 100], [-120, 60], [60, -20], [120, -120], [0, -200], [-120, -120],\n"
         "          [-60, -20], [120, 60], [300, 100]]\n"
         "[ribbon]\nwidth = 0.03\nalong = 60\nacross = 4\nmass = 0.1\n"
         "[springs]\nstretch = 10\nshear = 10\nbend = 5\n"
         "[air]\nresistance = 5\n"
         "[fastening]\nspeed = 0.2\n"
         "[time]\nstep = 0.01\nduration = " +
         duration_s +
         "\n"
         "[recording]\nframes_per_second = 30\n";
}

// Writes it as `folder`/small.toml.
inline std::filesystem::path write_small_scene(const std::filesystem::path& folder) {
  auto file = folder / "small.toml";
  (void)write_file(file, small_scene_text());
  return file;
}

// A drawing for it, which ends there.
inline std::string line_to(const std::string& x) {
  return "<svg xmlns='http://www.w3.org/2000/svg'><path id='band' d='M -300 0 L " + x +
         " 0'/></svg>";
}

// The same scene drawn in line.svg, which has to lie beside it.
inline std::string drawn_in_a_file(std::string scene) {
  const std::size_t points = scene.find("points");
  return scene.replace(points, scene.find("[ribbon]") - points, "svg = 'line.svg'\n");
}

// Writes a square post that stops the loop where it closes round it, as `folder`/post.obj.
inline std::filesystem::path write_square_post(const std::filesystem::path& folder) {
  auto file = folder / "post.obj";
  (void)write_file(file,
                   "v -0.03 -0.4 -0.14\nv 0.03 -0.4 -0.14\nv 0.03 -0.4 -0.08\n"
                   "v -0.03 -0.4 -0.08\nv -0.03 0.4 -0.14\nv 0.03 0.4 -0.14\n"
                   "v 0.03 0.4 -0.08\nv -0.03 0.4 -0.08\n"
                   "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n");
  return file;
}

}  // namespace ribbon

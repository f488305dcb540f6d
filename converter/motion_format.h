// The formats that hold a whole motion in one file.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "model/motion_writer.h"

namespace ribbon {

// Where the picture is that a material shows.
enum class PicturePlace { nowhere, inside, beside };  // the format has no materials; in the file

struct MotionFormat {
  std::string_view extension;
  Result<std::unique_ptr<MotionWriter>> (*new_writer)(const std::filesystem::path& path,
                                                      const Model& first_pose, int frames);
  bool deforms_base;  // it holds positions alone, for the mesh of an OBJ beside it
  bool states_rate;   // it says how many frames a second
  bool has_normals;   // it can hold them, for every frame
  PicturePlace picture;
  // What other programs are known to do with such a motion; mostly nothing. Null: never anything.
  std::string (*warning)(const Model& model, int frames);
};

std::span<const MotionFormat> motion_formats();

// The one that the extension of `output` names, in upper or lower case; null: none.
const MotionFormat* motion_format(const std::filesystem::path& output);

}  // namespace ribbon

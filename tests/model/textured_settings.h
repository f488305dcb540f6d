// Settings of models that show pictures.
#pragma once

#include <memory>
#include <utility>

#include "model/model.h"
#include "model/picture_file.h"
#include "model/sample_picture.h"

namespace ribbon {

// A picture of 2 x 1 pixels lies on the ribbon.
inline ModelSettings textured() {
  return {.picture = std::make_shared<const PictureFile>(PictureFile{.bytes = sample_png(),
                                                                     .media_type = "image/png",
                                                                     .extension = ".png",
                                                                     .width = 2,
                                                                     .height = 1,
                                                                     .name = "knot.png"})};
}

// The ribbon is a solid, on whose back lies another picture, of 3 x 1 pixels.
inline ModelSettings textured_on_both_sides() {
  ModelSettings settings = textured();
  PictureFile back = *settings.picture;
  back.bytes += "back";
  back.width = 3;
  back.name = "knot_back.png";
  settings.back_picture = std::make_shared<const PictureFile>(std::move(back));
  settings.thickness_m = 0.002;
  return settings;
}

}  // namespace ribbon

// Options that tell how a ray-traced picture looks, and how much work goes into it.
#pragma once

#include <filesystem>
#include <string>

#include "commandline/arguments.h"
#include "player/render/render.h"
#include "result/result.h"

namespace ribbon {

// As users write it.
struct LookTexts {
  std::string quality = "standard";
  int samples = 0;   // 0: as the quality says
  double noise = 0;  // likewise
  std::filesystem::path texture;
  std::filesystem::path texture_back;
  double thickness_mm = 0;
  bool ground = false;
  std::filesystem::path environment;
  std::string backdrop = "gradient";
  double sun = 1;
  double exposure = 0;
  std::string tone = "linear";
};

void add_look_options(Arguments& arguments, LookTexts& texts);

// Fails when a texture cannot be read.
Result<RenderSettings> read_look(const LookTexts& texts);

}  // namespace ribbon

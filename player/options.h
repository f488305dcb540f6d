// What the user asks ribbon-play for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commandline/arguments.h"
#include "commandline/progress.h"
#include "player/appearance.h"
#include "player/output/existing_file.h"
#include "player/output/play_order.h"
#include "player/picture/picture.h"
#include "player/preview/preview_settings.h"
#include "player/render/render.h"
#include "player/view/view.h"
#include "result/result.h"

namespace ribbon {

struct Options {
  std::filesystem::path recording;
  std::string pictures;         // file pattern of the pictures; empty: none
  std::filesystem::path sheet;  // file of the contact sheet; empty: none
  std::filesystem::path plot;   // file of the charts, .svg or .png; empty: none
  std::string frames;           // as parse_frame_range reads it; empty: all
  PictureSize size;
  std::vector<NamedView> views;       // empty: the three-quarter view
  double turns = 0;                   // of the cameras round the scene
  std::filesystem::path camera_path;  // keyframes; empty: none
  Appearance appearance;
  RenderSettings render;
  std::optional<PreviewSettings> preview;  // instead of ray tracing
  int threads = 0;                         // 0: all cores
  bool info = false;
  bool bench = false;
  bool follow = false;
  bool verify = false;
  int certify_every = 10;  // frames between certificates of the knot
  // Places of the ribbon between which its knot is certified by itself, marks or shares of its
  // length; empty: none.
  std::pair<std::string, std::string> between;
  bool json = false;
  bool quiet = false;
  PlayOrder order;
  Shard shard;
  bool resume = false;      // keep pictures that are complete
  Replaceable replaceable;  // never the recording and what else is read
  std::string isa;          // vector instructions of the ray tracer; empty: the best there are
  std::vector<GivenArgument> given;  // all that was given, as it was written
  ProgressStyle progress = ProgressStyle::line;
};

// Nothing when --help or --version was asked for: that has been printed to standard output. Fails
// when the command line cannot be understood.
Result<std::optional<Options>> parse_player_options(int argc, const char* const* argv);

}  // namespace ribbon

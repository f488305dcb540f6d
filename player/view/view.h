// From where the scene is looked at, in words.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "result/result.h"

namespace ribbon {

enum class Subject { everything, knot };

// The obstacle's axis is y; the knot lies at +z.
struct View {
  float azimuth_deg = 0;    // 0 from the front (+z), 90 from +x
  float elevation_deg = 0;  // 0 level, 90 straight down
  Subject subject = Subject::everything;
  float distance_m = 0;  // of the eye from the middle of the subject; 0: all of it just fits
  // Focal length for a picture whose shorter side is 24 mm. A long lens: perspective is felt, but
  // what comes near does not swell.
  float lens_mm = 60;

  bool operator==(const View&) const = default;
};

// A number of a view by the name that users give it, and from where to where it may be.
struct ViewSetting {
  std::string_view name;
  float View::*value;
  float least;
  float most;
};

inline constexpr float shortest_lens_mm = 8;
inline constexpr std::array<ViewSetting, 4> view_settings{{
    {"azimuth", &View::azimuth_deg, -36000, 36000},
    {"elevation", &View::elevation_deg, -90, 90},
    {"distance", &View::distance_m, 1e-3F, 1e4F},
    {"lens", &View::lens_mm, shortest_lens_mm, 1200},
}};

inline constexpr View front_view{0, 8};
inline constexpr View top_view{0, 90};
inline constexpr View three_quarter_view{36, 22};
inline constexpr View knot_view{14, 16, Subject::knot};

// A name (front, top, three-quarter, knot), or settings that change the three-quarter view, as in
// "azimuth=-30,elevation=10,distance=2,lens=85,subject=knot". Fails when it is neither, or a number
// is out of its range.
Result<View> parse_view(const std::string& text);

struct NamedView {
  std::string name;  // stands for it in file names
  View view;
};

// One after the other. Views without a name are called camera1, camera2, ... Fails as parse_view()
// does, and when a view is asked for twice.
Result<std::vector<NamedView>> parse_views(const std::vector<std::string>& texts);

}  // namespace ribbon

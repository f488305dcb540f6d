#include "scene/scene_rules.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "scene/scene_values.h"
#include "scene/stage_rules.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr double most_steps = 1e9;
constexpr double default_frames_per_second = 50;
constexpr double default_clearance_of_width = 0.1;
constexpr double default_frames_per_checkpoint = 10'000;

Result<void> one_drawing(const Document& document, const Scene&) {
  const bool svg = document.find("curve", "svg") != nullptr;
  const bool points = document.find("curve", "points") != nullptr;
  if (svg && points)
    return failure(document.place("curve", "points"), "[curve] has both 'svg' and 'points'",
                   "remove one of them");
  if (!svg && !points)
    return failure(document.place("curve", ""), "[curve] has no drawing",
                   "write for example 'svg = \"overhand.svg\"' or 'points = [[0, 0], [100, 50]]'");
  if (points && document.find("curve", "path") != nullptr)
    return failure(document.place("curve", "path"),
                   "'path' names a path of an SVG file, but the drawing is a list of 'points'",
                   "remove 'path', or replace 'points' by 'svg'");
  return {};
}

Result<void> one_width(const Document& document, const Scene&) {
  const bool width = document.find("ribbon", "width") != nullptr;
  const bool outline = document.find("ribbon", "outline") != nullptr;
  if (width && outline)
    return failure(document.place("ribbon", "outline"), "[ribbon] has both 'width' and 'outline'",
                   "remove one of them");
  if (!outline && document.find("ribbon", "outline_path") != nullptr)
    return failure(document.place("ribbon", "outline_path"),
                   "'outline_path' names a path of an SVG file, but there is no 'outline'",
                   "add for example 'outline = \"tie.svg\"', or remove 'outline_path'");
  if (width || outline) return {};
  return failure(document.place("ribbon", ""), "'width' is missing in [ribbon]",
                 "add for example 'width = 0.05'");
}

Result<void> one_way_to_pass_over(const Document& document, const Scene& scene) {
  if (!scene.curve.crossings || document.find("curve", "first") == nullptr) return {};
  return failure(document.place("curve", "first"),
                 "[curve] has both 'first' and 'crossings', which says it of every passage",
                 "remove one of them");
}

Result<void> expected_between_places(const Document& document, const Scene& scene) {
  if (!scene.knot || !scene.knot->expect_between || scene.knot->between) return {};
  return failure(document.place("knot", "expect_between"),
                 "'expect_between' is the knot of a part of the band, but no part is told",
                 R"(add for example 'between = ["tip-left", "tip-right"]')");
}

Result<void> countable_particles(const Document& document, const Scene& scene) {
  if (scene.ribbon.across > scene_values::most_columns)
    return failure(document.place("ribbon", "across"), "'across' is more than a recording holds",
                   "write at most " + std::to_string(scene_values::most_columns));
  const std::int64_t particles = std::int64_t{scene.ribbon.along} * scene.ribbon.across;
  if (particles <= scene_values::most_particles) return {};
  return failure(document.place("ribbon", "along"),
                 "'along' times 'across' is " + std::to_string(particles) + " particles",
                 "write smaller numbers, at most " + std::to_string(scene_values::most_particles) +
                     " particles together");
}

// Thicker, each layer would meet all others, and lists of what touches would fill the memory.
Result<void> cloth_is_flat(const Document& document, const Scene& scene) {
  if (scene.ribbon.outline || scene.ribbon.thickness_m <= scene.ribbon.width_m) return {};
  return failure(document.place("ribbon", "thickness"),
                 "'thickness' is " + shortest(scene.ribbon.thickness_m) +
                     " m, more than the 'width' of the ribbon",
                 "write the thickness of the cloth in metres, for example 'thickness = 0.001'");
}

Result<void> countable_steps(const Document& document, const Scene& scene) {
  const double steps = scene.time.duration_s / scene.time.step_s;
  if (steps < 1 - 1e-9)
    return failure(document.place("time", "duration"),
                   "'duration' is shorter than one 'step' of " + shortest(scene.time.step_s) + " s",
                   "write a longer duration or a shorter step");
  if (steps > most_steps)
    return failure(
        document.place("time", "duration"),
        "'duration' is " + shortest(std::round(steps)) + " steps of " +
            shortest(scene.time.step_s) + " s",
        "write a shorter duration, a longer step or fewer frames per second, at most 1e9 "
        "steps");
  return {};
}

Result<void> fastening_against_air(const Document& document, const Scene& scene) {
  if (!scene.fastening || scene.air_resistance_per_s > 0) return {};
  return failure(document.place("fastening", ""),
                 "[fastening] needs air resistance, because its force is the one that reaches "
                 "'speed' against it",
                 "write for example 'resistance = 10' in [air]");
}

Result<void> tight_by_fastening(const Document& document, const Scene& scene) {
  if (scene.fastening || scene.time.until == RunsUntil::duration) return {};
  return failure(document.place("time", "until"),
                 "a ribbon that nothing pulls never becomes 'tight'",
                 "add '[fastening]' with for example 'speed = 0.5' below it, or remove 'until'");
}

// A fabric that has nothing to tell was named in vain.
Result<void> fabric_tells_something(const Document& document, const Scene& scene) {
  if (!scene.cloth) return {};
  const ClothScene& cloth = *scene.cloth;
  if (cloth.tells_thickness || cloth.tells_mass || cloth.tells_stretch || cloth.tells_shear ||
      cloth.tells_bend || document.find("springs", "damping") == nullptr ||
      document.find("friction", "coefficient") == nullptr)
    return {};
  return failure(cloth.place,
                 "the scene says all that " + in_quotes(cloth.fabric.name) + " would tell itself",
                 "remove 'fabric', or what it shall tell: 'mass' and 'thickness' in [ribbon], "
                 "[springs], [friction]");
}

// What the scene says itself counts.
void set_cloth(const Document& document, Scene& scene) {
  if (!scene.cloth) return;
  ClothScene& cloth = *scene.cloth;
  const auto tells = [&](std::string_view table, std::string_view key) {
    return document.find(table, key) == nullptr;
  };
  cloth.tells_thickness = tells("ribbon", "thickness");
  cloth.tells_mass = tells("ribbon", "mass");
  cloth.tells_stretch = tells("springs", "stretch");
  cloth.tells_shear = tells("springs", "shear");
  cloth.tells_bend = tells("springs", "bend");
  if (cloth.tells_thickness) scene.ribbon.thickness_m = cloth.fabric.thickness_m;
  if (tells("springs", "damping")) scene.springs.damping = cloth.fabric.damping;
  if (tells("friction", "coefficient")) scene.friction = cloth.fabric.friction;
}

// Every frame is to be that of its time, so each begins with a step: taken at the first step after
// their times, frames would be now one step apart and now another, and what moves evenly would
// judder.
void fit_steps_to_frames(Scene& scene) {
  constexpr double negligible = 1e-9;  // of the steps in a frame
  const double frame_s = 1 / scene.recording.frames_per_second;
  const double steps = frame_s / scene.time.step_s;
  if (std::abs(steps - std::round(steps)) <= negligible * steps) return;
  scene.time.step_s = frame_s / std::ceil(steps);
}

// Hands pull and yield as [fastening] says, unless they say otherwise.
void set_defaults_of_stages(Scene& scene) {
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    StageScene& stage = scene.stages[i];
    if (stage.name.empty()) stage.name = "stage " + std::to_string(i + 1);
    for (HandScene& hand : stage.hands) {
      if (!scene.fastening) continue;
      if (hand.speed_m_s == 0) hand.speed_m_s = scene.fastening->speed_m_s;
      if (!hand.yield_strain && hand.task && pulls(*hand.task))
        hand.yield_strain = scene.fastening->yield_strain;
    }
  }
}

}  // namespace

void set_defaults(const Document& document, Scene& scene) {
  scene.ribbon.width_m = mean_width_m(scene.ribbon);
  set_cloth(document, scene);
  if (scene.curve.clearance_m == 0)
    scene.curve.clearance_m = default_clearance_of_width * scene.ribbon.width_m;
  if (document.find("recording", "frames_per_second") == nullptr)
    scene.recording.frames_per_second = std::min(default_frames_per_second, 1 / scene.time.step_s);
  if (document.find("recording", "checkpoint_every") == nullptr)
    scene.recording.checkpoint_every_s =
        default_frames_per_checkpoint / scene.recording.frames_per_second;
  fit_steps_to_frames(scene);
  set_defaults_of_stages(scene);
}

Result<void> check_rules(const Document& document, const Scene& scene) {
  for (const auto& rule :
       {one_drawing, one_width, one_way_to_pass_over, expected_between_places, countable_particles,
        fabric_tells_something, cloth_is_flat, countable_steps, fastening_against_air,
        tight_by_fastening, check_stages})
    if (auto kept = rule(document, scene); !kept) return kept;
  return {};
}

}  // namespace ribbon

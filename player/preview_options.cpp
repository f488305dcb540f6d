#include "player/preview_options.h"

#include <algorithm>
#include <array>
#include <string>

namespace ribbon {

namespace {

// What only the ray tracer does; machines of different makers may draw previews differently.
constexpr std::array without_preview{
    "--quality",  "--noise", "--thickness", "--ground", "--environment", "--sun",  "--backdrop",
    "--exposure", "--tone",  "--color-by",  "--shard",  "--isa",         "--bench"};

tl::unexpected<Error> refusal(const std::string& other) {
  return failure("--preview", "does not go with " + other, "leave one of them out");
}

}  // namespace

Result<PreviewSettings> read_preview(const Options& options, int samples) {
  for (const GivenArgument& argument : options.given)
    if (std::find(without_preview.begin(), without_preview.end(), argument.name) !=
        without_preview.end())
      return refusal(argument.name);
  const Overlays& overlays = options.appearance.overlays;
  if (overlays.wireframe || overlays.obstacle_wireframe) return refusal("wireframe overlays");
  return PreviewSettings{samples > 1, options.render.cloth, options.threads};
}

}  // namespace ribbon

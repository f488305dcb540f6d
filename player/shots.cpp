#include "player/shots.h"

#include <utility>

namespace ribbon {

namespace {

constexpr std::string_view place_of_view = "{view}";

std::vector<NamedView> views_of(const Options& options) {
  if (options.views.empty()) return {{"three-quarter", three_quarter_view}};
  return options.views;
}

std::string with_view(std::string pattern, const std::string& name) {
  for (std::size_t at = pattern.find(place_of_view); at != std::string::npos;
       at = pattern.find(place_of_view, at + name.size()))
    pattern.replace(at, place_of_view.size(), name);
  return pattern;
}

}  // namespace

Result<std::vector<Shot>> shots_of(const Options& options) {
  std::vector<Shot> shots;
  for (const NamedView& view : views_of(options)) {
    Shot shot{view.view, options.size, options.turns, std::nullopt};
    if (!options.camera_path.empty()) {
      auto path = CameraPath::read(options.camera_path, view.view);
      if (!path) return tl::unexpected(path.error());
      shot.path = std::move(*path);
    }
    shots.push_back(std::move(shot));
  }
  return shots;
}

Result<std::vector<std::string>> output_names(const Options& options) {
  const auto views = views_of(options);
  if (views.size() > 1 && options.pictures.find(place_of_view) == std::string::npos)
    return failure("", "several views would write the same files",
                   "put {view} into the name, as in '{view}/{frame:04}.png'");
  std::vector<std::string> names;
  names.reserve(views.size());
  for (const NamedView& view : views) names.push_back(with_view(options.pictures, view.name));
  return names;
}

}  // namespace ribbon

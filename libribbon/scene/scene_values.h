// Kinds of values that a scene is made of. Each fails, with the place, where what stands in the
// file is none of its kind.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "result/result.h"
#include "scene/document.h"
#include "scene/scene.h"
#include "scene/toml.h"

namespace ribbon::scene_values {

// What a recording holds at most (libribbon/recording/FORMAT.md, section 4).
inline constexpr std::int64_t most_particles = std::int64_t{1} << 24;
inline constexpr std::int64_t most_columns = std::int64_t{1} << 20;

// What stands behind a key.
struct Value {
  std::string_view key;
  std::string_view example;  // a value as one may write it
  const TomlValue& toml;
  const Document& document;
};

// What a value is, in words.
std::string written(const TomlValue& value);

// `part` is the value itself or the part of it that is wrong.
tl::unexpected<Error> wrong(const Value& value, const TomlValue& part, const std::string& duty);

struct Range {
  std::string_view words;
  double lowest;
  double highest;
};

// The far ends are where squares and cubes of lengths still are ordinary numbers.
inline constexpr Range any_number{"from -1e12 to 1e12", -1e12, 1e12};
inline constexpr Range not_negative{"from 0 to 1e12", 0, 1e12};
inline constexpr Range positive{"above 0 (from 1e-12 to 1e12)", 1e-12, 1e12};
inline constexpr Range lossy{"from 1e-7 to 0.01, or 0", least_position_error, most_position_error};

// Nothing where it is no number, or not in the range.
std::optional<double> number_within(const Range& range, const TomlValue& value);

inline auto number(const Range& range) {
  return [range](const Value& value) -> Result<double> {
    if (const auto number = number_within(range, value.toml)) return *number;
    return wrong(value, value.toml, "a number " + std::string(range.words));
  };
}
Result<double> position_error(const Value& value);
// Or "never".
Result<double> yield_strain(const Value& value);
Result<int> particle_count(const Value& value);

// Of one line, and not empty.
Result<std::string> text(const Value& value);
// Relative to the scene's folder.
Result<NamedFile> file_name(const Value& value);
// The letters O, U, F and B; blanks between them are left out.
Result<CrossingList> crossing_list(const Value& value);
Result<NamedKnot> named_knot(const Value& value);

template <class Meaning>
auto one_of(std::vector<std::pair<std::string_view, Meaning>> words) {
  return [words = std::move(words)](const Value& value) -> Result<Meaning> {
    std::string list;
    for (const auto& [word, meaning] : words) {
      if (const auto* text = value.toml.as<std::string>(); text != nullptr && *text == word)
        return meaning;
      list += (list.empty() ? "\"" : ", \"") + std::string(word) + "\"";
    }
    return wrong(value, value.toml, "one of " + list);
  };
}

template <int size>
using Coordinates = Eigen::Matrix<double, size, 1>;

template <int size>
Result<Coordinates<size>> coordinates(const Value& value);
// Of unit length.
Result<Coordinates<3>> direction(const Value& value);
// As a vector, or as a number down, along -y. Nothing where it is zero.
Result<std::optional<Eigen::Vector3d>> gravity(const Value& value);
Result<std::vector<Eigen::Vector2d>> points(const Value& value);
// Of an array.
Result<WidthProfile> width_profile(const Value& value);

// One number, or pairs of a share of a path's length and a height.
Result<std::vector<HeightAt>> heights(const Value& value);
// The id of a path, or points.
Result<std::variant<PathId, std::vector<Eigen::Vector2d>>> carry_path(const Value& value);

Result<std::variant<double, StageGoal>> seconds_or_goal(const Value& value);
// Two shares of its length, or a mark.
Result<std::variant<Span, Mark>> part_of_band(const Value& value);
// Two of shares and marks.
Result<BandPart> two_places(const Value& value);

}  // namespace ribbon::scene_values

#include "scene/scene_values.h"

#include <algorithm>
#include <cmath>

#include "geometry/vectors.h"
#include "text/number_text.h"

namespace ribbon::scene_values {

namespace {

// What has another size at each share of a length: a width, a height.
struct Sizes {
  std::string_view what;
  Range range;
};

// The next of the pairs [share, size], of which `before` have been read.
template <class SizeAt>
Result<SizeAt> size_at(const Value& value, const Sizes& sizes, const TomlValue& pair,
                       const std::vector<SizeAt>& before, bool is_last) {
  const std::string what(sizes.what);
  const auto* numbers = pair.as<TomlArray>();
  if (numbers == nullptr || numbers->size() != 2)
    return wrong(value, pair, "pairs of a share of the length and a " + what);
  const double least = before.empty() ? 0 : std::nextafter(before.back().share, 2);
  const double most = before.empty() ? 0 : 1;
  const auto share =
      number_within({"", is_last ? std::max(1.0, least) : least, most}, (*numbers)[0]);
  if (!share)
    return wrong(value, (*numbers)[0], "pairs whose shares of the length rise from 0 to 1");
  const auto size_m = number_within(sizes.range, (*numbers)[1]);
  if (!size_m)
    return wrong(value, (*numbers)[1],
                 "pairs with a " + what + " " + std::string(sizes.range.words));
  return SizeAt{*share, *size_m};
}

// Of a number or an array.
template <class SizeAt>
Result<std::vector<SizeAt>> sizes_along(const Value& value, const Sizes& sizes) {
  const auto* pairs = value.toml.as<TomlArray>();
  if (pairs == nullptr || pairs->size() < 2)
    return wrong(
        value, value.toml,
        "a number, or at least 2 pairs [share of the length, " + std::string(sizes.what) + "]");
  std::vector<SizeAt> all;
  for (const TomlValue& pair : *pairs) {
    const auto next = size_at(value, sizes, pair, all, &pair == &pairs->back());
    if (!next) return tl::unexpected(next.error());
    all.push_back(*next);
  }
  return all;
}

// 120.0 is no whole number, and is not to look like one.
std::string real_number(double number) {
  const std::string text = shortest(number);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

// A few numbers and the like as they stand there; of more, how many they are.
std::string written_array(const TomlArray& array) {
  constexpr std::size_t few = 4;
  const bool is_flat = std::none_of(array.begin(), array.end(), [](const TomlValue& one) {
    return one.as<TomlArray>() != nullptr || one.as<TomlTable>() != nullptr;
  });
  if (!is_flat || array.size() > few) return "an array of " + std::to_string(array.size());
  std::string text = "[";
  for (const TomlValue& one : array) {
    if (text.size() > 1) text += ", ";
    const auto* words = one.as<std::string>();
    text += words != nullptr ? in_quotes(*words) : written(one);
  }
  return text + "]";
}

}  // namespace

std::string written(const TomlValue& value) {
  if (const auto* number = value.as<std::int64_t>()) return std::to_string(*number);
  if (const auto* number = value.as<double>()) return real_number(*number);
  if (const auto* text = value.as<std::string>()) return "the text " + in_quotes(*text);
  if (const auto* truth = value.as<bool>()) return *truth ? "true" : "false";
  if (const auto* array = value.as<TomlArray>()) return written_array(*array);
  return value.as<TomlTable>() != nullptr ? "a table" : "a date or time";
}

tl::unexpected<Error> wrong(const Value& value, const TomlValue& part, const std::string& duty) {
  return failure(
      value.document.place(part.begin),
      in_quotes(value.key) + " must be " + duty + ", not " + written(part),
      "write for example '" + std::string(value.key) + " = " + std::string(value.example) + "'");
}

std::optional<double> number_within(const Range& range, const TomlValue& value) {
  const auto* whole = value.as<std::int64_t>();
  const auto* real = value.as<double>();
  if (whole == nullptr && real == nullptr) return std::nullopt;
  const double number = whole != nullptr ? static_cast<double>(*whole) : *real;
  const bool inside = number >= range.lowest && number <= range.highest;  // false for NaN
  return inside ? std::optional(number) : std::nullopt;
}

Result<double> position_error(const Value& value) {
  if (number_within({"", 0, 0}, value.toml)) return 0.0;
  return number(lossy)(value);
}

Result<double> yield_strain(const Value& value) {
  const auto* text = value.toml.as<std::string>();
  if (text != nullptr && *text == "never") return unyielding;
  if (const auto strain = number_within({"", 1e-3, 1}, value.toml)) return *strain;
  return wrong(value, value.toml, R"(a number from 0.001 to 1, or "never")");
}

Result<int> particle_count(const Value& value) {
  const auto* count = value.toml.as<std::int64_t>();
  if (count == nullptr || *count < 2)
    return wrong(value, value.toml, "a whole number of at least 2");
  if (*count > most_particles)
    return wrong(value, value.toml, "at most " + std::to_string(most_particles));
  return static_cast<int>(*count);
}

Result<std::string> text(const Value& value) {
  const auto* text = value.toml.as<std::string>();
  const bool one_line = text != nullptr && !text->empty() &&
                        std::none_of(text->begin(), text->end(), [](unsigned char letter) {
                          return letter < ' ' || letter == 127;
                        });
  if (!one_line) return wrong(value, value.toml, "a text of one line that is not empty");
  return *text;
}

Result<NamedFile> file_name(const Value& value) {
  return text(value).map([&](const std::string& name) {
    return NamedFile{(value.document.file.parent_path() / name).lexically_normal(),
                     value.document.place(value.toml.begin)};
  });
}

Result<CrossingList> crossing_list(const Value& value) {
  auto list = text(value);
  if (!list) return tl::unexpected(list.error());
  std::erase(*list, ' ');
  const std::size_t other = list->find_first_not_of("OUFB");
  if (other != std::string::npos)
    return failure(value.document.place(value.toml.begin),
                   "letter " + std::to_string(other + 1) + " of 'crossings' is " +
                       in_quotes(list->substr(other, 1)),
                   "write O for each passage over and U for each passage under, F in front of the "
                   "object and B behind it, as in '" +
                       std::string(value.key) + " = " + std::string(value.example) + "'");
  return CrossingList{*std::move(list), value.document.place(value.toml.begin)};
}

Result<NamedKnot> named_knot(const Value& value) {
  return text(value).map([&](const std::string& name) {
    return NamedKnot{name, value.document.place(value.toml.begin)};
  });
}

template <int size>
Result<Coordinates<size>> coordinates(const Value& value) {
  const std::string duty =
      std::to_string(size) + " numbers " + std::string(any_number.words) + " in brackets";
  const auto* array = value.toml.as<TomlArray>();
  if (array == nullptr || array->size() != size) return wrong(value, value.toml, duty);
  Coordinates<size> vector;
  for (int i = 0; i < size; ++i) {
    const TomlValue& element = (*array)[i];
    const auto number = number_within(any_number, element);
    if (!number) return wrong(value, element, duty);
    vector[i] = *number;
  }
  return vector;
}

template Result<Coordinates<2>> coordinates<2>(const Value& value);
template Result<Coordinates<3>> coordinates<3>(const Value& value);

Result<Coordinates<3>> direction(const Value& value) {
  auto vector = coordinates<3>(value);
  if (vector && vector->isZero(0))
    return wrong(value, value.toml, "a direction that is not all zeros");
  // The smallest numbers there are have few digits; larger by a power of two they lose none.
  return vector.map([](const Coordinates<3>& direction) -> Coordinates<3> {
    return safely_normalised(0x1p600 * direction);
  });
}

Result<std::optional<Eigen::Vector3d>> gravity(const Value& value) {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  if (value.toml.as<TomlArray>() != nullptr) {
    const auto vector = coordinates<3>(value);
    if (!vector) return tl::unexpected(vector.error());
    acceleration = *vector;
  } else if (const auto down = number_within(not_negative, value.toml)) {
    acceleration.y() = -*down;
  } else {
    return wrong(value, value.toml,
                 "a number " + std::string(not_negative.words) + ", down along -y, or 3 numbers");
  }
  return acceleration.isZero(0) ? std::nullopt : std::optional(acceleration);
}

Result<std::vector<Eigen::Vector2d>> points(const Value& value) {
  const auto* array = value.toml.as<TomlArray>();
  if (array == nullptr || array->size() < 2)
    return wrong(value, value.toml, "at least 2 points, each [x, y]");
  std::vector<Eigen::Vector2d> points;
  for (const TomlValue& element : *array) {
    const auto point = coordinates<2>({value.key, value.example, element, value.document});
    if (!point) return tl::unexpected(point.error());
    points.push_back(*point);
  }
  return points;
}

Result<WidthProfile> width_profile(const Value& value) {
  return sizes_along<WidthAt>(value, {"width", positive}).map([&](std::vector<WidthAt>&& points) {
    return WidthProfile{std::move(points), value.document.place(value.toml.begin)};
  });
}

Result<std::vector<HeightAt>> heights(const Value& value) {
  if (const auto everywhere = number_within(any_number, value.toml))
    return std::vector{HeightAt{0, *everywhere}};
  return sizes_along<HeightAt>(value, {"height", any_number});
}

Result<std::variant<PathId, std::vector<Eigen::Vector2d>>> carry_path(const Value& value) {
  using Path = std::variant<PathId, std::vector<Eigen::Vector2d>>;
  if (value.toml.as<TomlArray>() != nullptr)
    return points(value).map(
        [](std::vector<Eigen::Vector2d>&& path) { return Path(std::move(path)); });
  return text(value).map([&](const std::string& id) {
    return Path(PathId{id, value.document.place(value.toml.begin)});
  });
}

Result<std::variant<double, StageGoal>> seconds_or_goal(const Value& value) {
  using Until = std::variant<double, StageGoal>;
  const auto* text = value.toml.as<std::string>();
  if (text != nullptr && *text == "tight") return Until(StageGoal::tight);
  if (text != nullptr && *text == "carried") return Until(StageGoal::carried);
  if (const auto seconds = number_within(positive, value.toml)) return Until(*seconds);
  return wrong(value, value.toml, R"("tight", "carried" or a number of seconds)");
}

Result<std::variant<Span, Mark>> part_of_band(const Value& value) {
  if (value.toml.as<std::string>() != nullptr)
    return text(value).map([&](const std::string& id) {
      return Mark{id, value.document.place(value.toml.begin)};
    });
  const auto shares = coordinates<2>(value);
  if (shares && 0 <= shares->x() && shares->x() <= shares->y() && shares->y() <= 1)
    return Span{shares->x(), shares->y()};
  return wrong(value, value.toml,
               "two shares of the band's length from 0 to 1, the smaller first, or the id of a "
               "circle in the drawing");
}

Result<BandPart> two_places(const Value& value) {
  const auto* array = value.toml.as<TomlArray>();
  const std::string duty =
      "two places of the band, each the id of a circle in the drawing or a "
      "share of its length from 0 to 1";
  if (array == nullptr || array->size() != 2) return wrong(value, value.toml, duty);
  BandPart part;
  for (std::size_t i = 0; i < 2; ++i) {
    const TomlValue& element = (*array)[i];
    const auto share = number_within({"", 0, 1}, element);
    const auto id = text({value.key, value.example, element, value.document});
    if (!share && !id) return wrong(value, element, duty);
    if (share)
      part.ends[i] = *share;
    else
      part.ends[i] = Mark{*id, value.document.place(element.begin)};
  }
  if (part.ends[0] == part.ends[1]) return wrong(value, value.toml, "two places that differ");
  return part;
}

}  // namespace ribbon::scene_values

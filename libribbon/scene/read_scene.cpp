// Reads a scene by a table of its keys: what each is called, how it is checked and where it goes.
// The few rules that join two keys follow the table.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string_view>
#include <utility>

#include "files/files.h"
#include "geometry/vectors.h"
#include "scene/accuracy.h"
#include "scene/document.h"
#include "scene/nearest_word.h"
#include "scene/scene.h"
#include "scene/setting.h"
#include "scene/stage_rules.h"

namespace ribbon {

namespace {

// What a recording holds at most (libribbon/recording/FORMAT.md, section 3).
constexpr std::int64_t most_particles = std::int64_t{1} << 24;
constexpr std::int64_t most_columns = std::int64_t{1} << 20;
constexpr double most_steps = 1e9;
constexpr double default_frames_per_second = 50;
constexpr double default_clearance_of_width = 0.1;
constexpr double default_frames_per_checkpoint = 10'000;

// ---- What a value of the file is, and what to say when it is not what it should be

std::string written(const TomlValue& value) {
  if (const auto* number = value.as<std::int64_t>()) return std::to_string(*number);
  if (const auto* number = value.as<double>()) return shortest(*number);
  if (const auto* text = value.as<std::string>()) return "the text " + in_quotes(*text);
  if (const auto* truth = value.as<bool>()) return *truth ? "true" : "false";
  if (const auto* array = value.as<TomlArray>())
    return "an array of " + std::to_string(array->size());
  return value.as<TomlTable>() != nullptr ? "a table" : "a date or time";
}

struct Value {
  std::string_view key;
  std::string_view example;  // a value as one may write it
  const TomlValue& toml;
  const Document& document;
};

// `part` is the value itself or the part of it that is wrong.
tl::unexpected<Error> wrong(const Value& value, const TomlValue& part, const std::string& duty) {
  return failure(
      value.document.place(part.begin),
      in_quotes(value.key) + " must be " + duty + ", not " + written(part),
      "write for example '" + std::string(value.key) + " = " + std::string(value.example) + "'");
}

struct Range {
  std::string_view words;
  double lowest;
  double highest;
};

// The far ends are where squares and cubes of lengths still are ordinary numbers.
constexpr Range any_number{"from -1e12 to 1e12", -1e12, 1e12};
constexpr Range not_negative{"from 0 to 1e12", 0, 1e12};
constexpr Range positive{"above 0 (from 1e-12 to 1e12)", 1e-12, 1e12};
constexpr Range yield_strain{"from 0.001 to 1", 1e-3, 1};
constexpr Range lossy{"from 1e-7 to 0.01, or 0", 1e-7, 0.01};

std::optional<double> number_within(const Range& range, const TomlValue& value) {
  const auto* whole = value.as<std::int64_t>();
  const auto* real = value.as<double>();
  if (whole == nullptr && real == nullptr) return std::nullopt;
  const double number = whole != nullptr ? static_cast<double>(*whole) : *real;
  const bool inside = number >= range.lowest && number <= range.highest;  // false for NaN
  return inside ? std::optional(number) : std::nullopt;
}

// ---- Kinds of values. Each gives a function from Value to Result.

auto number(const Range& range) {
  return [range](const Value& value) -> Result<double> {
    if (const auto number = number_within(range, value.toml)) return *number;
    return wrong(value, value.toml, "a number " + std::string(range.words));
  };
}

Result<double> position_error(const Value& value) {
  if (number_within({"", 0, 0}, value.toml)) return 0.0;
  return number(lossy)(value);
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

// The letters O and U, blanks between them left out.
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

Result<Coordinates<3>> direction(const Value& value) {
  auto vector = coordinates<3>(value);
  if (vector && squared_length_of(*vector) == 0)
    return wrong(value, value.toml, "a direction that is not all zeros");
  return vector.map([](const Coordinates<3>& direction) -> Coordinates<3> {
    return safely_normalised(direction);
  });
}

// As a vector, or as a number down, along -y. Nothing where it is zero.
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

// The next of the pairs [share, width] of a profile, of which `before` have been read.
Result<WidthAt> width_at(const Value& value, const TomlValue& pair,
                         const std::vector<WidthAt>& before, bool is_last) {
  const auto* numbers = pair.as<TomlArray>();
  if (numbers == nullptr || numbers->size() != 2)
    return wrong(value, pair, "pairs of a share of the length and a width");
  const double least = before.empty() ? 0 : std::nextafter(before.back().share, 2);
  const double most = before.empty() ? 0 : 1;
  const auto share = number_within({"", is_last ? 1 : least, most}, (*numbers)[0]);
  if (!share)
    return wrong(value, (*numbers)[0], "pairs whose shares of the length rise from 0 to 1");
  const auto width_m = number_within(positive, (*numbers)[1]);
  if (!width_m)
    return wrong(value, (*numbers)[1], "pairs with a width " + std::string(positive.words));
  return WidthAt{*share, *width_m};
}

// Of an array.
Result<WidthProfile> width_profile(const Value& value) {
  const auto& pairs = *value.toml.as<TomlArray>();
  if (pairs.size() < 2)
    return wrong(value, value.toml, "a number, or at least 2 pairs [share of the length, width]");
  WidthProfile profile{{}, value.document.place(value.toml.begin)};
  for (const TomlValue& pair : pairs) {
    const auto next = width_at(value, pair, profile.points, &pair == &pairs.back());
    if (!next) return tl::unexpected(next.error());
    profile.points.push_back(*next);
  }
  return profile;
}

Result<std::optional<double>> seconds_or_tight(const Value& value) {
  if (const auto* text = value.toml.as<std::string>(); text != nullptr && *text == "tight")
    return std::nullopt;
  if (const auto seconds = number_within(positive, value.toml)) return seconds;
  return wrong(value, value.toml, "\"tight\" or a number of seconds");
}

// Two shares of its length, or a mark.
Result<std::variant<Span, Mark>> part_of_band(const Value& value) {
  if (value.toml.as<std::string>() != nullptr)
    return text(value).map([](std::string id) { return Mark{std::move(id)}; });
  const auto shares = coordinates<2>(value);
  if (shares && 0 <= shares->x() && shares->x() <= shares->y() && shares->y() <= 1)
    return Span{shares->x(), shares->y()};
  return wrong(value, value.toml,
               "two shares of the band's length from 0 to 1, the smaller first, or the id of a "
               "circle in the drawing");
}

// Two of shares and marks.
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
      part.ends[i] = Mark{*id};
  }
  if (part.ends[0] == part.ends[1]) return wrong(value, value.toml, "two places that differ");
  return part;
}

// ---- Where values go

using Reader = std::function<Result<void>(const Value&, Scene&)>;

// `target` gives the place in the scene, `read` is one of the kinds above.
template <class Target, class Read>
Reader set(Target target, Read read) {
  return [=](const Value& value, Scene& scene) {
    return read(value).map([&](const auto& meaning) { std::invoke(target, scene) = meaning; });
  };
}

template <class Part, class Member>
auto in(Part Scene::*part, Member Part::*member) {
  return [=](Scene& scene) -> Member& { return scene.*part.*member; };
}

// A part that a scene may leave out comes into being with its first key.
template <class Part, class Member>
auto in(std::optional<Part> Scene::*part, Member Part::*member) {
  return [=](Scene& scene) -> Member& {
    std::optional<Part>& optional = scene.*part;
    return (optional ? *optional : optional.emplace()).*member;
  };
}

template <class Member>
auto in_drawn_svg(Member DrawnSvg::*member) {
  return [=](Scene& scene) -> Member& { return std::get<DrawnSvg>(scene.curve.drawing).*member; };
}

std::vector<Eigen::Vector2d>& drawn_points(Scene& scene) {
  return scene.curve.drawing.emplace<DrawnPoints>().points;
}

std::vector<std::pair<std::string_view, const AccuracyLevel*>> accuracy_words() {
  std::vector<std::pair<std::string_view, const AccuracyLevel*>> words;
  words.reserve(accuracy_levels.size());
  for (const AccuracyLevel& level : accuracy_levels) words.emplace_back(level.word, &level);
  return words;
}

// The scene's own keys overwrite what the level sets: they are read later, in the tables below.
Reader set_level() {
  return [](const Value& value, Scene& scene) {
    return one_of(accuracy_words())(value).map(
        [&](const AccuracyLevel* level) { set_accuracy(*level, scene); });
  };
}

// Of the stage, or of its hand, that is being read.
template <class Member>
auto in_stage(Member StageScene::*member) {
  return [=](Scene& scene) -> Member& { return scene.stages.back().*member; };
}
template <class Member>
auto in_hand(Member HandScene::*member) {
  return [=](Scene& scene) -> Member& { return scene.stages.back().hands.back().*member; };
}

Result<void> read_pull(const Value& value, Scene& scene) {
  HandScene& hand = scene.stages.back().hands.back();
  if (value.toml.as<std::string>() != nullptr)
    return one_of<HandTask>(
               {{"along", HandTask::pull_along}, {"outwards", HandTask::pull_outwards}})(value)
        .map([&](HandTask task) { hand.task = task; });
  hand.task = HandTask::pull;
  return direction(value).map([&](const Coordinates<3>& unit) { hand.direction = unit; });
}

Result<void> read_hold(const Value& value, Scene& scene) {
  const auto* truth = value.toml.as<bool>();
  if (truth == nullptr || !*truth) return wrong(value, value.toml, "true, or not there");
  scene.stages.back().hands.back().task = HandTask::hold;
  return {};
}

// One number, or a profile; one that is as wide everywhere is one number.
Result<void> read_width(const Value& value, Scene& scene) {
  RibbonScene& ribbon = scene.ribbon;
  if (value.toml.as<TomlArray>() == nullptr)
    return number(positive)(value).map([&ribbon](double width_m) { ribbon.width_m = width_m; });
  return width_profile(value).map([&ribbon](WidthProfile&& profile) {
    ribbon.width_m = profile.points.front().width_m;
    const auto differs = [&](const WidthAt& point) { return point.width_m != ribbon.width_m; };
    if (std::ranges::any_of(profile.points, differs)) ribbon.profile = std::move(profile);
  });
}

// ---- The table of keys. docs/scene.md tells users about each; a test compares the two.

enum class Need { optional, required };

struct Key {
  std::string_view name;
  Need need;
  std::string_view example;
  Reader read;
};

struct Table {
  std::string_view name;  // empty: the keys above all tables
  Need need;
  std::vector<Key> keys;
};

using enum Need;

// Reads the entries of one table.
Result<void> read_entries(const Document& document, const Table& table, const TomlValue& found,
                          Scene& scene);

// Tables that there may be several of: `add` makes room for what is read from the next.
template <class Add>
Reader each_of(const Table& table, Add add) {
  return [&table, add](const Value& value, Scene& scene) -> Result<void> {
    const std::string title = "[" + std::string(table.name) + "]";
    const auto* all = value.toml.as<TomlArray>();
    Result<void> read;
    for (const TomlValue& one : all != nullptr ? *all : TomlArray{value.toml}) {
      if (all == nullptr || one.as<TomlTable>() == nullptr)
        return failure(value.document.place(one.begin),
                       in_quotes(value.key) + " must be tables, not " + written(one),
                       "write '" + title + "' and its keys on the lines below, as often as needed");
      add(scene);
      if (read) read = read_entries(value.document, table, one, scene);
    }
    return read;
  };
}

std::vector<Key> curve_keys() {
  return {
      {"svg", optional, "\"overhand.svg\"", set(in_drawn_svg(&DrawnSvg::file), file_name)},
      {"path", optional, "\"band\"", set(in_drawn_svg(&DrawnSvg::path_id), text)},
      {"points", optional, "[[0, 0], [100, 50]]", set(drawn_points, points)},
      {"unit", optional, "0.001", set(in(&Scene::curve, &CurveScene::unit_m), number(positive))},
      {"origin", optional, "[0, 0]", set(in(&Scene::curve, &CurveScene::origin), coordinates<2>)},
      {"axis", optional, "\"y\"",
       set(in(&Scene::curve, &CurveScene::axis),
           one_of<Axis>({{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}}))},
      {"first", optional, "\"over\"",
       set(in(&Scene::curve, &CurveScene::first_passage_over),
           one_of<bool>({{"over", true}, {"under", false}}))},
      {"crossings", optional, "\"OUO UOU\"",
       set(in(&Scene::curve, &CurveScene::crossings), crossing_list)},
      {"clearance", optional, "0.005",
       set(in(&Scene::curve, &CurveScene::clearance_m), number(positive))},
  };
}

std::vector<Key> knot_keys() {
  return {
      {"expect", required, "\"reef knot\"", set(in(&Scene::knot, &KnotScene::expect), named_knot)},
      {"between", optional, "[\"tip-left\", \"tip-right\"]",
       set(in(&Scene::knot, &KnotScene::between), two_places)},
      {"expect_between", optional, "\"reef knot\"",
       set(in(&Scene::knot, &KnotScene::expect_between), named_knot)},
  };
}

std::vector<Key> ribbon_keys() {
  return {
      {"width", required, "0.05", read_width},
      {"along", required, "400", set(in(&Scene::ribbon, &RibbonScene::along), particle_count)},
      {"across", required, "8", set(in(&Scene::ribbon, &RibbonScene::across), particle_count)},
      {"mass", optional, "1", set(in(&Scene::ribbon, &RibbonScene::mass_kg), number(positive))},
      {"thickness", optional, "0.001",
       set(in(&Scene::ribbon, &RibbonScene::thickness_m), number(not_negative))},
  };
}

std::vector<Key> spring_keys() {
  return {
      {"stretch", optional, "1000",
       set(in(&Scene::springs, &SpringScene::stretch), number(not_negative))},
      {"shear", optional, "500",
       set(in(&Scene::springs, &SpringScene::shear), number(not_negative))},
      {"bend", optional, "10", set(in(&Scene::springs, &SpringScene::bend), number(not_negative))},
      {"damping", optional, "0.5",
       set(in(&Scene::springs, &SpringScene::damping), number(not_negative))},
  };
}

std::vector<Key> obstacle_keys() {
  return {
      {"mesh", required, "\"hourglass.obj\"",
       set(in(&Scene::obstacle, &ObstacleScene::file), file_name)},
      {"scale", optional, "1", set(in(&Scene::obstacle, &ObstacleScene::scale), number(positive))},
      {"position", optional, "[0, 0, 0]",
       set(in(&Scene::obstacle, &ObstacleScene::position_m), coordinates<3>)},
  };
}

std::vector<Key> fastening_keys() {
  return {
      {"speed", required, "0.5",
       set(in(&Scene::fastening, &FasteningScene::speed_m_s), number(positive))},
      {"pull", optional, "\"distributed\"",
       set(in(&Scene::fastening, &FasteningScene::pull),
           one_of<FasteningPull>(
               {{"distributed", FasteningPull::distributed}, {"ends", FasteningPull::ends}}))},
      {"max_speed", optional, "1",
       set(in(&Scene::fastening, &FasteningScene::max_speed_m_s), number(positive))},
      {"yield", optional, "0.05",
       set(in(&Scene::fastening, &FasteningScene::yield_strain), number(yield_strain))},
      {"axis_point", optional, "[0, 0, 0]",
       set(in(&Scene::fastening, &FasteningScene::axis_point_m), coordinates<3>)},
      {"axis", optional, "[0, 1, 0]",
       set(in(&Scene::fastening, &FasteningScene::axis_direction), direction)},
  };
}

std::vector<Key> time_keys() {
  return {
      {"step", optional, "0.01", set(in(&Scene::time, &TimeScene::step_s), number(positive))},
      {"duration", required, "4", set(in(&Scene::time, &TimeScene::duration_s), number(positive))},
      {"until", optional, "\"tight\"",
       set(in(&Scene::time, &TimeScene::until),
           one_of<RunsUntil>({{"duration", RunsUntil::duration}, {"tight", RunsUntil::tight}}))},
      {"integrator", optional, "\"rk4\"",
       set(in(&Scene::time, &TimeScene::integrator),
           one_of<IntegrationMethod>({{"rk4", IntegrationMethod::rk4},
                                      {"symplectic_euler", IntegrationMethod::symplectic_euler},
                                      {"implicit", IntegrationMethod::implicit}}))},
  };
}

std::vector<Key> recording_keys() {
  return {
      {"frames_per_second", optional, "50",
       set(in(&Scene::recording, &RecordingScene::frames_per_second), number(positive))},
      {"max_position_error", optional, "1e-5",
       set(in(&Scene::recording, &RecordingScene::max_position_error), position_error)},
      {"checkpoint_every", optional, "10",
       set(in(&Scene::recording, &RecordingScene::checkpoint_every_s), number(not_negative))},
  };
}

std::vector<Key> hand_keys() {
  return {
      {"at", required, "[0, 0.02]", set(in_hand(&HandScene::at), part_of_band)},
      {"pull", optional, "[1, 0, 0]", read_pull},
      {"hold", optional, "true", read_hold},
      {"speed", optional, "0.3", set(in_hand(&HandScene::speed_m_s), number(positive))},
      {"yield", optional, "0.05", set(in_hand(&HandScene::yield_strain), number(yield_strain))},
  };
}

const Table& hand_table() {
  static const Table table{"[stage.hand]", required, hand_keys()};
  return table;
}

std::vector<Key> stage_keys() {
  return {
      {"name", optional, "\"half knot\"", set(in_stage(&StageScene::name), text)},
      {"until", optional, "\"tight\"", set(in_stage(&StageScene::until_s), seconds_or_tight)},
      {"at_most", optional, "12", set(in_stage(&StageScene::at_most_s), number(positive))},
      {"friction", optional, "0.3", set(in_stage(&StageScene::friction), number(not_negative))},
      {"hand", optional, "",
       each_of(hand_table(), [](Scene& scene) { scene.stages.back().hands.emplace_back(); })},
  };
}

const Table& stage_table() {
  static const Table table{"[stage]", required, stage_keys()};
  return table;
}

const std::vector<Table>& tables() {
  static const std::vector<Table> all = {
      {"",
       required,
       {{"name", optional, "\"overhand-hourglass\"", set(&Scene::name, text)},
        {"contact", optional, "\"gate\"",
         set(&Scene::contact, one_of<ContactMethod>({{"gate", ContactMethod::gate},
                                                     {"paper", ContactMethod::paper}}))},
        {"accuracy", optional, "\"balanced\"", set_level()},
        {"stage", optional, "",
         each_of(stage_table(), [](Scene& scene) { scene.stages.emplace_back(); })}}},
      {"curve", required, curve_keys()},
      {"knot", optional, knot_keys()},
      {"ribbon", required, ribbon_keys()},
      {"springs", optional, spring_keys()},
      {"air",
       optional,
       {{"resistance", optional, "10", set(&Scene::air_resistance_per_s, number(not_negative))}}},
      {"gravity",
       optional,
       {{"acceleration", required, "[0, -9.81, 0]", set(&Scene::gravity_m_s2, gravity)}}},
      {"friction",
       optional,
       {{"coefficient", required, "0.3", set(&Scene::friction, number(not_negative))}}},
      {"obstacle", optional, obstacle_keys()},
      {"fastening", optional, fastening_keys()},
      {"time", required, time_keys()},
      {"recording", optional, recording_keys()},
  };
  return all;
}

// ---- Walking the file along the table

std::string title(const Table& table) {
  return table.name.empty() ? "the lines above all tables" : "[" + std::string(table.name) + "]";
}

std::vector<std::string_view> known_names(const Table& table) {
  std::vector<std::string_view> names;
  for (const Key& key : table.keys) names.push_back(key.name);
  if (table.name.empty())
    for (const Table& other : tables())
      if (!other.name.empty()) names.push_back(other.name);
  return names;
}

bool knows(const Table& table, std::string_view name) {
  const std::vector<std::string_view> names = known_names(table);
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Where a key may belong; in a stage first of all there.
std::vector<const Table*> tables_near(const Table& table) {
  std::vector<const Table*> all;
  for (const Table& other : tables()) all.push_back(&other);
  const bool is_of_stages = table.name.starts_with('[');
  for (const Table* other : {&hand_table(), &stage_table()})
    all.insert(is_of_stages ? all.begin() : all.end(), other);
  return all;
}

// What whoever wrote the unknown `name` into `table` may have wanted.
std::string remedy_for_unknown(const Table& table, std::string_view name) {
  for (const Table* other : tables_near(table))
    if (knows(*other, name)) return "it belongs in " + title(*other);
  const std::vector<std::string_view> names = known_names(table);
  if (const auto meant = nearest_word(name, names))
    return "did you mean " + in_quotes(*meant) + "?";
  std::string list;
  for (const std::string_view known : names) list += (list.empty() ? "" : ", ") + in_quotes(known);
  return "it may hold " + list;
}

Result<void> refuse_unknown(const Document& document, const Table& table,
                            const TomlTable& entries) {
  for (const auto& [key, key_begin, value] : entries.entries)
    if (!knows(table, key))
      return failure(document.place(key_begin),
                     "unknown " +
                         std::string(value.as<TomlTable>() != nullptr ? "table " : "key ") +
                         in_quotes(key) + " in " + title(table),
                     remedy_for_unknown(table, key));
  return {};
}

std::string assignment_example(const Key& key) {
  return "'" + std::string(key.name) + " = " + std::string(key.example) + "'";
}

Result<void> read_key(const Document& document, const Table& table, const TomlValue& found,
                      const Key& key, Scene& scene) {
  if (const TomlValue* value = found.as<TomlTable>()->find(key.name))
    return key.read({key.name, key.example, *value, document}, scene);
  if (key.need == optional) return {};
  return failure(document.place(found.begin),
                 in_quotes(key.name) + " is missing in " + title(table),
                 "add for example " + assignment_example(key));
}

Result<void> missing_table(const Document& document, const Table& table) {
  if (const TomlValue* other = document.find("", table.name))
    return failure(document.place(other->begin),
                   in_quotes(table.name) + " must be a table, not " + written(*other),
                   "write '[" + std::string(table.name) + "]' and its keys on the lines below");
  if (table.need == optional) return {};
  std::string keys;
  for (const Key& key : table.keys)
    if (key.need == required) keys += " " + assignment_example(key);
  return failure(document.file.string(), title(table) + " is missing",
                 "add '" + title(table) + "'" +
                     (keys.empty() ? "" : " with for example" + keys + " on the lines below"));
}

Result<void> read_table(const Document& document, const Table& table, Scene& scene) {
  const TomlValue* found = document.find(table.name);
  if (found == nullptr) return missing_table(document, table);
  return read_entries(document, table, *found, scene);
}

Result<void> read_entries(const Document& document, const Table& table, const TomlValue& found,
                          Scene& scene) {
  Result<void> read = refuse_unknown(document, table, *found.as<TomlTable>());
  for (const Key& key : table.keys)
    if (read) read = read_key(document, table, found, key, scene);
  return read;
}

// ---- Rules that join two keys

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
                 "add for example 'between = [\"tip-left\", \"tip-right\"]'");
}

Result<void> countable_particles(const Document& document, const Scene& scene) {
  if (scene.ribbon.across > most_columns)
    return failure(document.place("ribbon", "across"), "'across' is more than a recording holds",
                   "write at most " + std::to_string(most_columns));
  const std::int64_t particles = std::int64_t{scene.ribbon.along} * scene.ribbon.across;
  if (particles <= most_particles) return {};
  return failure(
      document.place("ribbon", "along"),
      "'along' times 'across' is " + std::to_string(particles) + " particles",
      "write smaller numbers, at most " + std::to_string(most_particles) + " particles together");
}

// Thicker, each layer would meet all others, and lists of what touches would fill the memory.
Result<void> cloth_is_flat(const Document& document, const Scene& scene) {
  if (scene.ribbon.thickness_m <= scene.ribbon.width_m) return {};
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
    return failure(document.place("time", "duration"),
                   "'duration' is " + shortest(std::round(steps)) + " steps of " +
                       shortest(scene.time.step_s) + " s",
                   "write a shorter duration or a longer step, at most 1e9 steps");
  return {};
}

// Frames are taken at steps, so there cannot be more frames than steps.
Result<void> at_most_a_frame_a_step(const Document& document, const Scene& scene) {
  const double most = 1 / scene.time.step_s;
  if (scene.recording.frames_per_second <= most * (1 + 1e-9)) return {};
  return failure(document.place("recording", "frames_per_second"),
                 "'frames_per_second' is " + shortest(scene.recording.frames_per_second) +
                     ", but with a step of " + shortest(scene.time.step_s) + " s there are only " +
                     shortest(most) + " steps per second",
                 "write 'frames_per_second = " + shortest(most) + "' or less, or a shorter step");
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

void set_mean_width(RibbonScene& ribbon) {
  if (!ribbon.profile) return;
  const std::vector<double> rows_m = row_widths_m(ribbon);
  ribbon.width_m = std::accumulate(rows_m.begin(), rows_m.end(), 0.0) / ribbon.along;
}

void set_defaults(const Document& document, Scene& scene) {
  if (scene.name.empty()) scene.name = document.file.stem().string();
  set_mean_width(scene.ribbon);
  if (scene.curve.clearance_m == 0)
    scene.curve.clearance_m = default_clearance_of_width * scene.ribbon.width_m;
  if (document.find("recording", "frames_per_second") == nullptr)
    scene.recording.frames_per_second = std::min(default_frames_per_second, 1 / scene.time.step_s);
  if (document.find("recording", "checkpoint_every") == nullptr)
    scene.recording.checkpoint_every_s =
        default_frames_per_checkpoint / scene.recording.frames_per_second;
}

// Hands pull and yield as [fastening] says, unless they say otherwise.
void set_defaults_of_stages(Scene& scene) {
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    StageScene& stage = scene.stages[i];
    if (stage.name.empty()) stage.name = "stage " + std::to_string(i + 1);
    for (HandScene& hand : stage.hands) {
      if (!scene.fastening) continue;
      if (hand.speed_m_s == 0) hand.speed_m_s = scene.fastening->speed_m_s;
      if (!hand.yield_strain && hand.task != HandTask::hold)
        hand.yield_strain = scene.fastening->yield_strain;
    }
  }
}

Result<Scene> scene_of(const Document& document) {
  Scene scene;
  for (const Table& table : tables())
    if (auto read = read_table(document, table, scene); !read) return tl::unexpected(read.error());
  set_defaults(document, scene);
  set_defaults_of_stages(scene);
  for (const auto& rule :
       {one_drawing, one_way_to_pass_over, expected_between_places, countable_particles,
        cloth_is_flat, countable_steps, at_most_a_frame_a_step, fastening_against_air,
        tight_by_fastening, check_stages})
    if (auto kept = rule(document, scene); !kept) return tl::unexpected(kept.error());
  return scene;
}

}  // namespace

Result<Scene> read_scene(const std::filesystem::path& file,
                         const std::vector<std::string>& settings) {
  return read_file(file).and_then(
      [&](std::string text) { return read_scene(file, std::move(text), settings); });
}

Result<Scene> read_scene(const std::filesystem::path& file, std::string text,
                         const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    auto changed = with_setting(file, text, setting);
    if (!changed) return tl::unexpected(changed.error());
    text = *std::move(changed);
  }
  return parse_document(file, text).and_then(scene_of).map([&](Scene scene) {
    scene.file = file;
    scene.text = std::move(text);
    return scene;
  });
}

}  // namespace ribbon

// Reads a scene by a table of its keys: what each is called, of which kind it is and where it goes.
#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

#include "files/files.h"
#include "scene/accuracy.h"
#include "scene/document.h"
#include "scene/fabric.h"
#include "scene/line_origins.h"
#include "scene/nearest_word.h"
#include "scene/scene.h"
#include "scene/scene_rules.h"
#include "scene/scene_values.h"
#include "scene/setting.h"
#include "text/characters.h"

namespace ribbon {

namespace {

using namespace scene_values;

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

template <class Member>
auto in_outline(Member OutlineScene::*member) {
  return [=](Scene& scene) -> Member& {
    std::optional<OutlineScene>& outline = scene.ribbon.outline;
    return (outline ? *outline : outline.emplace()).*member;
  };
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

Result<void> read_carry(const Value& value, Scene& scene) {
  HandScene& hand = scene.stages.back().hands.back();
  hand.task = HandTask::carry;
  return carry_path(value).map([&](const auto& path) { hand.carry.path = path; });
}

Result<void> read_until(const Value& value, Scene& scene) {
  StageScene& stage = scene.stages.back();
  return seconds_or_goal(value).map([&](const std::variant<double, StageGoal>& until) {
    if (const auto* seconds = std::get_if<double>(&until))
      stage.until_s = *seconds;
    else
      stage.goal = std::get<StageGoal>(until);
  });
}

Result<void> read_gravity_of_stage(const Value& value, Scene& scene) {
  return gravity(value).map([&](const std::optional<Eigen::Vector3d>& acceleration) {
    scene.stages.back().gravity_m_s2 = acceleration.value_or(Eigen::Vector3d::Zero());
  });
}

// What the fabric tells is set when the scene's own keys are known (set_defaults()).
Result<void> read_fabric(const Value& value, Scene& scene) {
  std::vector<std::pair<std::string_view, Fabric>> words;
  words.reserve(fabrics.size());
  for (const Fabric& fabric : fabrics) words.emplace_back(fabric.name, fabric);
  return one_of(std::move(words))(value).map([&](const Fabric& fabric) {
    scene.cloth = {.fabric = fabric, .place = value.document.place(value.toml.begin)};
  });
}

// One number, or a profile; one that is as wide everywhere is one number.
Result<void> read_width(const Value& value, Scene& scene) {
  RibbonScene& ribbon = scene.ribbon;
  if (value.toml.as<TomlArray>() == nullptr)
    return number(positive)(value).map([&ribbon](double width_m) { ribbon.width_m = width_m; });
  return width_profile(value).map([&ribbon](WidthProfile&& profile) {
    ribbon.width_m = profile.points.front().width_m;
    const auto differs = [&](const WidthAt& point) { return point.width_m != ribbon.width_m; };
    if (std::any_of(profile.points.begin(), profile.points.end(), differs))
      ribbon.profile = std::move(profile);
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
      {"between", optional, R"(["tip-left", "tip-right"])",
       set(in(&Scene::knot, &KnotScene::between), two_places)},
      {"expect_between", optional, "\"reef knot\"",
       set(in(&Scene::knot, &KnotScene::expect_between), named_knot)},
  };
}

std::vector<Key> ribbon_keys() {
  return {
      {"width", optional, "0.05", read_width},
      {"outline", optional, "\"tie.svg\"", set(in_outline(&OutlineScene::file), file_name)},
      {"outline_path", optional, "\"tie\"", set(in_outline(&OutlineScene::path_id), text)},
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
       set(in(&Scene::fastening, &FasteningScene::yield_strain), yield_strain)},
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
           one_of<IntegrationMethod>({integration_methods.begin(), integration_methods.end()}))},
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
      {"carry", optional, "\"over-the-front\"", read_carry},
      {"height", optional, "0.1",
       set(
           [](Scene & scene) -> auto& { return scene.stages.back().hands.back().carry.heights; },
           heights)},
      {"speed", optional, "0.3", set(in_hand(&HandScene::speed_m_s), number(positive))},
      {"yield", optional, "0.05", set(in_hand(&HandScene::yield_strain), yield_strain)},
  };
}

const Table& hand_table() {
  static const Table table{"[stage.hand]", required, hand_keys()};
  return table;
}

std::vector<Key> stage_keys() {
  return {
      {"name", optional, "\"half knot\"", set(in_stage(&StageScene::name), text)},
      {"until", optional, "\"tight\"", read_until},
      {"at_most", optional, "12", set(in_stage(&StageScene::at_most_s), number(positive))},
      {"friction", optional, "0.3", set(in_stage(&StageScene::friction), number(not_negative))},
      {"gravity", optional, "[0, -9.81, 0]", read_gravity_of_stage},
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
      {"cloth", optional, {{"fabric", required, "\"silk\"", read_fabric}}},
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

Result<Scene> scene_of(const Document& document) {
  Scene scene;
  for (const Table& table : tables())
    if (auto read = read_table(document, table, scene); !read) return tl::unexpected(read.error());
  set_defaults(document, scene);
  if (auto kept = check_rules(document, scene); !kept) return tl::unexpected(kept.error());
  return scene;
}

// Where a text can be read without one of its settings, but not with it, nor with those that come
// after, that one is told.
Result<Scene> blamed(Result<Scene> refused, const std::filesystem::path& file,
                     const std::string& text, std::vector<std::string> settings) {
  while (!refused && !settings.empty()) {
    const std::string last = settings.back();
    settings.pop_back();
    if (auto without = read_scene(file, text, settings); !without) {
      refused = std::move(without);
      continue;
    }
    if (!refused.error().place.empty())
      refused.error().place = file.string() + " with " + in_quotes(last);
    break;
  }
  return refused;
}

}  // namespace

std::vector<std::filesystem::path> files_of(const Scene& scene) {
  std::vector<std::filesystem::path> files{scene.file};
  if (const auto* svg = std::get_if<DrawnSvg>(&scene.curve.drawing))
    files.push_back(svg->file.path);
  if (scene.ribbon.outline) files.push_back(scene.ribbon.outline->file.path);
  if (scene.obstacle) files.push_back(scene.obstacle->file.path);
  return files;
}

Result<Scene> read_scene(const std::filesystem::path& file,
                         const std::vector<std::string>& settings) {
  return read_file(file, most_bytes_by_hand).and_then([&](const std::string& text) {
    return blamed(read_scene(file, text, settings), file, text, settings);
  });
}

Result<Scene> read_scene(const std::filesystem::path& file, std::string text,
                         const std::vector<std::string>& settings, const std::string& name) {
  std::vector<LineOrigin> origins = origins_in_file(text);
  for (int n = 0; n < std::ssize(settings); ++n) {
    auto changed = with_setting(file, text, settings[n]);
    if (!changed) return tl::unexpected(changed.error());
    trace_setting(n, text, *changed, origins);
    text = *std::move(changed);
  }
  auto document = parse_document(file, text);
  if (!document) return tl::unexpected(document.error());
  document->origins = std::move(origins);
  document->settings = settings;
  return scene_of(*document).map([&](Scene scene) {
    if (scene.name.empty()) scene.name = as_utf8(name.empty() ? file.stem().string() : name);
    scene.file = file;
    scene.text = std::move(text);
    return scene;
  });
}

}  // namespace ribbon

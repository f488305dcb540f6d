#include "player/view/camera_path.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "files/files.h"
#include "text/number_in.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

struct Column {
  std::string_view name;
  double least;
  double most;
};

// In the order of CameraPath::Values: the settings of a view, then the point that is looked at.
constexpr std::array<Column, 7> make_columns() {
  std::array<Column, 7> columns{};
  for (std::size_t i = 0; i < view_settings.size(); ++i)
    columns[i] = {view_settings[i].name, view_settings[i].least, view_settings[i].most};
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  for (std::size_t i = 0; i < axes.size(); ++i)
    columns[view_settings.size() + i] = {axes[i], -1e4, 1e4};
  return columns;
}
constexpr std::array<Column, 7> columns = make_columns();
constexpr int time_column = -1;

// What stands between the fields of a table, as its first line tells. Where numbers have a decimal
// comma, spreadsheets put semicolons or tabs there.
char separator_of(std::string_view heading) {
  const std::size_t found = heading.find_first_of(";\t");
  return found == std::string_view::npos ? ',' : heading[found];
}

std::string_view without_spaces(std::string_view field) {
  const std::size_t first = field.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return field.substr(first, field.find_last_not_of(" \t\r") + 1 - first);
}

std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t end = line.find(separator);
    std::string_view field = without_spaces(line.substr(0, end));
    if (field.size() > 1 && field.front() == '"' && field.back() == '"')
      field = without_spaces(field.substr(1, field.size() - 2));
    fields.emplace_back(field);
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

// Which value each field is, or time_column.
Result<std::vector<int>> read_heading(const std::vector<std::string>& fields,
                                      const std::string& place) {
  std::vector<int> order;
  for (const std::string& field : fields) {
    const auto* found = std::find_if(columns.begin(), columns.end(),
                                     [&](const Column& column) { return column.name == field; });
    if (found == columns.end() && field != "time")
      return failure(place, filled_in("there is no column '{}'", field),
                     "name columns as in time,azimuth,elevation,distance,lens,x,y,z");
    const int column = field == "time" ? time_column : static_cast<int>(found - columns.begin());
    if (std::find(order.begin(), order.end(), column) != order.end())
      return failure(place, filled_in("column '{}' stands there twice", field), "keep one");
    order.push_back(column);
  }
  const auto has = [&](int column) {
    return std::find(order.begin(), order.end(), column) != order.end();
  };
  if (!has(time_column)) return failure(place, "there is no column 'time'", "add it, in seconds");
  if (has(4) != has(5) || has(5) != has(6))
    return failure(place, "the point looked at needs x, y and z", "add what is missing");
  return order;
}

Result<double> read_field(std::string_view field, double least, double most,
                          const std::string& place) {
  const auto number = number_in<double>(field);
  if (!number || !(*number >= least && *number <= most))
    return failure(place,
                   filled_in("'{}' is not a number from {:.4g} to {:.4g}", field, least, most),
                   "correct it");
  return *number;
}

}  // namespace

Result<CameraPath> CameraPath::parse(const std::string& text, const std::string& name,
                                     const View& start) {
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  if (without_spaces(line).empty())
    return failure(
        name + ":1", "does not name the columns of keyframes",
        "begin with a line as time,azimuth,elevation,distance,lens,x,y,z, and write a line "
        "of numbers for each keyframe below it");
  const char separator = separator_of(line);
  const auto order = read_heading(fields_of(line, separator), name + ":1");
  if (!order) return tl::unexpected(order.error());
  CameraPath path(start, std::find(order->begin(), order->end(), 4) != order->end());
  for (int number = 2; std::getline(stream, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string place = filled_in("{}:{}", name, number);
    if (separator != ',') std::replace(line.begin(), line.end(), ',', '.');
    const auto fields = fields_of(line, separator);
    if (fields.size() != order->size())
      return failure(place,
                     filled_in("has {} fields, the first line {}", fields.size(), order->size()),
                     "write one for each column");
    Values values;
    values.setZero();
    for (std::size_t i = 0; i < view_settings.size(); ++i)
      values[static_cast<Eigen::Index>(i)] = start.*view_settings[i].value;
    double time_s = 0;
    for (std::size_t f = 0; f < fields.size(); ++f) {
      const int column = (*order)[f];
      const auto read = column == time_column ? read_field(fields[f], -1e6, 1e6, place)
                                              : read_field(fields[f], columns[column].least,
                                                           columns[column].most, place);
      if (!read) return tl::unexpected(read.error());
      (column == time_column ? time_s : values[column]) = *read;
    }
    if (!path.times_s_.empty() && time_s <= path.times_s_.back())
      return failure(place, "is not later than the line before", "sort the lines by time");
    path.times_s_.push_back(time_s);
    path.values_.push_back(values);
  }
  if (path.times_s_.empty())
    return failure(name, "holds no keyframe", "write one line of numbers at least");
  return path;
}

Result<CameraPath> CameraPath::read(const std::filesystem::path& file, const View& start) {
  return read_file(file).and_then(
      [&](const std::string& text) { return parse(text, file.string(), start); });
}

// Change per second, from the neighbours; at the ends the camera starts and stops smoothly.
CameraPath::Values CameraPath::tangent(std::size_t key) const {
  if (key == 0 || key + 1 == times_s_.size()) return Values::Zero();
  return (values_[key + 1] - values_[key - 1]) / (times_s_[key + 1] - times_s_[key - 1]);
}

CameraPose CameraPath::at(double time_s) const {
  const auto later = std::upper_bound(times_s_.begin(), times_s_.end(), time_s);
  Values values;
  if (later == times_s_.begin()) {
    values = values_.front();
  } else if (later == times_s_.end()) {
    values = values_.back();
  } else {
    const auto next = static_cast<std::size_t>(later - times_s_.begin());
    const double span_s = times_s_[next] - times_s_[next - 1];
    const double t = (time_s - times_s_[next - 1]) / span_s;
    const double u = 1 - t;
    values = (1 + 2 * t) * u * u * values_[next - 1] + t * t * (3 - 2 * t) * values_[next] +
             span_s * t * u * (u * tangent(next - 1) - t * tangent(next));
    values[1] = std::clamp(values[1], -90.0, 90.0);
  }
  CameraPose pose{start_, std::nullopt};
  for (std::size_t i = 0; i < view_settings.size(); ++i)
    pose.view.*view_settings[i].value = static_cast<float>(values[static_cast<Eigen::Index>(i)]);
  pose.view.distance_m = std::max(pose.view.distance_m, 0.0F);  // cubics may shoot beyond
  pose.view.lens_mm = std::max(pose.view.lens_mm, shortest_lens_mm);
  if (has_target_) pose.target = values.tail<3>().cast<float>().matrix();
  return pose;
}

}  // namespace ribbon

#include "player/view/view.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "text/number_in.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr std::array<std::pair<std::string_view, View>, 4> named_views{{
    {"front", front_view},
    {"top", top_view},
    {"three-quarter", three_quarter_view},
    {"knot", knot_view},
}};

tl::unexpected<Error> unknown(const std::string& text) {
  return failure("view '" + text + "'", "is not known",
                 "write front, top, three-quarter, knot, or settings as in "
                 "azimuth=30,elevation=20,distance=2,lens=60,subject=knot");
}

Result<void> set_number(std::string_view name, std::string_view value, View& view) {
  for (const ViewSetting& setting : view_settings) {
    if (setting.name != name) continue;
    const auto number = number_in<float>(value);
    if (!number || !(*number >= setting.least && *number <= setting.most))
      return failure(
          filled_in("{}={}", name, value), "makes no view",
          filled_in("write a number from {:.4g} to {:.4g}", setting.least, setting.most));
    view.*setting.value = *number;
    return {};
  }
  return unknown(std::string(name));
}

Result<void> set_subject(std::string_view value, View& view) {
  if (value != "everything" && value != "knot") return unknown("subject=" + std::string(value));
  view.subject = value == "knot" ? Subject::knot : Subject::everything;
  return {};
}

}  // namespace

Result<View> parse_view(const std::string& text) {
  for (const auto& [name, view] : named_views)
    if (name == text) return view;
  View view = three_quarter_view;
  std::string_view rest = text;
  std::vector<std::string_view> names;
  do {
    const std::size_t comma = rest.find(',');
    const std::string_view setting = rest.substr(0, comma);
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos) return unknown(text);
    const std::string_view name = setting.substr(0, equals);
    const std::string_view value = setting.substr(equals + 1);
    if (std::find(names.begin(), names.end(), name) != names.end())
      return failure("view '" + text + "'", filled_in("sets {} twice", name), "write it once");
    names.push_back(name);
    const auto set = name == "subject" ? set_subject(value, view) : set_number(name, value, view);
    if (!set) return tl::unexpected(set.error());
  } while (!rest.empty());
  return view;
}

Result<std::vector<NamedView>> parse_views(const std::vector<std::string>& texts) {
  std::vector<NamedView> views;
  int nameless = 0;
  for (const std::string& text : texts) {
    const auto view = parse_view(text);
    if (!view) return tl::unexpected(view.error());
    const bool is_named = text.find('=') == std::string::npos;
    const std::string name = is_named ? text : filled_in("camera{}", ++nameless);
    for (const NamedView& other : views)
      if (other.view == *view)
        return failure("view '" + text + "'", "is asked for twice", "leave one out");
    views.push_back({name, *view});
  }
  return views;
}

}  // namespace ribbon

#include "curve/drawing.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "curve/path_data.h"
#include "curve/style_sheet.h"
#include "files/files.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

constexpr double largest_coordinate = 1e9;  // far from where squares lose their last digits

// A parsed file that can say on which line something stands.
struct SvgFile {
  std::string name;
  std::string bytes;
  pugi::xml_document document;
  StyleSheet rules{{"display", "visibility", "stroke-dasharray", "transform"}};

  [[nodiscard]] std::string place(std::ptrdiff_t offset) const {
    if (offset < 0 || static_cast<std::size_t>(offset) > bytes.size()) return name;
    const auto newlines = std::count(bytes.begin(), bytes.begin() + offset, '\n');
    return name + ":" + std::to_string(newlines + 1);
  }
  [[nodiscard]] std::string place(const pugi::xml_node& node) const {
    return place(node.offset_debug());
  }
};

// "path" for <path> and, where the root is <svg:svg>, for <svg:path>; foreign elements such as
// <sodipodi:namedview> keep their prefix.
std::string_view svg_name(const pugi::xml_node& node) {
  const std::string_view root = node.root().first_child().name();
  const std::size_t colon = root.find(':');
  std::string_view name = node.name();
  if (colon != std::string_view::npos && name.substr(0, colon + 1) == root.substr(0, colon + 1))
    name.remove_prefix(colon + 1);
  return name;
}

bool is_container(std::string_view name) {
  return name == "g" || name == "a" || name == "switch";
}

bool is_path(std::string_view name) {
  return name == "path" || name == "polyline" || name == "line";
}

bool is_circle(std::string_view name) {
  return name == "circle" || name == "ellipse";
}

StyledElement element_of(const pugi::xml_node& node) {
  const auto parent = [node]() -> std::optional<StyledElement> {
    if (node.parent().type() != pugi::node_element) return std::nullopt;
    return element_of(node.parent());
  };
  return {svg_name(node), node.attribute("id").value(), node.attribute("class").value(),
          node.attribute("style").value(), parent};
}

std::optional<std::string> styled(const SvgFile& file, const pugi::xml_node& node,
                                  const char* property) {
  return file.rules.value_of(property, element_of(node));
}

// As the element itself has it; empty: it says nothing of it.
std::string property_of(const SvgFile& file, const pugi::xml_node& node, const char* property) {
  return styled(file, node, property).value_or(node.attribute(property).value());
}

// What the viewer sees of some shapes, in document order.
std::vector<pugi::xml_node> visible(bool (&is_wanted)(std::string_view), const SvgFile& file) {
  struct Found {
    pugi::xml_node node;
    bool is_visible;  // what a part of a group that is not says of itself holds
  };
  const pugi::xml_node root = file.document.document_element();
  std::vector<pugi::xml_node> shapes;
  std::vector<Found> stack{{root, true}};
  while (!stack.empty()) {
    auto [node, is_visible] = stack.back();
    stack.pop_back();
    if (property_of(file, node, "display") == "none") continue;
    const std::string visibility = property_of(file, node, "visibility");
    if (visibility == "hidden" || visibility == "collapse") is_visible = false;
    if (visibility == "visible") is_visible = true;
    if (is_visible && is_wanted(svg_name(node))) shapes.push_back(node);
    if (node != root && !is_container(svg_name(node))) continue;
    for (pugi::xml_node child = node.last_child(); child; child = child.previous_sibling())
      stack.push_back({child, is_visible});
  }
  return shapes;
}

std::string id_of(const pugi::xml_node& node) {
  return node.attribute("id").value();
}

std::string list_ids(const std::vector<pugi::xml_node>& paths) {
  constexpr std::size_t most = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(paths.size(), most); ++i) {
    const std::string id = id_of(paths[i]);
    list += (i == 0 ? "" : ", ") + (id.empty() ? "one without id" : "'" + id + "'");
  }
  if (paths.size() > most) list += " and " + std::to_string(paths.size() - most) + " more";
  return list;
}

// How to say in the scene which of several paths is meant.
std::string choice_among(const std::vector<pugi::xml_node>& paths, const PathKey& key) {
  const auto named = std::find_if(paths.begin(), paths.end(),
                                  [](const pugi::xml_node& path) { return !id_of(path).empty(); });
  if (named == paths.end())
    return "give one an id, for example \"band\", and write '" + key.key +
           " = \"band\"' in the scene's " + key.table + ", or delete the others";
  return "write for example '" + key.key + " = \"" + id_of(*named) + "\"' in the scene's " +
         key.table + ", or delete the others";
}

std::vector<pugi::xml_node> style_sheets(const SvgFile& file) {
  std::vector<pugi::xml_node> sheets;
  file.document.find_node([&](const pugi::xml_node& node) {
    const bool is_for_print = node.attribute("media").value() == std::string_view("print");
    if (svg_name(node) == "style" && !is_for_print) sheets.push_back(node);
    return false;  // and so on
  });
  return sheets;
}

Result<void> read_rules(SvgFile& file) {
  for (const pugi::xml_node& sheet : style_sheets(file)) {
    std::string css;
    for (const pugi::xml_node& text : sheet) css += text.value();
    if (const auto selector = file.rules.add(css))
      return failure(file.place(sheet),
                     "whom the style rule '" + *selector + "' means is not followed",
                     "save the drawing with its styles as attributes (presentation attributes), or "
                     "give those that it means a class");
  }
  return {};
}

Result<SvgFile> load(const std::filesystem::path& path) {
  auto bytes = read_file(path, most_bytes_by_hand);
  if (!bytes) return tl::unexpected(bytes.error());
  SvgFile file{path.string(), std::move(*bytes), {}};
  const auto parsed = file.document.load_buffer(file.bytes.data(), file.bytes.size());
  if (!parsed)
    return failure(file.place(parsed.offset),
                   std::string("is not XML (") + parsed.description() + ")",
                   "save the drawing as plain, uncompressed SVG");
  if (svg_name(file.document.document_element()) != "svg")
    return failure(file.place(file.document.document_element()),
                   std::string("is not SVG but <") + file.document.document_element().name() + ">",
                   "save the drawing as plain SVG");
  if (auto rules = read_rules(file); !rules) return tl::unexpected(rules.error());
  return file;
}

Result<std::vector<pugi::xml_node>> only_path(const SvgFile& file,
                                              const std::vector<pugi::xml_node>& paths,
                                              const PathKey& key) {
  if (paths.empty())
    return failure(file.name, "has no path that can be seen",
                   "draw one; what is hidden, in <defs> or in a symbol does not count, "
                   "and shapes become paths by Path > Object to Path in Inkscape");
  if (paths.size() > 1)
    return failure(file.place(paths[1]),
                   "has " + std::to_string(paths.size()) + " paths: " + list_ids(paths),
                   choice_among(paths, key));
  return paths;
}

bool is_in_group(pugi::xml_node node, const std::string& id) {
  while (node && id_of(node) != id) node = node.parent();
  return !node.empty();
}

// The path of that id, or those of the group of that id.
Result<std::vector<pugi::xml_node>> paths_by_id(const SvgFile& file,
                                                const std::vector<pugi::xml_node>& paths,
                                                const std::string& id, const PathKey& key) {
  std::vector<pugi::xml_node> chosen;
  std::copy_if(paths.begin(), paths.end(), std::back_inserter(chosen),
               [&](const pugi::xml_node& path) { return is_in_group(path, id); });
  if (!chosen.empty()) return chosen;
  const pugi::xml_node other = file.document.find_node(
      [&](const pugi::xml_node& node) { return id == node.attribute("id").value(); });
  if (other)
    return failure(file.place(other),
                   "'" + id + "' is a <" + other.name() + "> that is hidden or not a path",
                   "show it, or convert it by Path > Object to Path in Inkscape");
  return failure(file.name, "has no path with the id '" + id + "'",
                 paths.empty() ? "draw one"
                               : "correct '" + key.key + "' in the scene's " + key.table +
                                     ": there are " + list_ids(paths));
}

Depth depth_by_class(pugi::xml_node node) {
  for (; node; node = node.parent()) {
    const std::string_view classes = node.attribute("class").value();
    if (is_word_of(classes, "behind")) return Depth::behind;
    if (is_word_of(classes, "front")) return Depth::front;
  }
  return Depth::untold;
}

// As the nearest says that says anything of dashes.
bool is_dashed(const SvgFile& file, pugi::xml_node node) {
  std::string dashes;
  for (; node && dashes.empty(); node = node.parent())
    dashes = property_of(file, node, "stroke-dasharray");
  return dashes.find_first_of("123456789") != std::string::npos;
}

std::vector<Depth> depths_of(const SvgFile& file, const std::vector<pugi::xml_node>& paths) {
  std::vector<bool> dashed(paths.size());
  std::transform(paths.begin(), paths.end(), dashed.begin(),
                 [&](const pugi::xml_node& path) { return is_dashed(file, path); });
  // Where all strokes are dashed, that is a matter of taste.
  const bool dashes_tell = std::find(dashed.begin(), dashed.end(), false) != dashed.end();
  std::vector<Depth> depths;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    depths.push_back(depth_by_class(paths[i]));
    if (depths.back() == Depth::untold && dashes_tell && dashed[i]) depths.back() = Depth::behind;
  }
  return depths;
}

Result<Eigen::Affine2d> root_from_path(const SvgFile& file, const pugi::xml_node& path) {
  Eigen::Affine2d transform = Eigen::Affine2d::Identity();
  for (pugi::xml_node node = path; node; node = node.parent()) {
    const pugi::xml_attribute attribute = node.attribute("transform");
    // A style's has other words and units, and a middle of its own.
    if (const auto style = styled(file, node, "transform");
        style && (*style != "none" || attribute))
      return failure(file.place(node), "its style has a transform, which is not read",
                     "write it as an attribute: transform=\"...\"");
    if (!attribute) continue;
    const auto own = read_transform(attribute.value());
    if (!own)
      return failure(file.place(node),
                     std::string("the transform '") + attribute.value() + "' cannot be read",
                     "write matrix, translate, rotate, scale, skewX or skewY");
    transform = *own * transform;
  }
  return transform;
}

std::string_view digits_of(std::string_view text) {
  return text.substr(0, std::min(text.find_first_not_of("0123456789"), text.size()));
}

// Of SVG: "-1", ".5", "2.5e3".
bool is_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t whole = digits_of(text).size();
  text.remove_prefix(whole);
  const bool has_point = text.starts_with('.');
  if (has_point) text.remove_prefix(1);
  const std::size_t part = has_point ? digits_of(text).size() : 0;
  text.remove_prefix(part);
  if (has_point ? part == 0 : whole == 0) return false;
  if (text.empty()) return true;
  if (text.front() != 'e' && text.front() != 'E') return false;
  text.remove_prefix(1);
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() && digits_of(text) == text;
}

// As path data take it: a number alone or in pixels, which are its unit. What is none, they refuse.
std::string coordinate(const pugi::xml_node& node, const char* name) {
  std::string_view text = trimmed(node.attribute(name).as_string("0"));
  if (text.ends_with("px")) text.remove_suffix(2);
  return is_number(text) ? std::string(text) + ' ' : "? ";
}

// Polylines and lines say the same as path data, in other words.
std::string path_data(const pugi::xml_node& node) {
  if (svg_name(node) == "path") return node.attribute("d").value();
  std::string data = "M";
  if (svg_name(node) == "polyline") return data + node.attribute("points").value();
  for (const char* name : {"x1", "y1", "x2", "y2"}) data += coordinate(node, name);
  return data;
}

bool is_in_range(const Eigen::Vector2d& point) {
  return point.allFinite() && point.cwiseAbs().maxCoeff() <= largest_coordinate;
}

// In the words of path data, too: where a line of any length begins.
Result<Eigen::Vector2d> middle_of(const SvgFile& file, const pugi::xml_node& circle) {
  const auto transform = root_from_path(file, circle);
  if (!transform) return tl::unexpected(transform.error());
  const auto line = flatten_path_data(
      "M" + coordinate(circle, "cx") + coordinate(circle, "cy") + "h1", *transform, 1);
  if (!line || line->pieces.empty())
    return failure(file.place(circle), "the middle of mark '" + id_of(circle) + "' cannot be read",
                   "write its cx and cy as numbers without a unit, in drawing units");
  const Eigen::Vector2d& middle = line->pieces.front().front();
  if (!is_in_range(middle))
    return failure(file.place(circle), "mark '" + id_of(circle) + "' lies beyond 1e9 drawing units",
                   "correct its place");
  return middle;
}

Result<FlatPath> flat(const SvgPath& path, double tolerance) {
  auto flat = flatten_path_data(path.data, path.root_from_path, tolerance);
  if (!flat)
    return failure(path.place, path.name + " has data that cannot be read",
                   "correct its numbers and commands, or draw it again");
  for (const Drawing& piece : flat->pieces)
    if (!std::all_of(piece.begin(), piece.end(), is_in_range))
      return failure(path.place, path.name + " has coordinates beyond 1e9 drawing units",
                     "draw it smaller or correct its transforms");
  std::erase_if(flat->pieces, [](const Drawing& piece) { return piece.size() < 2; });
  if (flat->pieces.empty())
    return failure(path.place, path.name + " has no length",
                   "draw a curve with at least two points");
  return *std::move(flat);
}

Result<std::vector<Drawing>> open_pieces(const SvgPath& path, FlatPath flat) {
  if (!flat.closed) return std::move(flat.pieces);
  return failure(path.place, path.name + " is closed",
                 "open it: in Inkscape, select two neighbouring nodes with the node tool and "
                 "delete the segment between them");
}

Result<Drawing> closed_line(const SvgPath& path, FlatPath flat) {
  if (flat.pieces.size() > 1)
    return failure(path.place, path.name + " has " + std::to_string(flat.pieces.size()) + " pieces",
                   "draw the outline as one closed line");
  Drawing outline = std::move(flat.pieces.front());
  const bool meets = outline.front() == outline.back();
  if (!meets && !flat.closed)
    return failure(path.place, path.name + " is open",
                   "close it: in Inkscape, select its two ends with the node tool and press "
                   "Shift+J");
  if (meets) outline.pop_back();
  return outline;
}

}  // namespace

Result<std::vector<SvgPath>> find_svg_paths(const std::filesystem::path& file,
                                            const std::string& id, const PathKey& key) {
  const auto svg = load(file);
  if (!svg) return tl::unexpected(svg.error());
  const auto shown = visible(is_path, *svg);
  const auto nodes = id.empty() ? only_path(*svg, shown, key) : paths_by_id(*svg, shown, id, key);
  if (!nodes) return tl::unexpected(nodes.error());
  const std::vector<Depth> depths = depths_of(*svg, *nodes);
  std::vector<SvgPath> paths;
  for (const pugi::xml_node& node : *nodes) {
    const auto transform = root_from_path(*svg, node);
    if (!transform) return tl::unexpected(transform.error());
    paths.push_back({svg->place(node),
                     id_of(node).empty() ? "the path" : "path '" + id_of(node) + "'",
                     path_data(node), *transform, depths[paths.size()]});
  }
  return paths;
}

Result<std::vector<Drawing>> flattened(const SvgPath& path, double tolerance) {
  return flat(path, tolerance).and_then([&](FlatPath drawn) {
    return open_pieces(path, std::move(drawn));
  });
}

Result<Drawing> flattened_outline(const SvgPath& path, double tolerance) {
  return flat(path, tolerance).and_then([&](FlatPath drawn) {
    return closed_line(path, std::move(drawn));
  });
}

Result<std::vector<DrawnMark>> find_svg_marks(const std::filesystem::path& file) {
  const auto svg = load(file);
  if (!svg) return tl::unexpected(svg.error());
  std::vector<DrawnMark> marks;
  for (const pugi::xml_node& circle : visible(is_circle, *svg))
    if (!id_of(circle).empty()) marks.push_back({id_of(circle), middle_of(*svg, circle)});
  return marks;
}

double extent_of(const Drawing& drawing) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : drawing) box.extend(point);
  return length_of(box.diagonal());
}

}  // namespace ribbon

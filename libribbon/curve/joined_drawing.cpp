#include "curve/joined_drawing.h"

#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include "curve/place.h"
#include "curve/turns.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;

constexpr double flatness_per_extent = 1e-5;  // a tenth of what find_double_points calls touching
constexpr double path_flatness_per_extent = 1e-3;
constexpr double widest_gap_per_extent = 0.1;
constexpr double largest_turn = std::numbers::pi / 6;  // at each end of a gap
constexpr double meeting_per_extent = 1e-5;            // ends nearer than this have no gap

// Ends 2 i and 2 i + 1 are the first and the last point of piece i.
std::size_t other_end(std::size_t end) {
  return end ^ 1U;
}

double extent_of_all(const std::vector<DrawnPiece>& pieces) {
  Drawing all;
  for (const DrawnPiece& piece : pieces)
    all.insert(all.end(), piece.points.begin(), piece.points.end());
  return extent_of(all);
}

class Pieces {
 public:
  explicit Pieces(const std::vector<DrawnPiece>& pieces)
      : pieces_(pieces), extent_(extent_of_all(pieces)) {}

  [[nodiscard]] std::size_t end_count() const { return 2 * pieces_.size(); }
  [[nodiscard]] const Vector2d& point(std::size_t end) const {
    return end % 2 == 0 ? piece(end).front() : piece(end).back();
  }

  // The end that continues this one and that this one continues; nothing for a free end.
  [[nodiscard]] std::optional<std::size_t> partner(std::size_t end) const {
    const auto there = nearest(end);
    return there && nearest(*there) == end ? there : std::nullopt;
  }

  [[nodiscard]] Depth depth(std::size_t end) const { return pieces_[end / 2].depth; }
  [[nodiscard]] bool meet(std::size_t end, std::size_t other) const {
    return length_of(point(other) - point(end)) <= meeting_per_extent * extent_;
  }

  // The points of the end's piece, walked from the end.
  [[nodiscard]] Drawing walked_from(std::size_t end) const {
    return end % 2 == 0 ? piece(end) : Drawing(piece(end).rbegin(), piece(end).rend());
  }

 private:
  [[nodiscard]] const Drawing& piece(std::size_t end) const { return pieces_[end / 2].points; }
  [[nodiscard]] Vector2d outwards(std::size_t end) const {
    const Drawing& points = piece(end);
    return end % 2 == 0 ? Vector2d(points[0] - points[1])
                        : Vector2d(points.back() - points[points.size() - 2]);
  }

  [[nodiscard]] bool continues(std::size_t end, std::size_t other) const {
    if (end / 2 == other / 2) return false;
    if (meet(end, other)) return angle_between(outwards(end), -outwards(other)) < largest_turn;
    const Vector2d gap = point(other) - point(end);
    return length_of(gap) <= widest_gap_per_extent * extent_ &&
           angle_between(outwards(end), gap) < largest_turn &&
           angle_between(outwards(other), -gap) < largest_turn;
  }

  [[nodiscard]] std::optional<std::size_t> nearest(std::size_t end) const {
    std::optional<std::size_t> result;
    const auto distance = [&](std::size_t other) { return length_of(point(other) - point(end)); };
    for (std::size_t other = 0; other < end_count(); ++other)
      if (continues(end, other) && (!result || distance(other) < distance(*result))) result = other;
    return result;
  }

  const std::vector<DrawnPiece>& pieces_;
  double extent_;
};

tl::unexpected<Error> wrong_ends(const Pieces& pieces, const std::vector<std::size_t>& free) {
  if (free.size() < 2)
    return failure("drawing", "its pieces close to a loop", "leave two ends of it free");
  // The first two are the ends of the ribbon, if all others are mistakes.
  return failure(
      drawing_place(pieces.point(free[2])),
      std::to_string(free.size()) +
          " ends of the drawing's pieces are not continued, this is the third",
      "join the pieces (Shift+J at two nodes in Inkscape), or leave a gap only where the "
      "line passes under itself: short, and with both ends in line");
}

// A walk over pieces that hang together.
struct WalkedPieces {
  JoinedDrawing drawing;
  std::size_t count = 0;
};

void append(const Drawing& piece, bool meets, Depth depth, JoinedDrawing& drawing) {
  if (!drawing.points.empty() && !meets) drawing.gaps.push_back(drawing.points.size() - 1);
  const std::size_t begin = drawing.points.size() - (meets ? 1 : 0);
  drawing.points.insert(drawing.points.end(), piece.begin() + (meets ? 1 : 0), piece.end());
  if (depth == Depth::untold) return;
  const std::size_t end = drawing.points.size() - 1;
  const bool goes_on = !drawing.depths.empty() && drawing.depths.back().depth == depth &&
                       drawing.depths.back().end + 1 >= begin;
  if (goes_on)
    drawing.depths.back().end = end;
  else
    drawing.depths.push_back({begin, end, depth});
}

// From a free end.
WalkedPieces walk_from(std::size_t end, const Pieces& pieces) {
  WalkedPieces walked;
  bool meets = false;
  for (std::optional<std::size_t> next = end; next;) {
    append(pieces.walked_from(*next), meets, pieces.depth(*next), walked.drawing);
    ++walked.count;
    const std::size_t far_end = other_end(*next);
    next = pieces.partner(far_end);
    meets = next && pieces.meet(far_end, *next);
  }
  return walked;
}

Result<JoinedDrawing> read(const DrawnPoints& drawn) {
  Drawing drawing;
  for (const Vector2d& point : drawn.points) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > 1e9)
      return failure("drawing", "a point lies beyond 1e9 drawing units", "correct it");
    if (drawing.empty() || drawing.back() != point) drawing.push_back(point);
  }
  if (drawing.size() < 2)
    return failure("drawing", "the points have no length", "give at least two different points");
  return JoinedDrawing{std::move(drawing), {}};
}

Result<std::vector<DrawnPiece>> flattened(const std::vector<SvgPath>& paths, double tolerance) {
  std::vector<DrawnPiece> pieces;
  for (const SvgPath& path : paths) {
    auto drawn = flattened(path, tolerance);
    if (!drawn) return tl::unexpected(drawn.error());
    for (Drawing& points : *drawn) pieces.push_back({std::move(points), path.depth});
  }
  return pieces;
}

// Flattened twice: how fine depends on how large the drawing is.
Result<JoinedDrawing> read(const DrawnSvg& drawn, const PathKey& key, double flatness) {
  if (auto there = check_readable(drawn.file); !there) return tl::unexpected(there.error());
  const auto paths = find_svg_paths(drawn.file.path, drawn.path_id, key);
  if (!paths) return tl::unexpected(paths.error());
  const auto coarse = flattened(*paths, std::numeric_limits<double>::max());
  if (!coarse) return tl::unexpected(coarse.error());
  return flattened(*paths, flatness * extent_of_all(*coarse)).and_then(joined);
}

Result<JoinedDrawing> read(const DrawnSvg& drawn) {
  return read(drawn, {}, flatness_per_extent);
}

}  // namespace

Result<JoinedDrawing> joined(const std::vector<DrawnPiece>& pieces) {
  const Pieces loose(pieces);
  std::vector<std::size_t> free;
  for (std::size_t end = 0; end < loose.end_count(); ++end)
    if (!loose.partner(end)) free.push_back(end);
  if (free.size() != 2) return wrong_ends(loose, free);
  WalkedPieces walked = walk_from(free.front(), loose);
  if (walked.count == pieces.size()) return std::move(walked.drawing);
  return failure("drawing",
                 "it is made of " + std::to_string(pieces.size()) + " pieces, of which only " +
                     std::to_string(walked.count) + " hang together; the others close to a loop",
                 "draw one line");
}

Result<JoinedDrawing> read_drawing(const CurveScene& scene) {
  return std::visit([](const auto& drawn) { return read(drawn); }, scene.drawing);
}

Result<Drawing> read_path(const DrawnSvg& drawn, const PathKey& key) {
  return read(drawn, key, path_flatness_per_extent).map([](JoinedDrawing&& path) {
    return std::move(path.points);
  });
}

}  // namespace ribbon

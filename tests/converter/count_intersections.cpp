// count_intersections FILE: prints, for each mesh in the file, how many pairs of its triangles meet
// by CGAL's exact predicates. Exit code 2 when the file does not hold what it says.
//
// A mesh, as blender_tessellation.py writes it (little-endian): i32 points, i32 triangles, i32
// judged triangles (those of the ribbon come first), f32 x, y, z of each point, i32 three corners
// of each triangle.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string_view>

#include "files/files.h"
#include "result/demanded.h"
#include "verification/cgal_oracle.h"

namespace ribbon {
namespace {

static_assert(std::endian::native == std::endian::little);

// Fills `target` from the front of `bytes`.
bool take(std::string_view& bytes, void* target, std::size_t count) {
  if (bytes.size() < count) return false;
  std::memcpy(target, bytes.data(), count);
  bytes.remove_prefix(count);
  return true;
}

struct Counts {
  std::int32_t points, triangles, judged;
};

bool fit(const Counts& counts, std::size_t bytes) {
  if (counts.points < 0 || counts.judged < 0 || counts.triangles < counts.judged) return false;
  const auto columns = static_cast<std::size_t>(counts.points) + counts.triangles;
  return columns <= bytes / 12;
}

std::optional<TriangleSoup> take_soup(std::string_view& bytes) {
  Counts counts{};
  if (!take(bytes, &counts, sizeof counts) || !fit(counts, bytes.size())) return std::nullopt;
  TriangleSoup soup{.points = Eigen::Matrix3Xf(3, counts.points),
                    .triangles = Eigen::Matrix3Xi(3, counts.triangles),
                    .judged = counts.judged};
  take(bytes, soup.points.data(), sizeof(float) * soup.points.size());
  take(bytes, soup.triangles.data(), sizeof(int) * soup.triangles.size());
  const bool known = soup.triangles.size() == 0 ||
                     (soup.triangles.minCoeff() >= 0 && soup.triangles.maxCoeff() < counts.points);
  return known ? std::optional(soup) : std::nullopt;
}

int count_all(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto soup = take_soup(bytes);
    if (!soup) {
      std::fprintf(stderr, "count_intersections: the file does not hold what it says\n");
      return 2;
    }
    std::printf("%zu\n", cgal_intersecting_pairs(*soup).size());
  }
  return 0;
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: count_intersections FILE\n");
    return 2;
  }
  return ribbon::count_all(demanded(ribbon::read_file(argv[1])));
}

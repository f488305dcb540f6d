#include "converter/read_back/point_caches.h"

#include <charconv>
#include <cstdint>
#include <limits>
#include <string_view>

#include "converter/read_back/written_bytes.h"

namespace ribbon {

namespace {

// What a file's head says: where its positions begin, and how many there are.
struct CacheHead {
  std::uint64_t begin = 0;
  std::uint64_t frames = 0;
  std::uint64_t points = 0;
  std::vector<double> times_s = {};
  std::endian order = std::endian::little;
};

class PointCache : public WrittenMotion {
 public:
  PointCache(WrittenBytes bytes, CacheHead head)
      : bytes_(std::move(bytes)), head_(std::move(head)) {
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    demand(head_.frames > 0 && head_.frames <= most && head_.points <= most, "a wrong count");
    demand(bytes_.size() == head_.begin + head_.frames * frame_bytes(), "a wrong length");
    scene_.meshes.resize(1);
    scene_.has_faces = false;
    scene_.frames = static_cast<int>(head_.frames);
    scene_.times_s = std::move(head_.times_s);
  }

  Eigen::Matrix3Xd ribbon(int frame) override {
    return bytes_.points(head_.begin + static_cast<std::uint64_t>(frame) * frame_bytes(),
                         head_.points, head_.order);
  }

 private:
  [[nodiscard]] std::uint64_t frame_bytes() const { return 12 * head_.points; }

  WrittenBytes bytes_;
  CacheHead head_;
};

// The numbers between `opening` and its closing bracket, with commas and spaces between them.
std::vector<std::uint64_t> numbers_behind(std::string_view text, std::string_view opening) {
  const std::size_t found = text.find(opening);
  demand(found != std::string_view::npos, "no shape");
  std::vector<std::uint64_t> numbers;
  const char* at = text.data() + found + opening.size();
  const char* const end = text.data() + text.size();
  while (at != end && *at != ')') {
    std::uint64_t number = 0;
    const auto [after, problem] = std::from_chars(at, end, number);
    demand(problem == std::errc{}, "a shape that is no list of numbers");
    numbers.push_back(number);
    for (at = after; at != end && (*at == ',' || *at == ' ');) ++at;
  }
  return numbers;
}

}  // namespace

std::unique_ptr<WrittenMotion> read_npy(const std::filesystem::path& path) {
  WrittenBytes bytes(path);
  demand(bytes.at(0, 8) == std::string_view("\x93NUMPY\x01\x00", 8), "not an array of NumPy's");
  const auto size = bytes.number<std::uint16_t>(8);
  const std::string text = bytes.at(10, size);
  demand(text.find("'descr': '<f4'") != std::string::npos, "not in single precision");
  demand(text.find("'fortran_order': False") != std::string::npos, "not in C order");
  const auto shape = numbers_behind(text, "'shape': (");
  demand(shape.size() == 4 && shape[3] == 3, "not frames x along x across x 3");
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  demand(shape[1] <= most && shape[2] <= most, "a wrong count");
  CacheHead head{.begin = 10U + size, .frames = shape[0], .points = shape[1] * shape[2]};
  return std::make_unique<PointCache>(std::move(bytes), std::move(head));
}

std::unique_ptr<WrittenMotion> read_mdd(const std::filesystem::path& path) {
  WrittenBytes bytes(path);
  constexpr std::endian order = std::endian::big;
  const auto frames = bytes.number<std::uint32_t>(0, order);
  const auto points = bytes.number<std::uint32_t>(4, order);
  const Eigen::MatrixXd times_s = bytes.numbers<float>(8, 1, frames, order).cast<double>();
  CacheHead head{.begin = 8 + 4 * std::uint64_t{frames},
                 .frames = frames,
                 .points = points,
                 .times_s = {times_s.data(), times_s.data() + times_s.size()},
                 .order = order};
  return std::make_unique<PointCache>(std::move(bytes), std::move(head));
}

std::unique_ptr<WrittenMotion> read_pc2(const std::filesystem::path& path) {
  WrittenBytes bytes(path);
  demand(bytes.at(0, 12) == std::string_view("POINTCACHE2\0", 12), "not a point cache 2");
  demand(bytes.number<std::uint32_t>(12) == 1, "another version");
  demand(bytes.number<float>(20) == 0 && bytes.number<float>(24) == 1, "not a sample a frame");
  CacheHead head{.begin = 32,
                 .frames = bytes.number<std::uint32_t>(28),
                 .points = bytes.number<std::uint32_t>(16)};
  return std::make_unique<PointCache>(std::move(bytes), std::move(head));
}

}  // namespace ribbon

// What a file of a modelling package holds, for comparing it with what it should hold.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "result/result.h"

namespace ribbon {

struct WrittenMesh {
  Eigen::Matrix3Xd positions = Eigen::Matrix3Xd(3, 0);  // 3 x vertices; of what moves 3 x 0
  Eigen::Matrix2Xd uv = Eigen::Matrix2Xd(2, 0);         // 2 x vertices, v upwards; 2 x 0: none
  Eigen::MatrixXi faces = {};  // corners x faces, counter-clockwise; 0 x 0: none
};

// What no frame changes.
struct WrittenScene {
  std::vector<WrittenMesh> meshes;  // the ribbon first
  bool has_faces = true;            // false: positions of the ribbon alone
  int frames = 1;
  std::vector<double> times_s;  // of all frames; empty where the file does not say
  std::optional<double> metres_per_unit;
  std::optional<bool> z_is_up;
};

// That a file is not what it should be; stays within this folder.
class Spoiled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline void demand(bool good, const char* otherwise) {
  if (!good) throw Spoiled(otherwise);
}

// The answer of `read`; where that finds `path` spoiled, or ends in any other exception, an error.
// What the system lacks is not the file's fault, and passes on.
template <class Read>
auto read_strictly(const std::filesystem::path& path, const Read& read)
    -> Result<decltype(read())> {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::system_error&) {
    throw;
  } catch (const std::exception& problem) {
    return failure(path.string(), std::string("cannot be read back: ") + problem.what(),
                   "convert it again with --force");
  }
}

// A file that was opened. Its readers share no code with its writer: what they know of a format is
// its description. Memory: a few frames, and some bytes for each.
class WrittenMotion {
 public:
  WrittenMotion() = default;
  WrittenMotion(const WrittenMotion&) = delete;
  WrittenMotion& operator=(const WrittenMotion&) = delete;
  virtual ~WrittenMotion() = default;

  [[nodiscard]] const WrittenScene& scene() const { return scene_; }

  // Where the ribbon's vertices are in a frame (from 0): 3 x vertices. Throws Spoiled.
  [[nodiscard]] virtual Eigen::Matrix3Xd ribbon(int frame) = 0;

 protected:
  WrittenScene scene_;
};

}  // namespace ribbon

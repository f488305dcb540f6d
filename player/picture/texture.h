// A picture that is laid on cloth.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "player/picture/color.h"
#include "result/result.h"

namespace ribbon {

// Linear light of a PNG file, and the same in ever coarser steps, so that a look that spans many of
// its pixels sees their mean.
class Texture {
 public:
  // Transparent pixels become white. Fails when the file is no PNG, is damaged, or is larger than
  // 16384 x 16384.
  static Result<Texture> read(const std::filesystem::path& file);

  // That it takes in memory.
  [[nodiscard]] std::size_t bytes() const;
  // Of the file's picture, in pixels, and width over height.
  [[nodiscard]] int width() const { return levels_.front().width; }
  [[nodiscard]] int height() const { return levels_.front().height; }
  [[nodiscard]] float aspect() const;
  // At x from the left, 0 to 1 and repeated beyond, and y from the bottom, 0 to 1; `reach` is how
  // wide the look is, where the picture's height is 1.
  [[nodiscard]] Color at(float x, float y, float reach) const;

 private:
  struct Level {
    int width;
    int height;
    std::vector<Color> pixels;  // row by row from the top left
  };
  explicit Texture(Level finest);
  static Level halved(const Level& level);
  static Color interpolated(const Level& level, float x, float y);

  std::vector<Level> levels_;  // each half of the one before, down to a single pixel
};

}  // namespace ribbon

// What the preview shows, in OpenGL's memory: ribbon, obstacle, input curve.
#pragma once

#include <optional>

#include "player/picture/picture.h"
#include "player/preview/line_bands.h"
#include "player/preview/projection.h"
#include "player/preview/shader_program.h"
#include "player/preview/vertex_array.h"
#include "player/render/cloth_colors.h"
#include "player/render/surface.h"
#include "recording/records/recording.h"

namespace ribbon {

// A camera, and a whole picture of it.
struct PreviewShot {
  Camera camera;
  PictureSize size;
};

class PreviewScene {
 public:
  // Obstacle and curve are there, as far as the recording has them; the ribbon is not yet. Keeps a
  // reference to `gl`. Fails where OpenGL does.
  static Result<PreviewScene> create(const Gl& gl, const RecordingHeader& header,
                                     const ClothColors& cloth);

  // positions: 3 x particles, in metres of the model.
  void set_ribbon(const Eigen::Matrix3Xf& positions);

  // Into what is being drawn into, which is clear. What is drawn has its opacity, and its colours
  // are multiplied by that.
  void draw(const PreviewShot& shot) const;

 private:
  struct Programs {
    ShaderProgram cloth;
    ShaderProgram line;
  };
  static Result<Programs> make_programs(const Gl& gl);

  PreviewScene(const Gl& gl, const RecordingHeader& header, const ClothColors& cloth,
               Programs programs);
  void load(const ClothColors& cloth);
  void set_lines(const LineBands& bands, std::optional<VertexArray>& lines);
  void draw_ribbon(const Eigen::Matrix4f& clip_from_world) const;
  void draw_lines(const PreviewShot& shot, const Eigen::Matrix4f& clip_from_world) const;
  void draw_wire(PictureSize size) const;
  void draw_curve(PictureSize size) const;

  const Gl* gl_;
  Programs programs_;
  RibbonGrid grid_;
  float ribbon_width_m_;
  Eigen::Vector2f periods_;     // of front and back: ribbon widths after which they begin anew
  Surface surface_;             // of the ribbon
  Eigen::MatrixXf vertices_;    // of the ribbon: position, normal, place in ribbon widths
  Eigen::AlignedBox3f still_;   // around obstacle and curve
  Eigen::AlignedBox3f moving_;  // around the ribbon
  VertexArray ribbon_;
  std::optional<VertexArray> wire_;
  std::optional<VertexArray> curve_;
};

}  // namespace ribbon

#include "player/preview/preview_scene.h"

#include <algorithm>

#include "player/picture/curve_style.h"
#include "player/preview/cloth_texels.h"
#include "player/preview/shaders.h"
#include "player/preview/wire_edges.h"
#include "player/render/lighting.h"

namespace ribbon {

namespace {

const Color wire_color = from_srgb(0x4A5560);
constexpr float wire_opacity = 0.85F;
constexpr float wire_far_opacity = 0.3F;  // of that, where the obstacle's faces look away
constexpr float wire_pixels = 1;          // of a picture 720 pixels high

// As shaders take colours, with all channels multiplied by the opacity.
Eigen::Vector4f shader_color(const Color& color, float opacity) {
  const Color root = color.sqrt() * opacity;
  return {root[0], root[1], root[2], opacity};
}

// Lines in small pictures are not as thin as these are small.
float scale_of(PictureSize size) {
  return std::max(0.6F, static_cast<float>(std::min(size.width, size.height)) / 720);
}

}  // namespace

Result<PreviewScene::Programs> PreviewScene::make_programs(const Gl& gl) {
  auto cloth = ShaderProgram::create(gl, cloth_vertex_shader, cloth_fragment_shader,
                                     {"position", "normal", "thread"});
  if (!cloth) return tl::unexpected(cloth.error());
  auto line = ShaderProgram::create(gl, line_vertex_shader, line_fragment_shader,
                                    {"position", "before", "after", "side", "face", "other_face"});
  if (!line) return tl::unexpected(line.error());
  return Programs{*cloth, *line};
}

Result<PreviewScene> PreviewScene::create(const Gl& gl, const RecordingHeader& header,
                                          const ClothColors& cloth) {
  const auto programs = make_programs(gl);
  if (!programs) return tl::unexpected(programs.error());
  return PreviewScene(gl, header, cloth, *programs);
}

PreviewScene::PreviewScene(const Gl& gl, const RecordingHeader& header, const ClothColors& cloth,
                           Programs programs)
    : gl_(&gl),
      programs_(programs),
      grid_(header.grid),
      ribbon_width_m_(static_cast<float>(header.ribbon_width_m)),
      surface_(ribbon_surface(header.grid)),
      vertices_(8, header.grid.particle_count()),
      ribbon_(gl, {3, 3, 2}) {
  load(cloth);
  const auto widths_long = static_cast<float>(header.ribbon_length_m / header.ribbon_width_m);
  vertices_.row(6) = header.uv.row(0) * widths_long;
  vertices_.row(7) = header.uv.row(1);
  ribbon_.set_triangles(surface_.triangles);
  if (header.obstacle && header.obstacle->triangles.cols() > 0)
    set_lines(bands_of(wire_edges(*header.obstacle)), wire_);
  if (header.input_curve.cols() > 0) set_lines(band_through(header.input_curve), curve_);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void PreviewScene::load(const ClothColors& cloth) {
  const ClothTexels texels = cloth_texels(cloth);
  periods_ = texels.period;
  GLuint texture = 0;
  gl_->GenTextures(1, &texture);
  gl_->BindTexture(GL_TEXTURE_2D_ARRAY, texture);
  gl_->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, texels.along, texels.across, 2, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, texels.bytes.data());
  gl_->GenerateMipmap(GL_TEXTURE_2D_ARRAY);
  gl_->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void PreviewScene::set_lines(const LineBands& bands, std::optional<VertexArray>& lines) {
  lines.emplace(*gl_, line_parts);
  lines->set_vertices(bands.vertices);
  lines->set_triangles(bands.triangles);
  for (const auto vertex : bands.vertices.colwise())
    still_.extend(Eigen::Vector3f(vertex.head<3>()));
}

void PreviewScene::set_ribbon(const Eigen::Matrix3Xf& positions) {
  update_ribbon(grid_, positions, surface_);
  vertices_.topRows<3>() = surface_.vertices;
  vertices_.middleRows<3>(3) = surface_.normals;
  ribbon_.set_vertices(vertices_);
  moving_ = Eigen::AlignedBox3f(positions.rowwise().minCoeff(), positions.rowwise().maxCoeff());
}

void PreviewScene::draw(const PreviewShot& shot) const {
  const Eigen::Matrix4f clip =
      clip_from_world(shot.camera, depth_range(shot.camera, still_.merged(moving_)));
  draw_ribbon(clip);
  draw_lines(shot, clip);
}

void PreviewScene::draw_ribbon(const Eigen::Matrix4f& clip_from_world) const {
  const Lighting lighting;
  const auto vector = [](const Color& color) { return Eigen::Vector3f(color.matrix()); };
  const ShaderProgram& program = programs_.cloth;
  program.use();
  program.set("clip_from_world", clip_from_world);
  program.set("periods", periods_);
  program.set("sun_direction", lighting.sun_direction);
  program.set("sun", vector(lighting.sun));
  program.set("sky_above", vector(lighting.sky_above));
  program.set("sky_below", vector(lighting.sky_below));
  ribbon_.draw_triangles();
}

void PreviewScene::draw_lines(const PreviewShot& shot,
                              const Eigen::Matrix4f& clip_from_world) const {
  const Eigen::Vector2f half_size =
      Eigen::Vector2i(shot.size.width, shot.size.height).cast<float>() / 2;
  programs_.line.use();
  programs_.line.set("clip_from_world", clip_from_world);
  programs_.line.set("eye", shot.camera.eye);
  programs_.line.set("half_size", half_size);
  programs_.line.set("far_opacity", wire_far_opacity);
  gl_->DepthMask(GL_FALSE);  // lines do not hide each other
  if (wire_) draw_wire(shot.size);
  if (curve_) draw_curve(shot.size);
  gl_->DepthMask(GL_TRUE);
}

void PreviewScene::draw_wire(PictureSize size) const {
  programs_.line.set("half_width", wire_pixels / 2 * scale_of(size));
  programs_.line.set("forward", 0);
  programs_.line.set("ink", shader_color(wire_color, wire_opacity));
  wire_->draw_triangles();
}

// What the ribbon hides of it is dimmed.
void PreviewScene::draw_curve(PictureSize size) const {
  programs_.line.set("half_width", curve_style::pixels / 2 * scale_of(size));
  programs_.line.set("forward", curve_style::forward * ribbon_width_m_);
  programs_.line.set("ink", shader_color(curve_style::ink, curve_style::hidden_opacity));
  gl_->DepthFunc(GL_GREATER);
  curve_->draw_triangles();
  programs_.line.set("ink", shader_color(curve_style::ink, 1));
  gl_->DepthFunc(GL_LESS);
  curve_->draw_triangles();
}

}  // namespace ribbon

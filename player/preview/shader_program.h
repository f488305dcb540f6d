// Two shaders that draw together.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "player/preview/gl.h"
#include "result/result.h"

namespace ribbon {

class ShaderProgram {
 public:
  // inputs: of the vertex shader, numbered as they stand here. Keeps a reference to `gl`. Fails
  // where OpenGL cannot make a program of it.
  static Result<ShaderProgram> create(const Gl& gl, const char* vertex_shader,
                                      const char* fragment_shader,
                                      const std::vector<const char*>& inputs);

  void use() const;
  // Of the program in use.
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Vector4f& value) const;
  void set(const char* uniform, const Eigen::Matrix4f& value) const;

 private:
  ShaderProgram(const Gl& gl, GLuint program) : gl_(&gl), program_(program) {}
  [[nodiscard]] GLint place(const char* uniform) const;

  const Gl* gl_;
  GLuint program_;
};

}  // namespace ribbon

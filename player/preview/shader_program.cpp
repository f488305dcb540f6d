#include "player/preview/shader_program.h"

namespace ribbon {

namespace {

void attach(const Gl& gl, GLuint program, GLenum kind, const char* text) {
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  gl.AttachShader(program, shader);
  gl.DeleteShader(shader);  // the program keeps it
}

}  // namespace

Result<ShaderProgram> ShaderProgram::create(const Gl& gl, const char* vertex_shader,
                                            const char* fragment_shader,
                                            const std::vector<const char*>& inputs) {
  const GLuint program = gl.CreateProgram();
  attach(gl, program, GL_VERTEX_SHADER, vertex_shader);
  attach(gl, program, GL_FRAGMENT_SHADER, fragment_shader);
  for (GLuint i = 0; i < inputs.size(); ++i) gl.BindAttribLocation(program, i, inputs[i]);
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return ShaderProgram(gl, program);
  return failure("--preview", "OSMesa does not understand our shaders",
                 "install a newer OSMesa, or render without --preview");
}

void ShaderProgram::use() const {
  gl_->UseProgram(program_);
}

GLint ShaderProgram::place(const char* uniform) const {
  return gl_->GetUniformLocation(program_, uniform);
}

void ShaderProgram::set(const char* uniform, float value) const {
  gl_->Uniform1f(place(uniform), value);
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
  gl_->Uniform2f(place(uniform), value.x(), value.y());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
  gl_->Uniform3fv(place(uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector4f& value) const {
  gl_->Uniform4fv(place(uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Matrix4f& value) const {
  gl_->UniformMatrix4fv(place(uniform), 1, GL_FALSE, value.data());
}

}  // namespace ribbon

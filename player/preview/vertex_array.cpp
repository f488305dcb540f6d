#include "player/preview/vertex_array.h"

#include <cstdint>
#include <numeric>

namespace ribbon {

VertexArray::VertexArray(const Gl& gl, const std::vector<int>& parts) : gl_(&gl) {
  gl.GenVertexArrays(1, &array_);
  gl.BindVertexArray(array_);
  gl.GenBuffers(1, &vertex_buffer_);
  gl.GenBuffers(1, &index_buffer_);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  const int numbers = std::accumulate(parts.begin(), parts.end(), 0);
  std::uintptr_t offset = 0;  // which OpenGL takes for a pointer
  for (GLuint i = 0; i < parts.size(); ++i) {
    gl.EnableVertexAttribArray(i);
    gl.VertexAttribPointer(
        i, parts[i], GL_FLOAT, GL_FALSE, numbers * static_cast<GLsizei>(sizeof(float)),
        reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr)
    offset += static_cast<std::uintptr_t>(parts[i]) * sizeof(float);
  }
}

void VertexArray::set_vertices(const Eigen::MatrixXf& vertices) {
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  gl_->BufferData(GL_ARRAY_BUFFER, vertices.size() * static_cast<GLsizeiptr>(sizeof(float)),
                  vertices.data(), GL_STREAM_DRAW);
}

void VertexArray::set_triangles(const Eigen::Matrix3Xi& triangles) {
  gl_->BindVertexArray(array_);
  gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER, triangles.size() * static_cast<GLsizeiptr>(sizeof(int)),
                  triangles.data(), GL_STATIC_DRAW);
  indices_ = static_cast<GLsizei>(triangles.size());
}

void VertexArray::draw_triangles() const {
  gl_->BindVertexArray(array_);
  gl_->DrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace ribbon

// Vertices in OpenGL's memory.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "player/preview/gl.h"

namespace ribbon {

class VertexArray {
 public:
  // parts: how many numbers each input of the shader takes. Keeps a reference to `gl`. The context
  // frees what is made here.
  VertexArray(const Gl& gl, const std::vector<int>& parts);

  // One vertex a column, its inputs below each other.
  void set_vertices(const Eigen::MatrixXf& vertices);
  // Three vertices of each triangle.
  void set_triangles(const Eigen::Matrix3Xi& triangles);

  void draw_triangles() const;

 private:
  const Gl* gl_;
  GLuint array_ = 0;
  GLuint vertex_buffer_ = 0;
  GLuint index_buffer_ = 0;
  GLsizei indices_ = 0;
};

}  // namespace ribbon

#include "converter/export/obj_text.h"

#include <array>
#include <charconv>

namespace ribbon {

namespace {

template <class Number>
void append_number(std::string& text, char before, Number number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text += before;
  text.append(digits.data(), end);
}

template <class Columns>
void append_columns(std::string& text, const char* keyword, const Columns& columns) {
  for (Eigen::Index column = 0; column < columns.cols(); ++column) {
    text += keyword;
    for (Eigen::Index row = 0; row < columns.rows(); ++row)
      append_number(text, ' ', columns(row, column));
    text += '\n';
  }
}

// OBJ counts vertices and uv from 1 and through the whole file.
void append_faces(std::string& text, const ModelObject& object, Eigen::Index first_vertex,
                  Eigen::Index first_uv) {
  const bool has_uv = object.uv.cols() > 0;
  for (Eigen::Index face = 0; face < object.faces.cols(); ++face) {
    text += 'f';
    for (const int corner : object.faces.col(face)) {
      append_number(text, ' ', corner + first_vertex);
      if (has_uv) append_number(text, '/', corner + first_uv);
    }
    text += '\n';
  }
}

std::size_t expected_bytes(const Model& model) {
  std::size_t bytes = 1000;
  for (const ModelObject& object : model.objects)
    bytes += 40 * object.positions.cols() + 24 * object.uv.cols() + 48 * object.faces.cols();
  return bytes;
}

}  // namespace

std::string obj_text(const Model& model, const std::string& material_library) {
  std::string text;
  text.reserve(expected_bytes(model));
  text += "# ribbon-convert: metres, y up\nmtllib " + material_library + '\n';
  Eigen::Index first_vertex = 1;
  Eigen::Index first_uv = 1;
  for (const ModelObject& object : model.objects) {
    text += "o " + object.name + '\n';
    append_columns(text, "v", object.positions);
    append_columns(text, "vt", object.uv);
    text += "usemtl " + object.material.name + '\n';
    append_faces(text, object, first_vertex, first_uv);
    first_vertex += object.positions.cols();
    first_uv += object.uv.cols();
  }
  return text;
}

std::string material_library_text(const Model& model) {
  std::string text = "# ribbon-convert\n";
  for (const ModelObject& object : model.objects) {
    text += "newmtl " + object.material.name + '\n';
    append_columns(text, "Kd", object.material.color);
    text += "d 1\nillum 1\n";
  }
  return text;
}

}  // namespace ribbon

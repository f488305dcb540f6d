#include "model/obj_text.h"

#include "model/number_digits.h"
#include "model/picture_file.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

template <class Number>
void append_number(std::string& text, char before, Number number) {
  text += before;
  append_digits(text, number);
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

// OBJ counts vertices, uv and normals from 1 and through the whole file.
struct FirstNumbers {
  Eigen::Index vertex = 1;
  Eigen::Index uv = 1;
  Eigen::Index normal = 1;
};

// A corner is vertex, vertex/uv, vertex//normal or vertex/uv/normal.
void append_corner(std::string& text, const ModelObject& object, int corner,
                   const FirstNumbers& first) {
  const bool has_uv = object.uv.cols() > 0;
  const bool has_normals = object.normals.cols() > 0;
  append_number(text, ' ', corner + first.vertex);
  if (has_uv) append_number(text, '/', corner + first.uv);
  if (has_normals && !has_uv) text += '/';
  if (has_normals) append_number(text, '/', corner + first.normal);
}

void append_faces(std::string& text, const ModelObject& object, const FirstNumbers& first,
                  bool with_materials) {
  for (const ModelPart& part : parts_of(object)) {
    if (with_materials) text += "usemtl " + part.material.name + '\n';
    for (const auto& face : object.faces.middleCols(part.first_face, part.faces).colwise()) {
      text += 'f';
      for (const int corner : face) append_corner(text, object, corner, first);
      text += '\n';
    }
  }
}

// OBJ itself cannot say it; people read it.
std::string placement_text(const Placement& placement) {
  const bool metres = placement.metres_per_unit == 1;
  return (metres ? "metres" : filled_in("units of {:.6g} m", placement.metres_per_unit)) +
         (placement.up == UpAxis::y ? ", y up" : ", z up");
}

std::size_t expected_bytes(const Model& model) {
  std::size_t bytes = 1000;
  for (const ModelObject& object : model.objects)
    bytes += 40 * object.positions.cols() + 24 * object.uv.cols() + 40 * object.normals.cols() +
             48 * object.faces.cols();
  return bytes;
}

}  // namespace

std::string obj_text(const Model& model, const std::string& material_library) {
  std::string text;
  text.reserve(expected_bytes(model));
  const bool with_materials = !material_library.empty();
  text += "# ribbon: " + placement_text(model.placement) + '\n';
  if (with_materials) text += "mtllib " + material_library + '\n';
  FirstNumbers first;
  for (const ModelObject& object : model.objects) {
    text += "o " + object.name + '\n';
    append_columns(text, "v", object.positions);
    append_columns(text, "vt", object.uv);
    append_columns(text, "vn", object.normals);
    append_faces(text, object, first, with_materials);
    first.vertex += object.positions.cols();
    first.uv += object.uv.cols();
    first.normal += object.normals.cols();
  }
  return text;
}

std::string material_library_text(const Model& model) {
  std::string text = "# ribbon\n";
  for (const Material& material : materials_of(model)) {
    text += "newmtl " + material.name + '\n';
    append_columns(text, "Kd", material.color);
    text += "d 1\nillum 1\n";
    if (material.picture) text += "map_Kd " + material.picture->name + '\n';
  }
  return text;
}

}  // namespace ribbon

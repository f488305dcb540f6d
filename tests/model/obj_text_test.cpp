#include "model/obj_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "model/posed_model.h"
#include "result/refusal.h"

namespace ribbon::obj_text_test {

Model one_quad() {
  ModelObject quad{.name = "my ribbon",
                   .material = {"ribbon", {0.5F, 0.25F, 1}},
                   .positions = Eigen::Matrix3Xf(3, 4),
                   .uv = Eigen::Matrix2Xf(2, 4),
                   .faces = Eigen::MatrixXi(4, 1)};
  quad.positions << 0, 1, 1, 0,  //
      0.1F, 0.1F, 0.1F, 0.1F,    //
      0, 0, -2.5F, -2.5F;
  quad.uv << 0, 1, 1, 0,  //
      0, 0, 1, 1;
  quad.faces << 0, 1, 2, 3;
  ModelObject triangle{.name = "rock",
                       .material = {"obstacle", {1, 1, 1}},
                       .positions = Eigen::Matrix3Xf::Zero(3, 3),
                       .uv = Eigen::Matrix2Xf(2, 0),
                       .faces = Eigen::MatrixXi(3, 1)};
  triangle.faces << 2, 1, 0;
  return {.objects = {quad, triangle}, .frames_per_second = 50};
}

TEST(ObjText, a_quad_and_a_triangle_are_written_as_they_are) {
  EXPECT_EQ(obj_text(one_quad(), "knot.mtl"),
            "# ribbon: metres, y up\n"
            "mtllib knot.mtl\n"
            "o my ribbon\n"
            "v 0 0.1 0\n"
            "v 1 0.1 0\n"
            "v 1 0.1 -2.5\n"
            "v 0 0.1 -2.5\n"
            "vt 0 0\n"
            "vt 1 0\n"
            "vt 1 1\n"
            "vt 0 1\n"
            "usemtl ribbon\n"
            "f 1/1 2/2 3/3 4/4\n"
            "o rock\n"
            "v 0 0 0\n"
            "v 0 0 0\n"
            "v 0 0 0\n"
            "usemtl obstacle\n"
            "f 7 6 5\n");
}

TEST(ObjText, normals_stand_with_their_corners) {
  Model model = one_quad();
  for (ModelObject& object : model.objects)
    object.normals = Eigen::Vector3f::UnitY().replicate(1, object.positions.cols());
  const std::string text = obj_text(model, "knot.mtl");
  EXPECT_THAT(text, HasSubstr("vn 0 1 0\nusemtl ribbon\nf 1/1/1 2/2/2 3/3/3 4/4/4\n"));
  EXPECT_THAT(text, HasSubstr("f 7//7 6//6 5//5\n"));
}

TEST(ObjText, people_can_read_its_axes_and_unit) {
  Model model = one_quad();
  model.placement = {.up = UpAxis::z, .metres_per_unit = 0.01};
  EXPECT_THAT(obj_text(model, "knot.mtl"), StartsWith("# ribbon: units of 0.01 m, z up\n"));
}

TEST(ObjText, the_material_library_names_every_material) {
  EXPECT_EQ(material_library_text(one_quad()),
            "# ribbon\n"
            "newmtl ribbon\n"
            "Kd 0.5 0.25 1\n"
            "d 1\n"
            "illum 1\n"
            "newmtl obstacle\n"
            "Kd 1 1 1\n"
            "d 1\n"
            "illum 1\n");
}

// All `v` lines of a file, read by another way than they were written.
Eigen::Matrix3Xf vertices_of(const std::string& text) {
  std::vector<float> numbers;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("v ")) continue;
    const char* at = line.c_str() + 2;
    for (int axis = 0; axis < 3; ++axis) {
      char* after = nullptr;
      numbers.push_back(std::strtof(at, &after));
      at = after;
    }
  }
  return Eigen::Map<Eigen::Matrix3Xf>(numbers.data(), 3,
                                      static_cast<Eigen::Index>(numbers.size() / 3));
}

void expect_every_vertex_in_order(const SampleKnot& knot) {
  for (std::size_t frame = 0; frame < knot.frames.size(); ++frame) {
    const Eigen::Matrix3Xf vertices = vertices_of(obj_text(posed_model(knot, frame), "m.mtl"));
    ASSERT_EQ(vertices.cols(), 48 + 5) << "frame " << frame;
    EXPECT_EQ(vertices.leftCols(48), knot.frames[frame].cast<float>()) << "frame " << frame;
    EXPECT_EQ(vertices.rightCols(5), knot.header.obstacle->vertices) << "frame " << frame;
  }
}

TEST(ObjText, coincident_vertices_keep_their_number_and_order_in_every_frame) {
  expect_every_vertex_in_order(sample_knot());
}

TEST(ObjText, coordinates_a_kilometre_away_lose_no_digit) {
  expect_every_vertex_in_order(sample_knot({.along = 12, .across = 4}, {1000, 2000, -3000}));
}

TEST(ObjText, faces_are_the_same_in_every_frame) {
  const SampleKnot knot = sample_knot();
  const auto faces = [&](std::size_t frame) {
    const std::string text = obj_text(posed_model(knot, frame), "m.mtl");
    return text.substr(text.find("\nf "), text.find("\no small") - text.find("\nf "));
  };
  EXPECT_EQ(faces(0), faces(2));
  const std::string triangles = faces(0);
  EXPECT_EQ(std::count(triangles.begin(), triangles.end(), 'f'), 66);
}

TEST(MaterialLibrary, names_the_picture_that_lies_on_the_ribbon) {
  const std::string text =
      material_library_text(model_of_recording(sample_knot().header, textured()).value());
  EXPECT_THAT(text, HasSubstr("newmtl ribbon\nKd 1 1 1\nd 1\nillum 1\nmap_Kd knot.png\n"));
  EXPECT_EQ(text.find("map_Kd"), text.rfind("map_Kd")) << "the obstacle has none";
}

TEST(ObjText, faces_of_the_back_use_its_material) {
  const std::string text =
      obj_text(posed_model(knot_with_room(), 1, textured_on_both_sides()), "a.mtl");
  const std::size_t back = text.find("usemtl ribbon_back\nf ");
  ASSERT_NE(back, std::string::npos);
  EXPECT_LT(text.find("usemtl ribbon\nf "), back);
  EXPECT_EQ(std::count(text.begin() + static_cast<std::ptrdiff_t>(back), text.end(), 'f'), 66);
  EXPECT_THAT(material_library_text(
                  model_of_recording(knot_with_room().header, textured_on_both_sides()).value()),
              HasSubstr("newmtl ribbon_back\nKd 1 1 1\nd 1\nillum 1\nmap_Kd knot_back.png\n"));
}

}  // namespace ribbon::obj_text_test

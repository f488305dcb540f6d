#include "obstacle/obstacle.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <bit>
#include <cstdint>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "result/refusal.h"

namespace ribbon::obstacle_test {

std::filesystem::path written(const std::string& name, const std::string& text) {
  auto file = temporary_file(name);
  EXPECT_TRUE(write_file(file, text).has_value());
  return file;
}

ObstacleScene scene_of(const std::filesystem::path& file) {
  ObstacleScene scene;
  scene.file = {file};
  return scene;
}

TEST(Obstacle, is_scaled_then_placed) {
  ObstacleScene scene = scene_of(written("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n"));
  scene.scale = 0.5;
  scene.position_m = {10, 0, -1};
  const TriangleMesh mesh = read_obstacle(scene).value();
  EXPECT_EQ(mesh.name, "triangle");
  ASSERT_EQ(mesh.triangles.cols(), 1);
  Eigen::Matrix3f corners;
  for (int c = 0; c < 3; ++c) corners.col(c) = mesh.vertices.col(mesh.triangles(c, 0));
  Eigen::Matrix3f expected;
  expected << 10, 10.5, 10, 0, 0, 1, -1, -1, -1;
  EXPECT_EQ(corners, expected);
}

TEST(Obstacle, corners_that_differ_only_in_uv_or_normal_are_joined) {
  const auto file = written("seam.obj",
                            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0\n"
                            "f 1/1 2/2 3/3\nf 1/4 3/2 4/1\n");
  EXPECT_EQ(read_obstacle(scene_of(file)).value().vertices.cols(), 4);
}

TEST(Obstacle, what_may_never_end_is_not_read) {
  const auto pipe = temporary_file("pipe.obj");
  std::filesystem::remove(pipe);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const auto& file : {std::filesystem::path("/dev/zero"), pipe})
    EXPECT_THAT(refusal_of(read_obstacle(scene_of(file))),
                HasSubstr("is a device or a pipe, which may never end; name a file"));
  std::filesystem::remove(pipe);
}

TEST(Obstacle, polygons_become_triangles_and_several_objects_one_mesh) {
  const auto file = written("two.obj",
                            "o square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
                            "o triangle\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\n");
  const TriangleMesh mesh = read_obstacle(scene_of(file)).value();
  EXPECT_EQ(mesh.triangles.cols(), 3);
  EXPECT_EQ(mesh.vertices.cols(), 7);
  EXPECT_LT(mesh.triangles.maxCoeff(), 7);
}

TEST(Obstacle, other_formats_are_read_too) {
  const auto file = written("triangle.stl",
                            "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 0 1 0\nendloop\nendfacet\nendsolid t\n");
  EXPECT_EQ(read_obstacle(scene_of(file)).value().triangles.cols(), 1);
}

TEST(Obstacle, what_cannot_be_read_is_told_with_its_place_in_the_scene) {
  const auto problem_of = [](const std::filesystem::path& file) {
    ObstacleScene scene = scene_of(file);
    scene.file.place = "knot.toml:12:8";
    const auto mesh = read_obstacle(scene);
    return mesh ? "none" : mesh.error().place + ": " + mesh.error().problem;
  };
  const auto in_folder = [](const std::string& name) {
    return "knot.toml:12:8: '" + temporary_file(name).string() + "' ";
  };
  EXPECT_EQ(problem_of("/no/such/mesh.obj"), "knot.toml:12:8: '/no/such/mesh.obj' does not exist");
  EXPECT_EQ(problem_of("/usr"), "knot.toml:12:8: '/usr' is a folder");
  for (const std::string name : {"points.obj", "points.ply"})
    EXPECT_EQ(problem_of(written(name, "v 0 0 0\nv 1 0 0\n")),
              in_folder(name) + "gives no triangles: it is damaged, of another kind than " +
                  name.substr(6) +
                  ", holds nothing but points and lines, or is written in a way that is not read");
  EXPECT_EQ(problem_of(written("letter.txt", "Dear Sir\n")),
            in_folder("letter.txt") + "is no kind of mesh file that can be read");
  EXPECT_EQ(read_obstacle(scene_of("/no/such/mesh.obj")).error().place, "/no/such/mesh.obj");
}

// A triangle of single-precision floats and its glTF, which names their file so.
std::filesystem::path triangle_gltf(const std::string& folder, const std::string& uri) {
  return written(folder + "/triangle.gltf",
                 R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
"min": [0, 0, 0], "max": [1, 1, 0]}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": ")" +
                     uri + R"("}]})");
}

TEST(Obstacle, names_that_a_gltf_encodes_are_those_of_files) {
  const std::array<float, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::string bytes(reinterpret_cast<const char*>(corners.data()), sizeof(corners));
  written("a%20b/its data.bin", bytes);
  written("a%20b/100%.bin", bytes);
  written("a%20b/%41.bin", bytes);
  for (const std::string uri : {"its data.bin", "its%20data.bin", "100%25.bin", "%41.bin"})
    EXPECT_TRUE(read_obstacle(scene_of(triangle_gltf("a%20b", uri))).has_value()) << uri;
}

TEST(Obstacle, a_file_that_a_gltf_needs_is_named_where_it_is_missing) {
  EXPECT_THAT(
      refusal_of(read_obstacle(scene_of(triangle_gltf("alone", "its%20data.bin")))),
      HasSubstr("alone/triangle.gltf: needs '" + temporary_file("alone/its data.bin").string() +
                "', which cannot be opened; put that there"));
}

// Where assimp reads one triangle of the four, and no error.
TEST(Obstacle, triangle_strips_are_refused) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\n";
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
  EXPECT_THAT(
      refusal_of(read_obstacle(scene_of(written(
          "strip.ply", head + "element tristrips 1\nproperty list int int vertex_indices\n" +
                           "end_header\n" + vertices + "6 0 1 2 3 4 5\n")))),
      HasSubstr("strip.ply: holds triangle strips, which are not read; export"));
  const auto triangle = read_obstacle(
      scene_of(written("face.ply", head +
                                       "comment element tristrips 1\nelement face 1\n"
                                       "property list uchar int vertex_indices\nend_header\n" +
                                       vertices + "3 0 1 2\n")));
  ASSERT_TRUE(triangle.has_value()) << triangle.error().sentence();
  EXPECT_EQ(triangle->triangles.cols(), 1);
}

// As one coordinate of 256 does.
TEST(Obstacle, binary_ply_that_begins_with_the_byte_of_a_line_end_is_refused_without_blame) {
  const auto ply_from = [](std::uint32_t first_bits) {
    const std::array<float, 9> corners{std::bit_cast<float>(first_bits), 0, 0, 1, 0, 0, 0, 1, 0};
    const std::array<std::int32_t, 3> triangle{0, 1, 2};
    return "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty "
           "float y\nproperty float z\n"
           "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
           std::string(reinterpret_cast<const char*>(corners.data()), sizeof(corners)) + '\3' +
           std::string(reinterpret_cast<const char*>(triangle.data()), sizeof(triangle));
  };
  EXPECT_THAT(refusal_of(read_obstacle(scene_of(written("unlucky.ply", ply_from(0x3CA3D70A))))),
              HasSubstr("unlucky.ply: holds binary data that happen to begin with"));
  EXPECT_TRUE(read_obstacle(scene_of(written("lucky.ply", ply_from(0x3CA3D70B)))).has_value());
}

const std::string ply_cut_off =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_hea";

TEST(Obstacle, a_ply_that_is_cut_off_in_its_header_is_told_at_once) {
  for (const std::string rest : {"", "der", "der0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"})
    EXPECT_THAT(refusal_of(read_obstacle(scene_of(written("cut.ply", ply_cut_off + rest)))),
                HasSubstr("cut.ply: is cut off: its header has no end; export"));
}

TEST(Obstacle, a_ply_may_end_its_lines_in_any_way) {
  const std::string whole = ply_cut_off + "der\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  for (const std::string end : {"\n", "\r\n", " \n"}) {
    std::string text;
    for (const char c : whole) text += c == '\n' ? end : std::string(1, c);
    const auto mesh = read_obstacle(scene_of(written("lines.ply", text)));
    ASSERT_TRUE(mesh.has_value()) << mesh.error().sentence();
    EXPECT_EQ(mesh->triangles.cols(), 2);
  }
}

// What fuzzing found: the first makes assimp 5.2 read at the end of the file for ever, the second
// makes it abort.
TEST(Obstacle, files_on_which_their_reader_hangs_or_crashes_are_refused_with_a_sentence) {
  // Longer than what is looked at.
  std::string cut = ply_cut_off;
  cut.insert(cut.find("element vertex"), "comment " + std::string(70'000, 'x') + "\n");
  const std::string without_y =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\npro\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\x14"
      "4 0 1 2 3\n";
  for (const std::string& text : {cut, without_y})
    EXPECT_THAT(refusal_of(read_obstacle(scene_of(written("broken.ply", text)))),
                testing::HasSubstr("gives no triangles: it is damaged"));
}

TEST(Obstacle, triangles_without_area_duplicates_and_inverted_ones_are_kept) {
  const auto file = written("bad.obj",
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.5 0 0\nv 7 7 7\n"
                            "f 1 2 3\nf 1 2 3\nf 3 2 1\nf 1 4 2\nf 1 2 2\nf 3 3 3\n");
  const TriangleMesh mesh = read_obstacle(scene_of(file)).value();
  EXPECT_EQ(mesh.triangles.cols(), 6);
  EXPECT_TRUE((mesh.vertices.array() < 2).all());  // the vertex without a triangle is gone
}

TEST(Obstacle, a_coordinate_that_is_no_number_is_told_with_its_triangle) {
  EXPECT_THAT(refusal_of(read_obstacle(scene_of(
                  written("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 nan 1\nf 1 2 3\nf 1 2 4\n")))),
              HasSubstr("nan.obj: has a coordinate in triangle 2 of 2"));
}

// Who joins vertices by comparing their places takes one of these for another vertex.
TEST(Obstacle, a_coordinate_that_is_no_number_is_found_in_any_vertex) {
  for (const std::string wrong : {"nan 1 0", "0 nan 0", "0 1 nan", "inf 1 0"})
    for (std::size_t vertex = 0; vertex < 5; ++vertex) {
      std::array<std::string, 5> places{"0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 0 1"};
      places[vertex] = wrong;
      std::string text;
      for (const std::string& place : places) text += "v " + place + "\n";
      text += "v 1 0 1\nf 1 2 3 4\nf 1 2 6 5\n";
      EXPECT_THAT(refusal_of(read_obstacle(scene_of(written("nan.obj", text)))),
                  HasSubstr("nan.obj: has a coordinate in triangle"))
          << wrong << " as vertex " << vertex + 1;
    }
}

TEST(Obstacle, coordinates_beyond_single_precision_are_refused) {
  ObstacleScene scene = scene_of(written("large.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  scene.scale = 1e39;
  EXPECT_FALSE(read_obstacle(scene).has_value());
}

}  // namespace ribbon::obstacle_test

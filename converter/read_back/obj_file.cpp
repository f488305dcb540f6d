#include "converter/read_back/obj_file.h"

#include <tiny_obj_loader.h>

#include <fstream>
#include <string>

namespace ribbon {

namespace {

// One object as it grows; numbers are counted through the whole file, from 1.
struct GrowingMesh {
  int first_vertex = 1;
  int first_uv = 1;
  std::vector<double> positions = {};
  std::vector<double> uv = {};
  std::vector<int> corners = {};
  int corners_of_a_face = 0;
};

// What the loader finds, line by line.
struct Objects {
  std::vector<GrowingMesh> meshes;
  int vertices = 0;
  int uvs = 0;
  const char* problem = nullptr;  // nothing may be thrown through the loader

  GrowingMesh* last() {
    if (meshes.empty()) problem = "a line that belongs to no object";
    return meshes.empty() ? nullptr : &meshes.back();
  }

  void add_object() { meshes.push_back({.first_vertex = vertices + 1, .first_uv = uvs + 1}); }

  void add_vertex(double x, double y, double z) {
    ++vertices;
    if (GrowingMesh* mesh = last()) mesh->positions.insert(mesh->positions.end(), {x, y, z});
  }

  void add_uv(double u, double v) {
    ++uvs;
    if (GrowingMesh* mesh = last()) mesh->uv.insert(mesh->uv.end(), {u, v});
  }

  void add_face(const tinyobj::index_t* corners, int count) {
    GrowingMesh* mesh = last();
    if (mesh == nullptr) return;
    if (mesh->corners_of_a_face == 0) mesh->corners_of_a_face = count;
    if (count != mesh->corners_of_a_face) problem = "faces with different numbers of corners";
    for (int i = 0; i < count; ++i) {
      const int corner = corners[i].vertex_index - mesh->first_vertex;
      mesh->corners.push_back(corner);
      if (!mesh->uv.empty() && corners[i].texcoord_index - mesh->first_uv != corner)
        problem = "a corner with the uv of another vertex";
    }
  }
};

Objects& objects(void* user_data) {
  return *static_cast<Objects*>(user_data);
}

tinyobj::callback_t callbacks() {
  using tinyobj::real_t;
  tinyobj::callback_t callbacks;
  callbacks.object_cb = [](void* data, const char*) { objects(data).add_object(); };
  callbacks.vertex_cb = [](void* data, real_t x, real_t y, real_t z, real_t) {
    objects(data).add_vertex(x, y, z);
  };
  callbacks.texcoord_cb = [](void* data, real_t u, real_t v, real_t) {
    objects(data).add_uv(u, v);
  };
  callbacks.index_cb = [](void* data, tinyobj::index_t* corners, int count) {
    objects(data).add_face(corners, count);
  };
  return callbacks;
}

template <class Numbers>
auto columns_of(const Numbers& numbers, Eigen::Index rows) {
  using Number = typename Numbers::value_type;
  const auto columns = rows == 0 ? 0 : static_cast<Eigen::Index>(numbers.size()) / rows;
  return Eigen::MatrixX<Number>(
      Eigen::Map<const Eigen::MatrixX<Number>>(numbers.data(), rows, columns));
}

WrittenMesh finished(const GrowingMesh& mesh) {
  return {.positions = columns_of(mesh.positions, 3),
          .uv = columns_of(mesh.uv, 2),
          .faces = columns_of(mesh.corners, mesh.corners_of_a_face)};
}

class ObjFile : public WrittenMotion {
 public:
  explicit ObjFile(const Objects& objects) {
    for (const GrowingMesh& mesh : objects.meshes) scene_.meshes.push_back(finished(mesh));
  }
  Eigen::Matrix3Xd ribbon(int) override { return scene_.meshes.front().positions; }
};

}  // namespace

std::unique_ptr<WrittenMotion> read_obj(const std::filesystem::path& path) {
  std::ifstream lines(path);
  demand(lines.is_open(), "cannot be opened");
  Objects objects;
  std::string problem;
  const bool read =
      tinyobj::LoadObjWithCallback(lines, callbacks(), &objects, nullptr, nullptr, &problem);
  if (!read) throw Spoiled("tinyobjloader says: " + problem);
  demand(!lines.bad(), "the disk does not give its bytes");
  demand(objects.problem == nullptr, objects.problem);
  demand(!objects.meshes.empty(), "it has no object");
  return std::make_unique<ObjFile>(objects);
}

}  // namespace ribbon

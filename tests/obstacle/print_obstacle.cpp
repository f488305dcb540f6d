// Prints the obstacle that a file gives as an OBJ: print_obstacle FILE
#include <cstdio>

#include "obstacle/obstacle.h"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  ribbon::ObstacleScene scene;
  scene.file.path = arguments[1];
  const auto mesh = ribbon::read_obstacle(scene);
  if (!mesh) {
    std::fprintf(stderr, "%s\n", mesh.error().sentence().c_str());
    return 2;
  }
  const Eigen::Matrix3Xd vertices = mesh->vertices.cast<double>();
  for (const auto& vertex : vertices.colwise())
    std::printf("v %.9g %.9g %.9g\n", vertex.x(), vertex.y(), vertex.z());
  for (const auto& triangle : mesh->triangles.colwise())
    std::printf("f %d %d %d\n", triangle.x() + 1, triangle.y() + 1, triangle.z() + 1);
  return 0;
}

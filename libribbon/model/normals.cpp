#include "model/normals.h"

#include <Eigen/Geometry>

namespace ribbon {

Eigen::Matrix3Xf vertex_normals(const Eigen::Matrix3Xf& positions, const Eigen::MatrixXi& faces,
                                const Eigen::Vector3f& otherwise) {
  const Eigen::Matrix3Xd points = positions.cast<double>();
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, points.cols());
  for (const auto& face : faces.colwise())
    for (Eigen::Index last = 2; last < face.size(); ++last) {
      const Eigen::Vector3d corner = points.col(face[0]);
      const Eigen::Vector3d area =
          (points.col(face[last - 1]) - corner).cross(points.col(face[last]) - corner);
      for (const Eigen::Index k : {Eigen::Index{0}, last - 1, last}) sums.col(face[k]) += area;
    }
  Eigen::Matrix3Xf normals(3, sums.cols());
  for (Eigen::Index vertex = 0; vertex < sums.cols(); ++vertex) {
    const double length = sums.col(vertex).stableNorm();
    if (length > 0)
      normals.col(vertex) = (sums.col(vertex) / length).cast<float>();
    else
      normals.col(vertex) = otherwise;
  }
  return normals;
}

}  // namespace ribbon

// Sums over the components of short vectors in an order that is written here. Eigen's own depends
// on whether it adds by vector instructions, and by how wide ones.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace ribbon {

// Of 2, 3 or 4 components: the first two, then the third; of four, those that are two apart first.
template <class A, class B>
double dot(const Eigen::MatrixBase<A>& first, const Eigen::MatrixBase<B>& second) {
  constexpr int size = A::SizeAtCompileTime;
  static_assert(size == B::SizeAtCompileTime && size >= 2 && size <= 4);
  const A& a = first.derived();
  const B& b = second.derived();
  if constexpr (size == 2) return a.x() * b.x() + a.y() * b.y();
  if constexpr (size == 3) return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
  if constexpr (size == 4) return (a.x() * b.x() + a.z() * b.z()) + (a.y() * b.y() + a.w() * b.w());
}

template <class A>
double squared_length_of(const Eigen::MatrixBase<A>& vector) {
  return dot(vector, vector);
}

template <class A>
double length_of(const Eigen::MatrixBase<A>& vector) {
  return std::sqrt(squared_length_of(vector));
}

// Of length 1; as it is where it has no length.
template <class A>
typename A::PlainObject normalised(const Eigen::MatrixBase<A>& vector) {
  typename A::PlainObject v = vector;
  const double squared = squared_length_of(v);
  if (!(squared > 0)) return v;
  return v / std::sqrt(squared);
}

// Likewise, also of vectors whose squares are too small or too large to be numbers.
template <class A>
typename A::PlainObject safely_normalised(const Eigen::MatrixBase<A>& vector) {
  typename A::PlainObject v = vector;
  const double largest = v.cwiseAbs().maxCoeff();
  const typename A::PlainObject scaled = v / largest;
  const double squared = squared_length_of(scaled);
  if (!(squared > 0)) return v;
  return v / (std::sqrt(squared) * largest);
}

// Of four columns, each times its weight, added from the first to the last.
inline Eigen::Vector3d weighted_sum(const Eigen::Matrix<double, 3, 4>& columns,
                                    const Eigen::Vector4d& weights) {
  Eigen::Vector3d sum = weights[0] * columns.col(0);
  for (int k = 1; k < 4; ++k) sum += weights[k] * columns.col(k);
  return sum;
}

// Along a direction, of each of four columns.
inline Eigen::Vector4d heights(const Eigen::Matrix<double, 3, 4>& columns,
                               const Eigen::Vector3d& direction) {
  return {dot(columns.col(0), direction), dot(columns.col(1), direction),
          dot(columns.col(2), direction), dot(columns.col(3), direction)};
}

// Of 3 x any columns, at least one, added from the first to the last.
template <class A>
Eigen::Vector3d mean_of_columns(const Eigen::MatrixBase<A>& columns) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < columns.cols(); ++i) sum += columns.col(i);
  return sum / static_cast<double>(columns.cols());
}

}  // namespace ribbon

#include "simulation/spring_metric.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cassert>

namespace ribbon {

namespace {

using Eigen::MatrixX3d;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

// Of the largest diagonal element: the factor could not tell less from rounding.
constexpr double least_inertia = 1e-12;

// Up to this width the numbering of the particles, row by row, is the best order: no other makes
// the factor much smaller, and its elements follow each other.
constexpr int narrow = 32;

int widest(const SpringSet& set) {
  int most = 0;
  for (const Spring& spring : set.springs) most = std::max(most, std::abs(spring.b - spring.a));
  return most;
}

int width_of_band(const SpringNetwork& network) {
  return std::max({widest(network.stretch), widest(network.shear), widest(network.bend)});
}

// Below and on the diagonal.
SparseMatrix stiffness(const SpringNetwork& network, int particle_count) {
  std::vector<Eigen::Triplet<double>> elements;
  for (const SpringSet* set : {&network.stretch, &network.shear, &network.bend})
    for (const Spring& spring : set->springs) {
      const auto [first, last] = std::minmax(spring.a, spring.b);
      elements.emplace_back(first, first, set->resistance);
      elements.emplace_back(last, last, set->resistance);
      elements.emplace_back(last, first, -set->resistance);
    }
  SparseMatrix matrix(particle_count, particle_count);
  matrix.setFromTriplets(elements.begin(), elements.end());
  return matrix;
}

SparseMatrix metric(const SpringNetwork& network, int particle_count, double inertia) {
  SparseMatrix matrix = stiffness(network, particle_count);
  const double most = VectorXd(matrix.diagonal()).maxCoeff();
  SparseMatrix identity(particle_count, particle_count);
  identity.setIdentity();
  return matrix + std::max(inertia, least_inertia * most) * identity;
}

struct Factor {
  SparseMatrix lower;
  std::vector<int> particle;  // of each column
};

template <class Order>
Factor factor(const SparseMatrix& matrix) {
  const Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Order> factored(matrix);
  assert(factored.info() == Eigen::Success);
  Factor result{factored.matrixL().nestedExpression(), {}};
  result.particle.resize(static_cast<std::size_t>(matrix.cols()));
  const auto& place = factored.permutationP().indices();
  for (int particle = 0; particle < static_cast<int>(matrix.cols()); ++particle)
    result.particle[static_cast<std::size_t>(place.size() > 0 ? place[particle] : particle)] =
        particle;
  return result;
}

}  // namespace

SpringMetric::SpringMetric(const SpringNetwork& network, int particle_count, double inertia)
    : solution_(static_cast<std::size_t>(particle_count), Row::Zero()) {
  const SparseMatrix matrix = metric(network, particle_count, inertia);
  Factor factored = width_of_band(network) <= narrow ? factor<Eigen::NaturalOrdering<int>>(matrix)
                                                     : factor<Eigen::AMDOrdering<int>>(matrix);
  particle_ = std::move(factored.particle);
  begin_.push_back(0);
  for (int column = 0; column < particle_count; ++column) {
    for (SparseMatrix::InnerIterator element(factored.lower, column); element; ++element) {
      if (element.row() == column) {
        inverse_diagonal_.push_back(1 / element.value());
      } else {
        row_.push_back(static_cast<int>(element.row()));
        value_.push_back(element.value());
      }
    }
    begin_.push_back(row_.size());
  }
}

void SpringMetric::solve(const MatrixX3d& force, MatrixX3d& displacement) {
  const std::size_t count = solution_.size();
  for (std::size_t i = 0; i < count; ++i)
    solution_[i].head<3>() = force.row(particle_[i]).transpose().array();
  for (std::size_t column = 0; column < count; ++column) {
    const Row value = solution_[column] *= inverse_diagonal_[column];
    for (std::size_t k = begin_[column]; k < begin_[column + 1]; ++k)
      solution_[static_cast<std::size_t>(row_[k])] -= value_[k] * value;
  }
  for (std::size_t column = count; column-- > 0;) {
    Row value = solution_[column];
    for (std::size_t k = begin_[column]; k < begin_[column + 1]; ++k)
      value -= value_[k] * solution_[static_cast<std::size_t>(row_[k])];
    solution_[column] = value * inverse_diagonal_[column];
  }
  displacement.resize(force.rows(), 3);
  for (std::size_t i = 0; i < count; ++i)
    displacement.row(particle_[i]) = solution_[i].head<3>().matrix().transpose();
}

}  // namespace ribbon

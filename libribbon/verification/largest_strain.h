// How far is the cloth stretched?
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/limited_edges.h"
#include "geometry/rest_size.h"

namespace ribbon {

// The edge whose length differs most from its rest length.
struct LargestStrain {
  double strain = 0;  // |length / rest length - 1|
  int first = 0;      // the particles that it joins
  int second = 0;
};

// Of a ribbon of that size, as far as its edges are limited; 0 where none is. positions:
// 3 x particles.
LargestStrain largest_strain(const RestSize& rest, const LimitedEdges& limited,
                             const Eigen::Matrix3Xf& positions);

// Of each particle: the strain of that of its limited edges which is strained most; 0 where none of
// them is limited.
std::vector<float> particle_strains(const RestSize& rest, const LimitedEdges& limited,
                                    const Eigen::Matrix3Xf& positions);

}  // namespace ribbon

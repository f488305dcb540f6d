// What can collide: the ribbon and, where the scene has one, the obstacle.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <utility>

#include "geometry/ribbon_grid.h"
#include "simulation/collision_surface.h"
#include "simulation/feature_boxes.h"
#include "simulation/hierarchy.h"
#include "simulation/vertex_ranges.h"

namespace ribbon {

// A surface with the hierarchy over it and the boxes of its features.
struct Body {
  Body(CollisionSurface body_surface, const Eigen::Matrix3Xd& positions)
      : surface(std::move(body_surface)), hierarchy(surface, positions) {
    boxes.refit(surface, vertex_ranges(positions, positions));
  }

  // To the ranges of the vertices (one for each vertex of all bodies); the boxes of the hierarchy
  // are grown by margin_m.
  void refit(std::span<const Box> ranges, double margin_m) {
    hierarchy.refit(ranges, margin_m);
    boxes.refit(surface, ranges);
  }

  CollisionSurface surface;
  Hierarchy hierarchy;
  FeatureBoxes boxes;
};

struct Bodies {
  RibbonGrid grid;
  Body ribbon;
  std::optional<Body> obstacle;
};

}  // namespace ribbon

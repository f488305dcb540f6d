// What detections are compared by. Two programs are made of one source: one is linked with time,
// one with boxes that count.
#pragma once

#include <functional>
#include <string>

namespace benchmark {

// "time_s" or "box_tests", and how a table shows it: "ms" or "tests", of so many to one.
struct CostUnit {
  std::string name;
  std::string shown;
  double shown_per_unit = 1;
};
CostUnit cost_unit();

// Of one detection: seconds, or how many times a box (of triangles, edges, vertices or regions) is
// tested against another.
double cost_of(const std::function<void()>& detect);

}  // namespace benchmark

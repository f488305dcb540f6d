// What a run's numbers tell over time, one chart for each.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "recording/records/recording.h"

namespace ribbon {

// Between two values, drawn behind the line; where both are the same, a border.
struct ChartZone {
  double low = 0;
  double high = 0;
  std::string name;
};

struct Chart {
  std::string title;  // what is told, and its unit
  // Time in seconds and value, point by point. Where a frame is lost the line is broken.
  std::vector<std::vector<Eigen::Vector2d>> lines;
  std::optional<ChartZone> zone;
  // Higher values set no scale: there the line leaves the plot.
  double most_shown = std::numeric_limits<double>::infinity();
  bool counts = false;  // values are whole numbers
};

// Of the frames' numbers in their order; nothing stands for a lost frame. How tight the ribbon is
// is left out where no frame tells it.
std::vector<Chart> time_charts(const RecordingHeader& header,
                               const std::vector<std::optional<FrameNumbers>>& frames);

}  // namespace ribbon

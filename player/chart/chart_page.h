// Charts on one page, for a document or a screen.
#pragma once

#include <string>
#include <vector>

#include "player/chart/chart_drawing.h"
#include "player/chart/time_charts.h"

namespace ribbon {

// At least one chart; all have the same time axis.
ChartDrawing chart_page(const std::string& title, const std::string& subtitle,
                        const std::vector<Chart>& charts);

}  // namespace ribbon

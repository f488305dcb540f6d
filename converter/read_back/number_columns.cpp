#include "converter/read_back/number_columns.h"

#include <algorithm>
#include <limits>

#include "converter/read_back/written_motion.h"

namespace ribbon {

Eigen::MatrixXd columns(const std::vector<double>& numbers, Eigen::Index rows) {
  const auto count = static_cast<Eigen::Index>(numbers.size());
  demand(count % rows == 0, "half a tuple");
  return Eigen::Map<const Eigen::MatrixXd>(numbers.data(), rows, count / rows);
}

Eigen::MatrixXi whole_columns(const std::vector<double>& numbers, Eigen::Index rows) {
  using Limits = std::numeric_limits<int>;
  demand(std::ranges::all_of(numbers,
                             [](double n) { return n >= Limits::min() && n <= Limits::max(); }),
         "an index that nothing can have");
  return columns(numbers, rows).cast<int>();
}

}  // namespace ribbon

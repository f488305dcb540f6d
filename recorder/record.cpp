#include "recorder/record.h"

#include "obstacle/obstacle.h"
#include "recorder/run/record_around.h"

namespace ribbon {

Result<RunStatistics> record(const Scene& scene, const NewRecording& recording,
                             const RunObserver& observer, const RunLimit& limit) {
  const auto obstacle = read_obstacle(scene);
  if (!obstacle) return tl::unexpected(obstacle.error());
  return record_around(*obstacle, scene, recording, observer, limit);
}

}  // namespace ribbon

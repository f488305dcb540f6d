// The rays of a picture, kept so that they can be traced again and nothing else.
#pragma once

#include <mutex>
#include <vector>

#include "player/render/ray_batch.h"

namespace ribbon {

// What is asked about rays, and how near each other they start and go.
enum class RayQuestion { first_hit_similar, first_hit_mixed, free_similar, free_mixed };

struct LoggedRays {
  RayQuestion question;
  RayBatch rays;
};

// Safe to call from several threads. Takes 6 kB for 256 rays.
class RayLog {
 public:
  void add(RayQuestion question, const RayBatch& rays) {
    if (rays.count == 0) return;
    const std::lock_guard lock(mutex_);
    batches_.push_back({question, rays});
  }
  [[nodiscard]] const std::vector<LoggedRays>& batches() const { return batches_; }

 private:
  std::mutex mutex_;
  std::vector<LoggedRays> batches_;
};

}  // namespace ribbon

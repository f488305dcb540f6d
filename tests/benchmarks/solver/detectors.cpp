// The one place that knows how the product detects: what changes there is followed here.
#include "benchmarks/solver/detector.h"
#include "benchmarks/solver/space_enumeration.h"
#include "simulation/detection/bodies.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

namespace {

class BodyDetector : public Detector {
 public:
  explicit BodyDetector(const RibbonMotion& motion)
      : motion_(motion), bodies_{motion.grid, std::nullopt} {}

 protected:
  [[nodiscard]] const RibbonMotion& motion() const { return motion_; }
  Bodies& bodies() { return bodies_; }

 private:
  const RibbonMotion& motion_;
  Bodies bodies_;
};

// Tests triangles by their own means; the features of the triangles that meet are listed as the
// product does.
class ByTriangles : public BodyDetector {
 public:
  using BodyDetector::BodyDetector;

  std::vector<FeaturePair> detect() final {
    RibbonBody& body = bodies().ribbon;
    const std::vector<MovingBox> ranges = vertex_ranges(motion().t0, motion().t1);
    std::vector<MovingBox> grown;
    for (const auto& triangle : body.surface().triangles.colwise()) {
      grown.push_back(ranges[triangle[0]]);
      grown.back().include(ranges[triangle[1]]);
      grown.back().include(ranges[triangle[2]]);
      grown.back().grow(motion().margin_m / 2);
    }
    const RangedSurface surface{body.surface(), ranges};
    return feature_pairs(surface, surface, pairs(grown), motion().margin_m);
  }

 protected:
  virtual std::vector<CandidatePair> pairs(const std::vector<MovingBox>& boxes) = 0;
};

class BruteForce : public ByTriangles {
 public:
  using ByTriangles::ByTriangles;

 protected:
  std::vector<CandidatePair> pairs(const std::vector<MovingBox>& boxes) override {
    std::vector<CandidatePair> found;
    for (std::size_t a = 0; a < boxes.size(); ++a)
      for (std::size_t b = a + 1; b < boxes.size(); ++b)
        if (boxes[a].meets(boxes[b])) found.push_back({static_cast<int>(a), static_cast<int>(b)});
    return found;
  }
};

class SpaceEnumeration : public ByTriangles {
 public:
  SpaceEnumeration(const RibbonMotion& motion, double cell_factor)
      : ByTriangles(motion), cell_factor_(cell_factor) {}

 protected:
  // Cells hold what reaches into them at any time of the step.
  std::vector<CandidatePair> pairs(const std::vector<MovingBox>& boxes) override {
    double sizes_m = 0;
    std::vector<Box> swept;
    for (const MovingBox& box : boxes) {
      swept.push_back(box.start);
      swept.back().include(box.end);
      sizes_m += (swept.back().high - swept.back().low).maxCoeff();
    }
    return pairs_by_cells(swept, cell_factor_ * sizes_m / static_cast<double>(boxes.size()));
  }

 private:
  double cell_factor_;
};

class ByCurvature : public BodyDetector {
 public:
  using BodyDetector::BodyDetector;

  std::vector<FeaturePair> detect() override {
    return swept_pairs_by_curvature(bodies(), motion().t0, motion().t1, motion().margin_m);
  }
};

class ByBoxes : public BodyDetector {
 public:
  using BodyDetector::BodyDetector;

  std::vector<FeaturePair> detect() override {
    RibbonBody& body = bodies().ribbon;
    const std::vector<MovingBox> ranges = vertex_ranges(motion().t0, motion().t1);
    TriangleBvh& bvh = body.triangle_bvh(motion().t0);
    bvh.refit(ranges, motion().margin_m / 2);
    const RangedSurface surface{body.surface(), ranges};
    return feature_pairs(surface, surface, bvh.pairs_within(TriangleBvh::Spare::boxes),
                         motion().margin_m);
  }
};

class ByPatches : public BodyDetector {
 public:
  using BodyDetector::BodyDetector;

  std::vector<FeaturePair> detect() override {
    return pairs_within_ranges(bodies(), vertex_ranges(motion().t0, motion().t1),
                               motion().margin_m);
  }
};

}  // namespace

std::unique_ptr<Detector> make_detector(DetectionMethod method, const RibbonMotion& motion,
                                        double cell_factor) {
  switch (method) {
    case DetectionMethod::brute_force:
      return std::make_unique<BruteForce>(motion);
    case DetectionMethod::space_enumeration:
      return std::make_unique<SpaceEnumeration>(motion, cell_factor);
    case DetectionMethod::curvature:
      return std::make_unique<ByCurvature>(motion);
    case DetectionMethod::boxes:
      return std::make_unique<ByBoxes>(motion);
    case DetectionMethod::patches:
      return std::make_unique<ByPatches>(motion);
  }
  return nullptr;
}

}  // namespace ribbon

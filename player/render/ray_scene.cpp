#include "player/render/ray_scene.h"

#include <embree3/rtcore.h>
#include <pmmintrin.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <mutex>
#include <new>
#include <string>
#include <vector>

#include "parallel/instruction_set.h"
#include "parallel/parallel.h"
#include "parallel/vector_loop.h"
#include "player/render/thread_timer.h"

namespace ribbon {

namespace {

// The packets in which rays are traced plainly.
constexpr std::size_t packet_size = 16;
using Valid = std::array<int, packet_size>;

struct DeviceRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, DeviceRelease>;
using Scene = std::unique_ptr<RTCSceneTy, SceneRelease>;

// Told, as different ones round differently: SSE and AVX alike, AVX2 and AVX-512 each on its own.
const char* configuration() {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return "isa=avx512";
    case InstructionSet::avx2:
      return "isa=avx2";
    case InstructionSet::baseline:
      break;
  }
  return "isa=sse2";
}

// Only a lack of memory is left to go wrong once the arguments are right.
void check(RTCDevice device) {
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::bad_alloc();
}

// Robust: no ray slips through between two triangles.
Scene new_scene(RTCDevice device, unsigned more_flags = RTC_SCENE_FLAG_NONE) {
  Scene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | more_flags));
  return scene;
}

// Embree reads corners where they lie, four numbers of each: what it has read is near the processor
// when the place that was met is looked up there.
RTCGeometry attach(const HitSurface& bodies, RTCDevice device, RTCScene scene) {
  const auto& corners = bodies.corners();
  const auto& triangles = bodies.triangles();
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, corners.data(),
                             0, sizeof corners[0], corners.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(),
                             0, sizeof triangles[0], triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);  // the scene keeps it
  return geometry;
}

// Lanes without a ray are switched off by `valid`, and repeat another one: where packets of 16 are
// not native, Embree looks at what it does not trace, and gives up where that is no ray.
void fill(const RayBatch& rays, std::size_t begin, RTCRay16& packet, Valid& valid) {
  const std::size_t used = std::min(packet_size, rays.count - begin);
  const auto copy = [begin, used](const Lanes<float>& lanes, float* to) {
    std::copy_n(lanes.begin() + static_cast<std::ptrdiff_t>(begin), used, to);
    std::fill_n(to + used, packet_size - used, lanes[begin]);
  };
  for (std::size_t i = 0; i < packet_size; ++i) valid[i] = begin + i < rays.count ? -1 : 0;
  copy(rays.origin.x, packet.org_x);
  copy(rays.origin.y, packet.org_y);
  copy(rays.origin.z, packet.org_z);
  copy(rays.direction.x, packet.dir_x);
  copy(rays.direction.y, packet.dir_y);
  copy(rays.direction.z, packet.dir_z);
  std::fill_n(packet.tnear, packet_size, 0.0F);
  std::fill_n(packet.tfar, packet_size, std::numeric_limits<float>::infinity());
  std::fill_n(packet.time, packet_size, 0.0F);
  std::fill_n(packet.mask, packet_size, ~0U);
  std::fill_n(packet.flags, packet_size, 0U);
}

// The rays as they lie, from their origin to without end; `reach` is filled and becomes shorter.
// Where a stream has no numbers Embree takes those of any ray: from its beginning, at no time, with
// no mask and no flags.
RTCRayNp stream_of(const RayBatch& rays, Lanes<float>& reach) {
  std::fill_n(reach.begin(), rays.count, std::numeric_limits<float>::infinity());
  // Embree only reads them, but does not say so.
  const auto numbers = [](const Lanes<float>& lanes) { return const_cast<float*>(lanes.data()); };
  return {numbers(rays.origin.x),
          numbers(rays.origin.y),
          numbers(rays.origin.z),
          nullptr,
          numbers(rays.direction.x),
          numbers(rays.direction.y),
          numbers(rays.direction.z),
          nullptr,
          reach.data(),
          nullptr,
          nullptr,
          nullptr};
}

RTCIntersectContext new_context(Coherence coherence) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherence == Coherence::similar) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

void clear_hits(RTCHit16& hit) {
  std::fill_n(hit.geomID, packet_size, RTC_INVALID_GEOMETRY_ID);
  std::fill_n(hit.instID[0], packet_size, RTC_INVALID_GEOMETRY_ID);
}

RayQuestion first_hit_question(Coherence coherence) {
  return coherence == Coherence::similar ? RayQuestion::first_hit_similar
                                         : RayQuestion::first_hit_mixed;
}

RayQuestion free_question(Coherence coherence) {
  return coherence == Coherence::similar ? RayQuestion::free_similar : RayQuestion::free_mixed;
}

// Filled packets of a batch.
class PlainPackets {
 public:
  explicit PlainPackets(const LoggedRays& logged) : question_(logged.question) {
    for (std::size_t begin = 0; begin < logged.rays.count; begin += packet_size) {
      fill(logged.rays, begin, packets_[count_].ray, valid_[count_]);
      clear_hits(packets_[count_++].hit);
    }
  }

  void trace(RTCScene scene) {
    const bool similar =
        question_ == RayQuestion::first_hit_similar || question_ == RayQuestion::free_similar;
    const bool first_hit =
        question_ == RayQuestion::first_hit_similar || question_ == RayQuestion::first_hit_mixed;
    RTCIntersectContext context = new_context(similar ? Coherence::similar : Coherence::mixed);
    for (std::size_t i = 0; i < count_; ++i) {
      if (first_hit)
        rtcIntersect16(valid_[i].data(), scene, &context, &packets_[i]);
      else
        rtcOccluded16(valid_[i].data(), scene, &context, &packets_[i].ray);
    }
  }

 private:
  RayQuestion question_;
  std::size_t count_ = 0;
  std::array<RTCRayHit16, batch_size / packet_size> packets_;
  alignas(64) std::array<Valid, batch_size / packet_size> valid_;
};

}  // namespace

// One tree over both bodies: to refit what does not move takes less than to join two trees anew,
// and rays go through one faster.
struct RayScene::State {
  State() {
    if (!device) throw std::bad_alloc();
    // Embree refits in dynamic scenes of that quality alone; the tree is built in its geometry's.
    // Compact leaves, which hold numbers of vertices instead of copies of them, would be renewed
    // sooner, but rays lose more than that.
    scene = new_scene(device.get(), RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_LOW);
    rtcCommitScene(scene.get());
  }
  Device device{rtcNewDevice(configuration())};
  Scene scene;
  RTCGeometry bodies = nullptr;  // the scene's, if it is there
  std::uint32_t ribbon_triangles = 0;
};

RayScene::RayScene() : state_(std::make_unique<State>()) {}
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

void RayScene::set_bodies(const HitSurface& bodies, std::uint32_t ribbon_triangles,
                          RibbonTree tree) {
  State& s = *state_;
  if (s.bodies == nullptr) {
    assert(tree == RibbonTree::rebuilt);
    s.bodies = attach(bodies, s.device.get(), s.scene.get());
    s.ribbon_triangles = ribbon_triangles;
  } else {
    rtcUpdateGeometryBuffer(s.bodies, RTC_BUFFER_TYPE_VERTEX, 0);
    // Embree builds anew what may have other triangles.
    if (tree == RibbonTree::rebuilt) rtcUpdateGeometryBuffer(s.bodies, RTC_BUFFER_TYPE_INDEX, 0);
    rtcCommitGeometry(s.bodies);
  }
  rtcCommitScene(s.scene.get());
  check(s.device.get());
}

void RayScene::first_hits(const RayBatch& rays, Coherence coherence, HitBatch& hits) const {
  if (log_ != nullptr) log_->add(first_hit_question(coherence), rays);
  RTCIntersectContext context = new_context(coherence);
  Lanes<unsigned> geometries;
  std::fill_n(geometries.begin(), rays.count, RTC_INVALID_GEOMETRY_ID);
  RTCRayHitNp stream{stream_of(rays, hits.distance),
                     {nullptr,  // nobody asks for facets' normals
                      nullptr,
                      nullptr,
                      hits.u.data(),
                      hits.v.data(),
                      hits.triangle.data(),
                      geometries.data(),
                      {nullptr}}};
  rtcIntersectNp(state_->scene.get(), &context, &stream, static_cast<unsigned>(rays.count));
  const std::uint32_t ribbon_triangles = state_->ribbon_triangles;
  vectorised([&]() RIBBON_INLINED {
    // Bytes that are stored may lie anywhere, as compilers see it.
    const unsigned* const met = geometries.data();
    const std::uint32_t* const triangle = hits.triangle.data();
    Body* const body = hits.body.data();
    const std::size_t end = filled_up(rays.count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      const Body is = triangle[i] < ribbon_triangles ? Body::ribbon : Body::obstacle;
      body[i] = met[i] == RTC_INVALID_GEOMETRY_ID ? Body::none : is;
    }
  });
}

void RayScene::unblocked(const RayBatch& rays, Coherence coherence, Lanes<float>& free) const {
  if (log_ != nullptr) log_->add(free_question(coherence), rays);
  RTCIntersectContext context = new_context(coherence);
  Lanes<float> reach;
  RTCRayNp stream = stream_of(rays, reach);
  rtcOccludedNp(state_->scene.get(), &context, &stream, static_cast<unsigned>(rays.count));
  // Embree marks a blocked ray by a negative length.
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(rays.count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) free[i] = reach[i] < 0 ? 0.0F : 1.0F;
  });
}

double RayScene::plain_seconds(const RayLog& log) const {
  // Built for all that there is at once, as Embree is used plainly.
  const State& s = *state_;
  Scene scene = new_scene(s.device.get());
  if (s.bodies != nullptr) rtcAttachGeometry(scene.get(), s.bodies);
  rtcCommitScene(scene.get());
  std::mutex mutex;
  double seconds = 0;
  parallel_ranges(log.batches().size(), 16, [&](std::size_t begin, std::size_t end) {
    const FlushDenormals fast;
    std::vector<PlainPackets> packets(log.batches().begin() + static_cast<std::ptrdiff_t>(begin),
                                      log.batches().begin() + static_cast<std::ptrdiff_t>(end));
    const ThreadTimer timer;
    for (PlainPackets& batch : packets) batch.trace(scene.get());
    const double own = timer.seconds();
    const std::lock_guard lock(mutex);
    seconds += own;
  });
  return seconds;
}

std::string ray_tracer_name() {
  const Device device{rtcNewDevice(configuration())};
  const auto version = [&](RTCDeviceProperty part) {
    return std::to_string(rtcGetDeviceProperty(device.get(), part));
  };
  return "Embree " + version(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." +
         version(RTC_DEVICE_PROPERTY_VERSION_MINOR) + "." +
         version(RTC_DEVICE_PROPERTY_VERSION_PATCH) + " with " +
         std::string(configuration()).substr(4);
}

FlushDenormals::FlushDenormals() : before_(_mm_getcsr()) {
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

FlushDenormals::~FlushDenormals() {
  _mm_setcsr(before_);
}

}  // namespace ribbon

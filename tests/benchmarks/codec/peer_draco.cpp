#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>

#include <cassert>
#include <cstring>
#include <numeric>

#include "benchmarks/codec/integer_codec.h"
#include "benchmarks/codec/peers.h"

namespace ribbon {

namespace {

// A point for each particle, with three integers.
void add_points(draco::PointCloud& cloud, int particles) {
  draco::GeometryAttribute attribute;
  attribute.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_INT32, false,
                 3 * sizeof(std::int32_t), 0);
  cloud.set_num_points(static_cast<std::uint32_t>(particles));
  cloud.AddAttribute(attribute, true, static_cast<std::uint32_t>(particles));
}

std::unique_ptr<draco::Mesh> mesh_of(const RibbonGrid& grid) {
  auto mesh = std::make_unique<draco::Mesh>();
  mesh->SetNumFaces(grid.triangle_count());
  for (int t = 0; t < grid.triangle_count(); ++t) {
    draco::Mesh::Face face;
    for (std::size_t corner = 0; corner < 3; ++corner)
      face[corner] = static_cast<std::uint32_t>(grid.triangle(t)[corner]);
    mesh->SetFace(draco::FaceIndex(static_cast<std::uint32_t>(t)), face);
  }
  add_points(*mesh, grid.particle_count());
  return mesh;
}

// How frames go through Draco: integers of one frame in and out, in the order of the particles.
class Geometry {
 public:
  Geometry() = default;
  Geometry(const Geometry&) = delete;
  Geometry& operator=(const Geometry&) = delete;
  virtual ~Geometry() = default;
  virtual void encode(std::span<const std::uint32_t> frame, draco::EncoderBuffer& bytes) = 0;
  virtual void decode(const draco::EncoderBuffer& bytes, std::span<std::uint32_t> frame) = 0;
};

void set_integers(draco::PointCloud& cloud, std::span<const std::uint32_t> frame) {
  std::memcpy(cloud.attribute(0)->buffer()->data(), frame.data(), frame.size_bytes());
}

draco::DecoderBuffer to_read(const draco::EncoderBuffer& bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  return buffer;
}

std::array<std::uint32_t, 3> integers_at(const draco::PointCloud& cloud, int point) {
  std::array<std::uint32_t, 3> integers{};
  cloud.attribute(0)->GetMappedValue(draco::PointIndex(static_cast<std::uint32_t>(point)),
                                     integers.data());
  return integers;
}

// Points in their order.
class PointCloud : public Geometry {
 public:
  explicit PointCloud(const RibbonGrid& grid) { add_points(cloud_, grid.particle_count()); }

  void encode(std::span<const std::uint32_t> frame, draco::EncoderBuffer& bytes) override {
    set_integers(cloud_, frame);
    draco::ExpertEncoder encoder(cloud_);
    encoder.SetEncodingMethod(draco::POINT_CLOUD_SEQUENTIAL_ENCODING);
    [[maybe_unused]] const auto status = encoder.EncodeToBuffer(&bytes);
    assert(status.ok());
  }

  void decode(const draco::EncoderBuffer& bytes, std::span<std::uint32_t> frame) override {
    draco::DecoderBuffer buffer = to_read(bytes);
    const auto cloud = draco::Decoder().DecodePointCloudFromBuffer(&buffer);
    assert(cloud.ok());
    for (std::size_t point = 0; 3 * point < frame.size(); ++point) {
      const auto integers = integers_at(*cloud.value(), static_cast<int>(point));
      std::copy(integers.begin(), integers.end(), &frame[3 * point]);
    }
  }

 private:
  draco::PointCloud cloud_;
};

// Vertices come back in the order in which the coder walks over the mesh, the same for all frames:
// who would use this must keep it, once for the file. It is learnt from a frame whose integers are
// the vertices' numbers, and not counted.
class EdgebreakerMesh : public Geometry {
 public:
  EdgebreakerMesh(const RibbonGrid& grid, int speed)
      : mesh_(mesh_of(grid)), speed_(speed), order_(grid.particle_count()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::vector<std::uint32_t> numbers(3 * order_.size());
    for (std::size_t vertex = 0; vertex < order_.size(); ++vertex)
      numbers[3 * vertex] = static_cast<std::uint32_t>(vertex);
    std::vector<std::uint32_t> walked(numbers.size());
    draco::EncoderBuffer bytes;
    EdgebreakerMesh::encode(numbers, bytes);
    EdgebreakerMesh::decode(bytes, walked);
    for (std::size_t vertex = 0; vertex < order_.size(); ++vertex)
      order_[vertex] = walked[3 * vertex];
  }

  void encode(std::span<const std::uint32_t> frame, draco::EncoderBuffer& bytes) override {
    set_integers(*mesh_, frame);
    draco::ExpertEncoder encoder(*mesh_);
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    encoder.SetSpeedOptions(speed_, speed_);
    [[maybe_unused]] const auto status = encoder.EncodeToBuffer(&bytes);
    assert(status.ok());
  }

  void decode(const draco::EncoderBuffer& bytes, std::span<std::uint32_t> frame) override {
    draco::DecoderBuffer buffer = to_read(bytes);
    const auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    assert(mesh.ok() && mesh.value()->num_points() == order_.size());
    for (std::size_t vertex = 0; vertex < order_.size(); ++vertex) {
      const auto integers = integers_at(*mesh.value(), static_cast<int>(vertex));
      std::copy(integers.begin(), integers.end(), &frame[3 * order_[vertex]]);
    }
  }

 private:
  std::unique_ptr<draco::Mesh> mesh_;
  int speed_;  // 0 smallest, 10 quickest
  std::vector<std::size_t> order_;
};

// Each frame, or what it differs from the frames before by, is coded by itself.
class Draco : public IntegerCodec {
 public:
  Draco(float step, TimeDifference difference, SignForm sign, std::shared_ptr<Geometry> geometry)
      : IntegerCodec(Layout::interleaved, step, difference, sign), geometry_(std::move(geometry)) {}

 private:
  std::size_t pack(std::span<const std::uint32_t> residuals) override {
    frames_.resize(residuals.size() / frame_values());
    std::size_t size = 0;
    for (std::size_t frame = 0; frame < frames_.size(); ++frame) {
      frames_[frame].Clear();
      geometry_->encode(residuals.subspan(frame * frame_values(), frame_values()), frames_[frame]);
      size += frames_[frame].size();
    }
    return size;
  }

  void unpack(std::span<std::uint32_t> residuals) override {
    for (std::size_t frame = 0; frame < frames_.size(); ++frame)
      geometry_->decode(frames_[frame], residuals.subspan(frame * frame_values(), frame_values()));
  }

  std::shared_ptr<Geometry> geometry_;
  std::vector<draco::EncoderBuffer> frames_;
};

using MakeGeometry = std::function<std::shared_ptr<Geometry>(const RibbonGrid&)>;

// It counts integers of 31 bits, too few for the bits of floats.
std::vector<CodecRow::Make> settings(const MakeGeometry& make) {
  std::vector<CodecRow::Make> settings;
  for (const TimeDifference difference :
       {TimeDifference::none, TimeDifference::first, TimeDifference::second})
    settings.emplace_back([=](const CodecTask& task) -> std::unique_ptr<FrameCodec> {
      const auto step = quantisation_step(task);
      if (!step || *step == 0) return nullptr;
      return std::make_unique<Draco>(*step, difference, SignForm::plain, make(task.grid));
    });
  return settings;
}

CodecRow mesh_row(int speed) {
  return {.name = "Draco, mesh, speed " + std::to_string(speed),
          .settings = settings([=](const RibbonGrid& grid) {
            return std::make_shared<EdgebreakerMesh>(grid, speed);
          })};
}

}  // namespace

std::vector<CodecRow> draco_rows() {
  const CodecRow points{.name = "Draco, point cloud",
                        .settings = settings([](const RibbonGrid& grid) {
                          return std::make_shared<PointCloud>(grid);
                        })};
  return {points, mesh_row(5), mesh_row(0)};
}

}  // namespace ribbon

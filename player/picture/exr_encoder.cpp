#include "player/picture/exr_encoder.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <vector>

namespace ribbon {

namespace {

// A file in memory.
class StringStream final : public Imf::OStream {
 public:
  explicit StringStream(std::string& bytes) : Imf::OStream("picture.exr"), bytes_(bytes) {}

  void write(const char* data, int count) override {
    const auto length = static_cast<std::size_t>(count);
    bytes_.resize(std::max(bytes_.size(), place_ + length));
    std::copy_n(data, length, bytes_.data() + place_);
    place_ += length;
  }
  std::uint64_t tellp() override { return place_; }
  void seekp(std::uint64_t place) override { place_ = place; }

 private:
  std::string& bytes_;
  std::size_t place_ = 0;
};

std::vector<half> half_floats(const LightPicture& picture) {
  const float most = std::numeric_limits<half>::max();
  std::vector<half> values;
  values.reserve(3 * picture.pixels.size());
  for (const Color& color : picture.pixels)
    for (int channel = 0; channel < 3; ++channel)
      values.emplace_back(std::clamp(color[channel], -most, most));
  return values;
}

}  // namespace

std::string exr_bytes(const LightPicture& picture) {
  const PictureSize size = picture.size;
  assert(size.width > 0 && size.height > 0);
  std::vector<half> values = half_floats(picture);
  Imf::Header header(size.width, size.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer channels;
  const std::array names{"R", "G", "B"};
  for (std::size_t channel = 0; channel < names.size(); ++channel) {
    header.channels().insert(names[channel], Imf::Channel(Imf::HALF));
    channels.insert(names[channel],
                    Imf::Slice(Imf::HALF, reinterpret_cast<char*>(values.data() + channel),
                               3 * sizeof(half), 3 * sizeof(half) * size.width));
  }
  std::string bytes;
  StringStream stream(bytes);
  {
    constexpr int no_threads = 0;
    Imf::OutputFile file(stream, header, no_threads);
    file.setFrameBuffer(channels);
    file.writePixels(size.height);
  }
  return bytes;
}

}  // namespace ribbon

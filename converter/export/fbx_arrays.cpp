#include "converter/export/fbx_arrays.h"

#include <libdeflate.h>

#include <string>

namespace ribbon {

struct FbxArrays::State {
  // The fastest level: coordinates hardly become smaller with the others.
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(1);
  std::string buffer;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { libdeflate_free_compressor(compressor); }
};

FbxArrays::FbxArrays() : state_(std::make_unique<State>()) {}
FbxArrays::FbxArrays(FbxArrays&&) noexcept = default;
FbxArrays::~FbxArrays() = default;

FbxProperty FbxArrays::deflated(char type, std::size_t elements, std::string_view bytes) {
  libdeflate_compressor* const compressor = state_->compressor;
  std::string& buffer = state_->buffer;
  // Room for anything but growth, so that 0 says: leave it as it is.
  buffer.resize(bytes.size());
  const std::size_t size = compressor == nullptr
                               ? 0
                               : libdeflate_zlib_compress(compressor, bytes.data(), bytes.size(),
                                                          buffer.data(), buffer.size());
  if (size == 0) return FbxProperty::array(type, elements, false, bytes);
  return FbxProperty::array(type, elements, true, {buffer.data(), size});
}

}  // namespace ribbon

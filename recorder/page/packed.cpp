#include "recorder/page/packed.h"

#include <libdeflate.h>

#include <memory>
#include <new>

#include "page/seven_bits.h"

namespace ribbon {

std::string packed(std::string_view bytes) {
  constexpr int smallest = 12;
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(smallest), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::string gzip(libdeflate_gzip_compress_bound(compressor.get(), bytes.size()), '\0');
  gzip.resize(libdeflate_gzip_compress(compressor.get(), bytes.data(), bytes.size(), gzip.data(),
                                       gzip.size()));
  return seven_bits(gzip);
}

}  // namespace ribbon

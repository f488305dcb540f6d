#include "player/render/ray_batch.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include <cassert>

#include "parallel/instruction_set.h"

namespace ribbon {

namespace {

void list_one_by_one(const std::uint8_t* marks, std::uint8_t mark, std::size_t count,
                     LaneList& list) {
  list.count = 0;
  for (std::size_t i = 0; i < count; ++i) list.add_if(i, marks[i] == mark);
}

#ifdef __x86_64__
// Compilers do not find the instruction that moves chosen lanes together.
[[gnu::target("avx512f,avx512bw,avx512vl")]] void list_sixteen_at_a_time(const std::uint8_t* marks,
                                                                         std::uint8_t mark,
                                                                         std::size_t count,
                                                                         LaneList& list) {
  const __m128i wanted = _mm_set1_epi8(static_cast<char>(mark));
  constexpr __mmask16 all = 0xFFFF;  // GCC warns of what the form without it leaves undefined
  const __m512i step = _mm512_set1_epi32(16);
  __m512i numbers = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  std::size_t listed_count = 0;  // not read anew after each store
  for (std::size_t first = 0; first < count; first += 16) {
    const __m128i some = _mm_loadu_si128(reinterpret_cast<const __m128i*>(marks + first));
    __mmask16 listed = _mm_cmpeq_epi8_mask(some, wanted);
    if (count - first < 16) listed &= static_cast<__mmask16>((1U << (count - first)) - 1);
    _mm256_storeu_si256(
        reinterpret_cast<__m256i*>(list.lanes.data() + listed_count),
        _mm512_maskz_cvtepi32_epi16(all, _mm512_maskz_compress_epi32(listed, numbers)));
    listed_count += static_cast<std::size_t>(__builtin_popcount(listed));
    numbers = _mm512_add_epi32(numbers, step);
  }
  list.count = listed_count;
}
#endif

}  // namespace

void list_marked(const std::uint8_t* marks, std::uint8_t mark, std::size_t count, LaneList& list) {
  assert(count <= batch_size);
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512)
    return list_sixteen_at_a_time(marks, mark, count, list);
#endif
  list_one_by_one(marks, mark, count, list);
}

}  // namespace ribbon

#include "player/render/ray_batch.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include <algorithm>
#include <cassert>

#include "parallel/instruction_set.h"

namespace ribbon {

namespace {

void list_one_by_one(const std::uint8_t* marks, std::uint8_t mark, std::size_t count,
                     MarkedLanes& list) {
  list.count = 0;
  list.masks.fill(0);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_marked = marks[i] == mark;
    list.add_if(i, is_marked);
    list.masks[i / register_lanes] |=
        static_cast<std::uint16_t>((is_marked ? 1U : 0U) << i % register_lanes);
  }
}

template <class Number>
void move_together_one_by_one(const Number* numbers, const MarkedLanes& marked, Number* to) {
  for (std::size_t i = 0; i < marked.count; ++i) to[i] = numbers[marked.lanes[i]];
}

void move_apart_one_by_one(const float* numbers, const MarkedLanes& marked, float* to) {
  std::fill_n(to, batch_size, 0.0F);
  for (std::size_t i = 0; i < marked.count; ++i) to[marked.lanes[i]] = numbers[i];
}

#ifdef __x86_64__
// Compilers do not find the instructions that move chosen lanes together and apart.
#define RIBBON_SIXTEEN_LANES [[gnu::target("avx512f,avx512bw,avx512vl,popcnt")]]

constexpr __mmask16 all_lanes = 0xFFFF;  // GCC warns of what the forms without it leave undefined

RIBBON_SIXTEEN_LANES void list_sixteen_at_a_time(const std::uint8_t* marks, std::uint8_t mark,
                                                 std::size_t count, MarkedLanes& list) {
  const __m128i wanted = _mm_set1_epi8(static_cast<char>(mark));
  const __m512i step = _mm512_set1_epi32(16);
  __m512i numbers = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  std::size_t listed_count = 0;  // not read anew after each store
  list.masks.fill(0);
  for (std::size_t first = 0; first < count; first += 16) {
    const __m128i some = _mm_loadu_si128(reinterpret_cast<const __m128i*>(marks + first));
    __mmask16 listed = _mm_cmpeq_epi8_mask(some, wanted);
    if (count - first < 16) listed &= static_cast<__mmask16>((1U << (count - first)) - 1);
    list.masks[first / register_lanes] = listed;
    _mm256_storeu_si256(
        reinterpret_cast<__m256i*>(list.lanes.data() + listed_count),
        _mm512_maskz_cvtepi32_epi16(all_lanes, _mm512_maskz_compress_epi32(listed, numbers)));
    listed_count += static_cast<std::size_t>(__builtin_popcount(listed));
    numbers = _mm512_add_epi32(numbers, step);
  }
  list.count = listed_count;
}

template <class Number>
RIBBON_SIXTEEN_LANES void move_together_sixteen_at_a_time(const Number* numbers,
                                                          const MarkedLanes& marked, Number* to) {
  Number* const end = to + marked.count;
  for (const std::uint16_t mask : marked.masks) {
    if (to == end) return;
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, _mm512_loadu_si512(numbers)));
    numbers += register_lanes;
    to += __builtin_popcount(mask);
  }
}

RIBBON_SIXTEEN_LANES void move_apart_sixteen_at_a_time(const float* numbers,
                                                       const MarkedLanes& marked, float* to) {
  for (const std::uint16_t mask : marked.masks) {
    _mm512_storeu_ps(to, _mm512_maskz_expand_ps(mask, _mm512_loadu_ps(numbers)));
    numbers += __builtin_popcount(mask);
    to += register_lanes;
  }
}
#endif

template <class Number>
void move_numbers_together(const Number* numbers, const MarkedLanes& marked, Number* to) {
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512)
    return move_together_sixteen_at_a_time(numbers, marked, to);
#endif
  move_together_one_by_one(numbers, marked, to);
}

}  // namespace

void list_marked(const std::uint8_t* marks, std::uint8_t mark, std::size_t count,
                 MarkedLanes& list) {
  assert(count <= batch_size);
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512)
    return list_sixteen_at_a_time(marks, mark, count, list);
#endif
  list_one_by_one(marks, mark, count, list);
}

void move_together(const Lanes<float>& numbers, const MarkedLanes& marked, float* to) {
  move_numbers_together(numbers.data(), marked, to);
}

void move_together(const Lanes<std::uint32_t>& numbers, const MarkedLanes& marked,
                   std::uint32_t* to) {
  move_numbers_together(numbers.data(), marked, to);
}

void move_apart(const Lanes<float>& numbers, const MarkedLanes& marked, Lanes<float>& to) {
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512)
    return move_apart_sixteen_at_a_time(numbers.data(), marked, to.data());
#endif
  move_apart_one_by_one(numbers.data(), marked, to.data());
}

}  // namespace ribbon

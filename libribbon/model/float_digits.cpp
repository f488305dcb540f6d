#include "model/float_digits.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "text/number_in.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

static_assert(std::endian::native == std::endian::little, "digits are made in this order");

constexpr std::array<std::uint64_t, 12> power_of_ten{
    1,         10,         100,         1'000,         10'000,         100'000,
    1'000'000, 10'000'000, 100'000'000, 1'000'000'000, 10'000'000'000, 100'000'000'000};

// Of numbers m / 2^shift, m of 24 bits: what follows fits into 64 bits up to here.
constexpr std::uint32_t most_shift = 36;

// Decimals of as many places as it takes to tell neighbours apart, and no more: 10^-places is at
// most the distance 2^-shift between neighbours, and 10 times that is more.
constexpr std::uint32_t places_for(std::uint32_t shift) {
  return (shift * 1233U >> 12U) + 1;  // 1233 / 2^12 is a little less than lg 2, and that suffices
}

// A number that lies between two that are equally far away from it.
struct Spaced {
  std::uint64_t mantissa;
  std::uint32_t shift;
};

// Half the distance to a neighbour is 10^places in units of 10^-places / 2^(shift + 1). Decimals
// that are nearer than that read back as this number. At most one with a place less is; where none
// is, the nearest with all places is as near. Without branches, which nobody could foretell.
std::uint32_t rounded(const Spaced& number, std::uint32_t places) {
  const std::uint64_t half = power_of_ten[places];
  const std::uint64_t scaled = 2 * number.mantissa * half;
  const std::uint64_t one = std::uint64_t{2} << number.shift;
  const auto whole = static_cast<std::uint32_t>(scaled >> (number.shift + 1));
  const std::uint64_t rest = scaled & (one - 1);
  const std::uint32_t last = whole % 10;
  const std::uint64_t over_ten = last * one + rest;
  const std::uint64_t below_ten = 10 * one - over_ten;
  const std::uint32_t to_even = whole % 2;
  const std::uint32_t nearest = whole + static_cast<std::uint32_t>(2 * rest + to_even > one);
  const std::uint32_t shorter =
      whole - last + 10U * static_cast<std::uint32_t>(over_ten > below_ten);
  const bool enough = (over_ten < half) | (below_ten < half);
  const std::uint32_t mask = 0U - static_cast<std::uint32_t>(enough);
  return (shorter & mask) | (nearest & ~mask);
}

// A byte for each of eight digits, the first one lowest: halved into four, two and one digit, in
// lanes of one word. 10486 / 2^20 and 103 / 2^10 are quotients by 100 and 10 for numbers so small.
std::uint64_t eight_digits(std::uint32_t number) {
  const std::uint64_t fours = number / 10'000U | std::uint64_t{number % 10'000U} << 32U;
  const std::uint64_t hundreds = (fours * 10'486U >> 20U) & 0x0000007f0000007f;
  const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16U;
  const std::uint64_t tens = (twos * 103U >> 10U) & 0x000f000f000f000f;
  return tens | (twos - 10 * tens) << 8U;
}

// As few as read back as the same number.
std::string fewest_digits(float number) {
  constexpr int always_enough = 9;
  int count = 1;
  while (count < always_enough && number_told<float>(short_number(number, count)) != number)
    ++count;
  return short_number(number, count);
}

// What std::to_chars() would write, which not every standard library has for such numbers: whole
// ones without an exponent unless that is shorter.
std::string digits_of_any(float number) {
  std::string digits = fewest_digits(number);
  if (number == 0 || number != std::trunc(number) || std::abs(number) >= 0x1p63F) return digits;
  std::string whole = std::to_string(static_cast<std::int64_t>(number));
  return whole.size() <= digits.size() ? whole : digits;
}

char* write_any(char* text, float number) {
  const auto whole = static_cast<int>(std::abs(number) < 100'000 ? number : 0);
  if (whole != 0 && static_cast<float>(whole) == number)
    return std::to_chars(text, text + float_digits_room, whole).ptr;
  const std::string digits = digits_of_any(number);
  return std::copy(digits.begin(), digits.end(), text);
}

char digit(std::uint32_t number) {
  return static_cast<char>('0' + number);
}

// `decimals`, not 0, as `places` places without the zeros at their end.
char* write_decimals(char* text, std::uint64_t decimals, std::uint32_t places) {
  const std::uint32_t zeros = places > 9 ? places - 9 : 0;  // a mantissa has at most nine digits
  std::fill_n(text, 2, '0');
  text += zeros;
  const auto nine = static_cast<std::uint32_t>(decimals * power_of_ten[9 + zeros - places]);
  *text++ = digit(nine / 100'000'000U);
  const std::uint64_t others = eight_digits(nine % 100'000'000U);
  const std::uint64_t characters = others | 0x3030303030303030;
  std::memcpy(text, &characters, sizeof characters);
  return text + 8 - std::countl_zero(others) / 8;
}

}  // namespace

char* write_digits(char* text, float number) {
  const auto bits = Eigen::numext::bit_cast<std::uint32_t>(number);
  const std::uint32_t fraction = bits & 0x7fffffU;
  const Spaced spaced{.mantissa = fraction | 0x800000U, .shift = 150 - (bits >> 23U & 0xffU)};
  // Without a fraction it is a power of two, whose neighbours are not equally far away.
  if (spaced.shift - 1 >= most_shift || fraction == 0) return write_any(text, number);
  const auto whole = static_cast<std::uint32_t>(spaced.mantissa >> spaced.shift);
  const std::uint32_t places = places_for(spaced.shift);
  const std::uint64_t decimals = rounded(spaced, places) - whole * power_of_ten[places];
  if (decimals == 0) return write_any(text, number);
  *text = '-';
  text += bits >> 31U;
  if (whole < 10)
    *text++ = digit(whole);
  else
    text = std::to_chars(text, text + float_digits_room, whole).ptr;
  *text++ = '.';
  return write_decimals(text, decimals, places);
}

}  // namespace ribbon

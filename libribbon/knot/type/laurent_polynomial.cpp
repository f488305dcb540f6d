#include "knot/type/laurent_polynomial.h"

#include <algorithm>
#include <cstddef>

namespace ribbon {
namespace {

LaurentPolynomial in_normal_form(LaurentPolynomial polynomial) {
  auto& coefficients = polynomial.coefficients;
  while (!coefficients.empty() && coefficients.back() == 0) coefficients.pop_back();
  const auto first = std::find_if(coefficients.begin(), coefficients.end(),
                                  [](std::int64_t coefficient) { return coefficient != 0; });
  polynomial.lowest_power += static_cast<int>(first - coefficients.begin());
  coefficients.erase(coefficients.begin(), first);
  if (coefficients.empty()) polynomial.lowest_power = 0;
  return polynomial;
}

int end_power(const LaurentPolynomial& polynomial) {
  return polynomial.lowest_power + static_cast<int>(polynomial.coefficients.size());
}

bool add(std::int64_t& total, std::int64_t amount) {
  return !__builtin_add_overflow(total, amount, &total);
}

bool add_product(std::int64_t& total, std::int64_t a, std::int64_t b) {
  std::int64_t amount = 0;
  return !__builtin_mul_overflow(a, b, &amount) && add(total, amount);
}

// "3 t^-2", without its sign.
std::string term_text(std::int64_t coefficient, int power) {
  std::string size = std::to_string(coefficient);
  if (coefficient < 0) size.erase(0, 1);
  if (power == 0) return size;
  const std::string variable = power == 1 ? "t" : "t^" + std::to_string(power);
  return size == "1" ? variable : size + " " + variable;
}

}  // namespace

LaurentPolynomial LaurentPolynomial::monomial(std::int64_t coefficient, int power) {
  return in_normal_form({power, {coefficient}});
}

LaurentPolynomial LaurentPolynomial::mirrored() const {
  return in_normal_form({1 - end_power(*this), {coefficients.rbegin(), coefficients.rend()}});
}

std::string LaurentPolynomial::text() const {
  std::string result;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    if (coefficients[k] == 0) continue;
    const bool negative = coefficients[k] < 0;
    if (result.empty()) {
      result = negative ? "-" : "";
    } else {
      result += negative ? " - " : " + ";
    }
    result += term_text(coefficients[k], lowest_power + static_cast<int>(k));
  }
  return result.empty() ? "0" : result;
}

std::optional<LaurentPolynomial> sum(const LaurentPolynomial& a, const LaurentPolynomial& b) {
  if (a.coefficients.empty()) return b;
  if (b.coefficients.empty()) return a;
  const int lowest = std::min(a.lowest_power, b.lowest_power);
  const int end = std::max(end_power(a), end_power(b));
  LaurentPolynomial result{lowest, std::vector<std::int64_t>(end - lowest)};
  for (const LaurentPolynomial* part : {&a, &b}) {
    auto* total = result.coefficients.data() + (part->lowest_power - lowest);
    for (const std::int64_t coefficient : part->coefficients)
      if (!add(*total++, coefficient)) return {};
  }
  return in_normal_form(std::move(result));
}

std::optional<LaurentPolynomial> product(const LaurentPolynomial& a, const LaurentPolynomial& b) {
  if (a.coefficients.empty() || b.coefficients.empty()) return LaurentPolynomial{};
  LaurentPolynomial result{
      a.lowest_power + b.lowest_power,
      std::vector<std::int64_t>(a.coefficients.size() + b.coefficients.size() - 1)};
  for (std::size_t i = 0; i < a.coefficients.size(); ++i)
    for (std::size_t j = 0; j < b.coefficients.size(); ++j)
      if (!add_product(result.coefficients[i + j], a.coefficients[i], b.coefficients[j])) return {};
  return in_normal_form(std::move(result));
}

}  // namespace ribbon

// Polynomials in one variable with positive and negative powers and exact integer coefficients.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ribbon {

// The sum of coefficients[k] * t^(lowest_power + k). Normal form: first and last coefficient differ
// from zero; zero itself has no coefficients and lowest power 0. Two are equal if and only if they
// are the same polynomial.
struct LaurentPolynomial {
  int lowest_power = 0;
  std::vector<std::int64_t> coefficients;

  [[nodiscard]] static LaurentPolynomial monomial(std::int64_t coefficient, int power);
  // The same with 1/t for t: what a knot polynomial becomes in the mirror.
  [[nodiscard]] LaurentPolynomial mirrored() const;
  // Such as "t + t^3 - t^4"; zero is "0".
  [[nodiscard]] std::string text() const;

  bool operator==(const LaurentPolynomial&) const = default;
};

// Nothing when a coefficient would leave 64 bits.
std::optional<LaurentPolynomial> sum(const LaurentPolynomial& a, const LaurentPolynomial& b);
std::optional<LaurentPolynomial> product(const LaurentPolynomial& a, const LaurentPolynomial& b);

}  // namespace ribbon

#include "converter/export/usd_text.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "converter/export/number_digits.h"
#include "parallel/parallel.h"

namespace ribbon {

namespace {

constexpr std::size_t tuples_per_range = 1024;

bool begins_character(unsigned char byte) {
  return (byte & 0xc0U) != 0x80;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool may_stand_in_identifier(char c) {
  return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

// The longest is "-1.17549435e-38".
constexpr std::size_t float_bytes = 16;

// Begins with ", " and returns its end.
char* write_tuple(char* text, const Eigen::Ref<const Eigen::VectorXf>& numbers) {
  char separator = '(';
  *text++ = ',';
  *text++ = ' ';
  for (const float number : numbers) {
    *text++ = separator;
    if (separator == ',') *text++ = ' ';
    text = std::to_chars(text, text + float_bytes, number).ptr;
    separator = ',';
  }
  *text++ = ')';
  return text;
}

// Written in place: this is most of the time that a file takes.
std::string tuples_text(const Eigen::Ref<const Eigen::MatrixXf>& columns) {
  const auto tuple_bytes = static_cast<std::size_t>(columns.rows()) * (float_bytes + 2) + 3;
  std::string text(static_cast<std::size_t>(columns.cols()) * tuple_bytes, '\0');
  char* end = text.data();
  for (Eigen::Index i = 0; i < columns.cols(); ++i) end = write_tuple(end, columns.col(i));
  text.resize(static_cast<std::size_t>(end - text.data()));
  return text;
}

}  // namespace

std::string usd_identifier(std::string_view name) {
  std::string identifier;
  for (const char c : name)
    if (may_stand_in_identifier(c))
      identifier += c;
    else if (begins_character(static_cast<unsigned char>(c)))
      identifier += '_';
  return identifier.empty() || is_digit(identifier.front()) ? "_" + identifier : identifier;
}

std::string usd_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string usd_asset(std::string_view file_name) {
  const std::string quote = file_name.find('@') == std::string_view::npos ? "@" : "@@@";
  return quote + "./" + std::string(file_name) + quote;
}

std::string usd_array(const Eigen::Ref<const Eigen::VectorXi>& numbers) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    if (i > 0) text += ", ";
    append_digits(text, numbers[i]);
  }
  return text + ']';
}

std::string usd_array_of_tuples(const Eigen::Ref<const Eigen::MatrixXf>& columns) {
  const auto count = static_cast<std::size_t>(columns.cols());
  std::vector<std::string> pieces((count + tuples_per_range - 1) / tuples_per_range);
  parallel_ranges(count, tuples_per_range, [&](std::size_t begin, std::size_t end) {
    pieces[begin / tuples_per_range] = tuples_text(columns.middleCols(
        static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin)));
  });
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  return "[" + text.substr(std::min<std::size_t>(text.size(), 2)) + "]";
}

}  // namespace ribbon

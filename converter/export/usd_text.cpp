#include "converter/export/usd_text.h"

#include <array>
#include <cassert>
#include <vector>

#include "model/float_digits.h"
#include "model/number_digits.h"
#include "parallel/parallel.h"

namespace ribbon {

namespace {

constexpr std::size_t tuples_per_range = 512;

bool begins_character(unsigned char byte) {
  return (byte & 0xc0U) != 0x80;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool may_stand_in_identifier(char c) {
  return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

// What stands around and between the numbers of a tuple of at most three comes on top.
constexpr std::size_t most_tuple_bytes = 3 * (float_digits_room + 2) + 2;

// Begins with ", " and returns its end.
char* write_tuple(char* text, const float* numbers, Eigen::Index count) {
  for (Eigen::Index i = 0; i < count; ++i) {
    *text++ = ',';
    *text++ = ' ';
    if (i == 0) *text++ = '(';
    text = write_digits(text, numbers[i]);
  }
  *text++ = ')';
  return text;
}

// Written in place: this is most of the time that a file takes.
std::string tuples_text(const Eigen::Ref<const Eigen::MatrixXf>& columns) {
  assert(static_cast<std::size_t>(columns.cols()) <= tuples_per_range && columns.rows() <= 3);
  std::array<char, tuples_per_range * most_tuple_bytes> text;
  char* end = text.data();
  for (Eigen::Index i = 0; i < columns.cols(); ++i)
    end = write_tuple(end, columns.col(i).data(), columns.rows());
  return {text.data(), end};
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
  std::string name(file_name);
  for (std::size_t at = 0; (at = name.find("@@@", at)) != std::string::npos; at += 4)
    name.insert(at, 1, '\\');
  return quote + "./" + name + quote;
}

std::string usd_array(const Eigen::Ref<const Eigen::VectorXi>& numbers) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    if (i > 0) text += ", ";
    append_digits(text, numbers[i]);
  }
  return text + ']';
}

void append_usd_array_of_tuples(std::string& text,
                                const Eigen::Ref<const Eigen::MatrixXf>& columns) {
  const auto count = static_cast<std::size_t>(columns.cols());
  std::vector<std::string> pieces((count + tuples_per_range - 1) / tuples_per_range);
  parallel_ranges(count, tuples_per_range, [&](std::size_t begin, std::size_t end) {
    pieces[begin / tuples_per_range] = tuples_text(columns.middleCols(
        static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin)));
  });
  if (count > 0) pieces.front().erase(0, 2);  // there is none before it
  text += '[';
  for (const std::string& piece : pieces) text += piece;
  text += ']';
}

std::string usd_array_of_tuples(const Eigen::Ref<const Eigen::MatrixXf>& columns) {
  std::string text;
  append_usd_array_of_tuples(text, columns);
  return text;
}

}  // namespace ribbon

#include "commandline/frame_range.h"

#include <cstdint>
#include <optional>
#include <string_view>

#include "text/number_in.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// What was written between the colons; nothing where it was left out. A single number has no
// colons, so its `last` is its `first`.
struct Written {
  std::optional<int> first;
  std::optional<int> last;
  std::optional<int> step;
};

tl::unexpected<Error> bad(const std::string& text, const std::string& problem,
                          const std::string& remedy) {
  return failure("frames '" + text + "'", problem, remedy);
}

std::vector<std::string_view> split_at(char separator, std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t end = 0; (end = text.find(separator)) != std::string_view::npos;
       text.remove_prefix(end + 1))
    parts.push_back(text.substr(0, end));
  parts.push_back(text);
  return parts;
}

// False when `text` is neither empty nor a whole number.
bool read_number(std::string_view text, std::optional<int>& number) {
  number = number_in<int>(text);
  return number || text.empty();
}

Result<Written> read_written(const std::string& text) {
  const std::vector<std::string_view> parts = split_at(':', text);
  Written written;
  const bool readable = parts.size() <= 3 && read_number(parts[0], written.first) &&
                        (parts.size() < 2 || read_number(parts[1], written.last)) &&
                        (parts.size() < 3 || read_number(parts[2], written.step));
  if (!readable)
    return bad(text, "cannot be read",
               "write numbers, FIRST:LAST or FIRST:LAST:STEP, with commas between");
  if (written.step == 0) return bad(text, "have a step of 0", "write a step of 1 or more");
  if (parts.size() == 1) written.last = written.first;
  return written;
}

// The index from 0 of frame `number`, which counts from 1, or from the end when it is negative.
Result<int> index_of(const std::string& text, int number, int frame_count) {
  const std::int64_t index =
      number > 0 ? std::int64_t{number} - 1 : std::int64_t{frame_count} + number;
  if (number != 0 && index >= 0 && index < frame_count) return static_cast<int>(index);
  return bad(text, filled_in("name frame {} of a recording with {} frames", number, frame_count),
             frame_count == 0
                 ? "record some first"
                 : filled_in("write numbers from 1 to {}, or -1 for the last", frame_count));
}

std::vector<int> counted(std::int64_t first, std::int64_t last, std::int64_t step) {
  std::vector<int> indices;
  for (std::int64_t index = first; step > 0 ? index <= last : index >= last; index += step)
    indices.push_back(static_cast<int>(index));
  return indices;
}

Result<std::vector<int>> parse_range(const std::string& text, int frame_count) {
  const auto written = read_written(text);
  if (!written) return tl::unexpected(written.error());
  if (frame_count == 0 && !written->first && !written->last) return std::vector<int>{};
  const int step = written->step.value_or(1);
  const auto first = index_of(text, written->first.value_or(step > 0 ? 1 : -1), frame_count);
  if (!first) return tl::unexpected(first.error());
  const auto last = index_of(text, written->last.value_or(step > 0 ? -1 : 1), frame_count);
  if (!last) return tl::unexpected(last.error());
  if (step > 0 ? *last < *first : *last > *first)
    return bad(text, step > 0 ? "run backwards" : "run forwards",
               step > 0 ? "write a negative step, or the smaller number first"
                        : "write a positive step, or the larger number first");
  return counted(*first, *last, step);
}

}  // namespace

Result<std::vector<int>> parse_frame_range(const std::string& text, int frame_count) {
  std::vector<int> frames;
  std::vector<bool> named(static_cast<std::size_t>(frame_count));
  const std::vector<std::string_view> parts = split_at(',', text);
  for (const std::string_view part : parts) {
    if (part.empty() && parts.size() > 1)
      return bad(text, "have nothing between two commas", "write numbers and ranges: 1,5,9:20");
    auto range = parse_range(std::string(part), frame_count);
    if (!range) return range;
    for (const int index : *range) {
      if (!named[static_cast<std::size_t>(index)]) frames.push_back(index);
      named[static_cast<std::size_t>(index)] = true;
    }
  }
  return frames;
}

}  // namespace ribbon

#include "converter/number_list.h"

namespace ribbon {

std::string number_list(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t begin = 0, end = 0; begin < numbers.size(); begin = end) {
    end = begin + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    if (!text.empty()) text += ", ";
    text += std::to_string(numbers[begin]);
    if (end - begin > 1) text.append("-").append(std::to_string(numbers[end - 1]));
  }
  return text;
}

}  // namespace ribbon

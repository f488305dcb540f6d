#include "converter/sequence_names.h"

#include <utility>

#include "converter/output_names.h"

namespace ribbon {

namespace {

std::vector<int> numbers_of(const std::vector<int>& frames, std::optional<int> start) {
  std::vector<int> numbers;
  numbers.reserve(frames.size());
  for (const int index : frames)
    numbers.push_back(start ? *start + static_cast<int>(numbers.size()) : index + 1);
  return numbers;
}

// The folder that all frames lie in or below.
std::filesystem::path common_folder(const std::filesystem::path& output) {
  std::filesystem::path folder;
  for (const std::filesystem::path& part : output.parent_path()) {
    if (part.string().find('{') != std::string::npos) break;
    folder /= part;
  }
  return folder;
}

}  // namespace

Result<SequenceNames> SequenceNames::of(const ConversionRequest& request,
                                        const std::vector<int>& frames) {
  return FramePattern::parse(request.output, static_cast<int>(frames.size()))
      .map([&](FramePattern pattern) {
        return SequenceNames(request.output, std::move(pattern),
                             numbers_of(frames, request.start_frame));
      });
}

SequenceNames::SequenceNames(std::string output, FramePattern pattern, std::vector<int> numbers)
    : output_(std::move(output)), pattern_(std::move(pattern)), numbers_(std::move(numbers)) {}

std::vector<std::filesystem::path> SequenceNames::frames() const {
  std::vector<std::filesystem::path> files;
  files.reserve(numbers_.size());
  for (const int number : numbers_) files.push_back(pattern_.file(number));
  return files;
}

std::string SequenceNames::library() const {
  return material_library_name(output_);
}

std::set<std::filesystem::path> SequenceNames::folders() const {
  std::set<std::filesystem::path> folders;
  for (const int number : numbers_) folders.insert(pattern_.file(number).parent_path());
  return folders;
}

std::filesystem::path SequenceNames::log() const {
  const std::filesystem::path output = output_;
  const std::string stem = std::filesystem::path(library()).stem().string();
  return common_folder(output) / (stem + output.extension().string() + ".unfinished");
}

}  // namespace ribbon

// Exceptions as errors, where nobody else would catch them.
#pragma once

#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

#include "result/result.h"

namespace ribbon {

// No memory, no thread and what happens to files are the world's doing, all else is a bug of ours.
inline Error error_of(const std::exception& exception) {
  if (dynamic_cast<const std::bad_alloc*>(&exception) != nullptr)
    return {"", "not enough memory", "close other programs or ask for less at once"};
  if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&exception))
    return {of_file->path1().string(), "cannot be used (" + of_file->code().message() + ")",
            "check that it is there, and its permissions"};
  const auto* of_system = dynamic_cast<const std::system_error*>(&exception);
  const bool lacks_thread =
      (of_system != nullptr && of_system->code() == std::errc::resource_unavailable_try_again) ||
      std::string_view(exception.what()).starts_with("pthread_create");  // as TBB tells it
  if (lacks_thread)
    return {"", "the system gives it no more threads",
            "close other programs, or allow more processes (ulimit -u) or memory (ulimit -v)"};
  return {"", std::string("stopped by an unexpected problem (") + exception.what() + ")",
          "please report it"};
}

// What `work` gives, a Result; fails with what it throws.
template <class Work>
auto caught(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::exception& exception) {
    return tl::unexpected(error_of(exception));
  }
}

}  // namespace ribbon

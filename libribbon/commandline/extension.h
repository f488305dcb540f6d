// Which kind of file a name asks for.
#pragma once

#include <filesystem>
#include <string>

namespace ribbon {

// ".mp4" of "out.1/Knot.MP4"; empty where there is none.
std::string lower_case_extension(const std::filesystem::path& file);

}  // namespace ribbon

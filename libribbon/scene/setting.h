// Settings of a scene that are changed where the scene is used: --set KEY=VALUE.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "result/result.h"

namespace ribbon {

// A setting as with_setting() takes it: "time.duration = 6.5", with as many digits as the number
// needs.
std::string setting_of(const std::string& key, double value);

// The text of a scene with one setting, "fastening.speed=0.3" or "accuracy=fine", changed where it
// stands or else added to its table; everything else stays as it was written. The value is TOML, or
// a word without quotes. Fails when it is not, and where there is no place for it. Whether the
// scene knows such a key, and such a value, is for read_scene() to say.
Result<std::string> with_setting(const std::filesystem::path& file, const std::string& text,
                                 const std::string& setting);

// The text of a scene in which other words stand in place of a key of a table and its value; all
// else keeps its line. As it is where the table has no such key. Fails where that leaves no TOML.
Result<std::string> with_entry_replaced(const std::filesystem::path& file, const std::string& text,
                                        std::string_view table, std::string_view key,
                                        const std::string& words);

}  // namespace ribbon

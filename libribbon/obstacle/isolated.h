// Work that may go astray on what strangers wrote.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace ribbon {

// What `work` returns; nothing where it crashed or took more than `most_s` seconds of processor
// time. It runs in a process of its own, of which nothing else remains; in WebAssembly, which has
// none, it is simply called.
std::optional<std::string> isolated(const std::function<std::string()>& work, unsigned most_s);

}  // namespace ribbon

// What the parser of TOML must not be given.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace ribbon {

// Where in a TOML text the first byte beyond ASCII stands that is in no string and no comment; a
// byte order mark at the start does not count. The parser's behaviour is undefined for it.
std::optional<std::size_t> first_outside_quotes(std::string_view toml);

// Where in a TOML text a key goes deeper than any scene has tables ("a.b.c..."). The parser calls
// itself for each part of a key, until the stack is at its end.
std::optional<std::size_t> first_too_deep(std::string_view toml);

}  // namespace ribbon

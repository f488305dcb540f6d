// The answer of anything that meets the outside world: a value, or one clear sentence.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace ribbon {

// What went wrong in the outside world (a file, a disk, a scene, damage), never a bug of ours: bugs
// assert. A tool prints sentence() and exits with 2, or with 3 where trying again may help.
struct Error {
  std::string place;      // where: "knot.toml:12:3", "knot.rbn: byte 4096"; may be empty
  std::string problem;    // what is wrong: "unknown key 'widht'"
  std::string remedy;     // what to do about it: "write 'width'"
  bool may_pass = false;  // the same may work another time: interrupted, or the disk was full

  [[nodiscard]] std::string sentence() const {
    return (place.empty() ? "" : place + ": ") + problem + (remedy.empty() ? "" : "; " + remedy);
  }
};

template <class Value>
using Result = tl::expected<Value, Error>;

inline tl::unexpected<Error> failure(std::string place, std::string problem, std::string remedy) {
  return tl::unexpected<Error>(Error{std::move(place), std::move(problem), std::move(remedy)});
}

// One that may pass.
inline tl::unexpected<Error> passing_failure(std::string place, std::string problem,
                                             std::string remedy) {
  return tl::unexpected<Error>(
      Error{std::move(place), std::move(problem), std::move(remedy), true});
}

}  // namespace ribbon

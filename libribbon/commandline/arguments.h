// Reading a tool's command line.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "result/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ribbon {

// One option of a tool's command line; copies are the same option.
class Argument {
 public:
  explicit Argument(CLI::Option& option) : option_(&option) {}

  // Was it given? To be asked after parsing.
  [[nodiscard]] bool is_given() const;

  Argument required();
  Argument with_default_shown();
  Argument excludes(Argument other);
  Argument needs(Argument other);
  // Of a text: one of these words.
  Argument one_of(const std::vector<std::string>& words);

 private:
  CLI::Option* option_;
};

// Both included.
template <class Number>
struct Limits {
  Number least, most;
};

// What a user wrote of an option: its first long name, or that of what stands alone, and the
// values.
struct GivenArgument {
  std::string name;  // "--size"
  std::vector<std::string> values;
};

// What a tool can be told. `names` as in "-o,--output", or without dashes for what stands alone;
// `kind` is what --help calls the value, as in "FILE"; `help` one line. Values that are not given
// stay as they were; all must outlive the parsing.
class Arguments {
 public:
  // `examples` stands at the end of --help; `version` is what --version prints.
  Arguments(const std::string& tool, const std::string& description, const std::string& version,
            const std::string& examples);
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;
  ~Arguments();

  Argument add(const std::string& names, std::filesystem::path& file, const std::string& kind,
               const std::string& help);
  Argument add(const std::string& names, std::string& text, const std::string& kind,
               const std::string& help);
  // May be repeated.
  Argument add(const std::string& names, std::vector<std::string>& texts, const std::string& kind,
               const std::string& help);
  // Two values, one after the other.
  Argument add(const std::string& names, std::pair<std::string, std::string>& texts,
               const std::string& kind, const std::string& help);
  Argument add(const std::string& names, int& number, Limits<int> limits, const std::string& kind,
               const std::string& help);
  Argument add(const std::string& names, double& number, Limits<double> limits,
               const std::string& kind, const std::string& help);
  Argument flag(const std::string& names, bool& is_set, const std::string& help);

  // --progress, whose word progress_style() understands.
  Argument add_progress(std::string& word);

  // False when --help or --version was asked for: that has been printed to standard output. Fails
  // when the command line cannot be understood, or a value is empty.
  Result<bool> parse(int argc, const char* const* argv);

  // What was given, in the order in which the options were added. To be asked after parsing.
  [[nodiscard]] std::vector<GivenArgument> given() const;

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace ribbon

#include "commandline/arguments.h"

#include <CLI/CLI.hpp>

#include "text/number_text.h"

namespace ribbon {

bool Argument::is_given() const {
  return option_->count() > 0;
}

Argument Argument::required() {
  option_->required();
  return *this;
}

Argument Argument::with_default_shown() {
  option_->capture_default_str();
  return *this;
}

Argument Argument::excludes(Argument other) {
  option_->excludes(other.option_);
  return *this;
}

Argument Argument::needs(Argument other) {
  option_->needs(other.option_);
  return *this;
}

Argument Argument::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}

namespace {

// What is no number lies within no limits; CLI::Range lets it pass.
template <class Number>
CLI::Validator within(Limits<Number> limits) {
  const auto problem = [limits](const std::string& text) -> std::string {
    Number number{};
    if (CLI::detail::lexical_cast(text, number) && limits.least <= number && number <= limits.most)
      return "";
    return filled_in("'{}' is not a number from {} to {}", text,
                     short_number(static_cast<double>(limits.least), 10),
                     short_number(static_cast<double>(limits.most), 10));
  };
  return {problem, ""};
}

}  // namespace

Arguments::Arguments(const std::string& tool, const std::string& description,
                     const std::string& version, const std::string& examples)
    : app_(std::make_unique<CLI::App>(description, tool)) {
  app_->set_version_flag("--version", tool + " " + version);
  app_->footer(examples);
}

Arguments::~Arguments() = default;

Argument Arguments::add(const std::string& names, std::filesystem::path& file,
                        const std::string& kind, const std::string& help) {
  return Argument(*app_->add_option(names, file, help)->type_name(kind));
}

Argument Arguments::add(const std::string& names, std::string& text, const std::string& kind,
                        const std::string& help) {
  return Argument(*app_->add_option(names, text, help)->type_name(kind));
}

Argument Arguments::add(const std::string& names, std::vector<std::string>& texts,
                        const std::string& kind, const std::string& help) {
  return Argument(*app_->add_option(names, texts, help)->allow_extra_args(false)->type_name(kind));
}

Argument Arguments::add(const std::string& names, std::pair<std::string, std::string>& texts,
                        const std::string& kind, const std::string& help) {
  return Argument(*app_->add_option(names, texts, help)->type_name(kind));
}

Argument Arguments::add(const std::string& names, int& number, Limits<int> limits,
                        const std::string& kind, const std::string& help) {
  return Argument(*app_->add_option(names, number, help)->check(within(limits))->type_name(kind));
}

Argument Arguments::add(const std::string& names, double& number, Limits<double> limits,
                        const std::string& kind, const std::string& help) {
  return Argument(*app_->add_option(names, number, help)->check(within(limits))->type_name(kind));
}

Argument Arguments::flag(const std::string& names, bool& is_set, const std::string& help) {
  return Argument(*app_->add_flag(names, is_set, help));
}

Argument Arguments::add_progress(std::string& word) {
  return add("--progress", word, "STYLE",
             "how far it is: 'line' for people at a terminal, 'json' lines on standard error for "
             "programs")
      .one_of({"line", "json"});
}

Result<bool> Arguments::parse(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& wish) {
    app_->exit(wish);  // prints the help or the version
    return false;
  } catch (const CLI::ParseError& problem) {
    return failure("", problem.what(), "see " + app_->get_name() + " --help");
  }
  // As of a variable that a script did not set.
  for (const CLI::Option* option : app_->get_options())
    for (const std::string& value : option->results())
      if (value.empty())
        return failure(option->get_name(), "is followed by an empty text",
                       "write " + option->get_type_name() + " behind it, or leave it out");
  return true;
}

std::vector<GivenArgument> Arguments::given() const {
  std::vector<GivenArgument> given;
  for (const CLI::Option* option : app_->get_options())
    if (option->count() > 0) given.push_back({option->get_name(), option->results()});
  return given;
}

}  // namespace ribbon

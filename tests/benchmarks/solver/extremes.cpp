// benchmark_extremes [--json FILE] [--most-particles N] [--most-steps N] [--only TEXT]: what
// becomes of scenes whose stiffness, step, size, mass, lengths, place, air or force is extreme, by
// each integrator. Prints the table of docs/measured.md. Exit code 1 when a run ends in something
// that is no number, in an intersection or in an explosion, 2 when something could not be
// read or written.
#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/benchmark_main.h"
#include "benchmarks/outcome.h"
#include "benchmarks/solver/extreme_scenes.h"
#include "text/number_text.h"

namespace ribbon {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string only;  // the extremes whose name holds this text
  int most_particles = 4000;
  int most_steps = std::numeric_limits<int>::max();
};

bool holds(const Outcome& outcome) {
  return outcome.is_finite && !outcome.is_explosion && outcome.intersecting_pairs == 0;
}

std::string without_digits(std::string text) {
  std::erase_if(text, [](char letter) { return letter >= '0' && letter <= '9'; });
  return text;
}

// Sentences that stand below the table; of those that differ in their numbers alone, the first.
class Notes {
 public:
  std::string number_of(const std::string& sentence) {
    const auto is_like = [&](const std::string& other) {
      return without_digits(other) == without_digits(sentence);
    };
    auto found = std::find_if(sentences_.begin(), sentences_.end(), is_like);
    if (found == sentences_.end()) found = sentences_.insert(sentences_.end(), sentence);
    return std::to_string(found - sentences_.begin() + 1);
  }

  void print() const {
    for (std::size_t i = 0; i < sentences_.size(); ++i)
      std::printf("%zu. %s\n", i + 1, sentences_[i].c_str());
  }

 private:
  std::vector<std::string> sentences_;
};

std::string cell(const Outcome& outcome, Notes& notes) {
  if (!outcome.refusal.empty()) return "refused (" + notes.number_of(outcome.refusal) + ")";
  if (!outcome.is_finite) return "no number at step " + std::to_string(outcome.steps);
  std::string text = short_number(100 * outcome.worst_strain, 3) + " / " +
                     short_number(100 * outcome.last_strain, 3) + " %, " +
                     short_number(outcome.energy, 2);
  if (outcome.is_explosion) text += ", explosion";
  if (outcome.intersecting_pairs > 0)
    text += ", " + std::to_string(outcome.intersecting_pairs) + " intersecting pairs";
  return text;
}

Json json(const Outcome& outcome) {
  if (!outcome.refusal.empty()) return {{"refusal", outcome.refusal}};
  return {{"steps", outcome.steps},
          {"finite", outcome.is_finite},
          {"worst_strain", outcome.worst_strain},
          {"last_strain", outcome.last_strain},
          {"energy", outcome.energy},
          {"explosion", outcome.is_explosion},
          {"intersecting_pairs", outcome.intersecting_pairs},
          {"step_time_s", outcome.time_s}};
}

void describe(CLI::App& app, Options& options) {
  app.add_option("--only", options.only, "the extremes whose name holds this")->type_name("TEXT");
  app.add_option("--most-particles", options.most_particles, "no larger ribbons");
  app.add_option("--most-steps", options.most_steps, "of each run");
}

void print_heading() {
  std::string names;
  std::string rule;
  for (const auto& [name, method] : integration_methods) {
    names += " `" + std::string(name) + "` |";
    rule += "---|";
  }
  std::printf("| extreme | steps |%s\n|---|---|%s\n", names.c_str(), rule.c_str());
}

// By each integrator.
std::vector<Outcome> run_all(ExtremeScene extreme, int most_steps) {
  std::vector<Outcome> outcomes;
  for (const auto& [name, method] : integration_methods) {
    extreme.scene.time.integrator = method;
    outcomes.push_back(outcome_of(extreme, most_steps));
  }
  return outcomes;
}

void print(const std::string& extreme, const std::vector<Outcome>& outcomes, Notes& notes) {
  int steps = 0;
  std::string cells;
  for (const Outcome& outcome : outcomes) {
    steps = std::max(steps, outcome.steps);
    cells += " " + cell(outcome, notes) + " |";
  }
  std::printf("| %s | %d |%s\n", extreme.c_str(), steps, cells.c_str());
  std::fflush(stdout);
}

Json json(const std::string& extreme, const std::vector<Outcome>& outcomes) {
  Json row = {{"extreme", extreme}};
  for (std::size_t i = 0; i < integration_methods.size(); ++i)
    row[std::string(integration_methods[i].first)] = json(outcomes[i]);
  return row;
}

Result<Findings> run(const Options& options) {
  Json report = Json::array();
  Notes notes;
  bool all_hold = true;
  print_heading();
  for (const ExtremeScene& extreme : extreme_scenes(options.most_particles)) {
    if (extreme.extreme.find(options.only) == std::string::npos) continue;
    const std::vector<Outcome> outcomes = run_all(extreme, options.most_steps);
    all_hold = all_hold && std::all_of(outcomes.begin(), outcomes.end(), holds);
    print(extreme.extreme, outcomes, notes);
    report.push_back(json(extreme.extreme, outcomes));
  }
  std::puts(
      "\nEach cell: worst strain of any frame / of the last, most energy over what was put in; no\n"
      "intersecting pairs and no explosion where none are named. Refused, with the first "
      "number:\n");
  notes.print();
  return Findings{std::move(report), all_hold ? ExitCode::done : ExitCode::answer_is_no};
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>("benchmark_extremes", argc, argv, ribbon::describe,
                                                 ribbon::run);
}

#include "player/job_options.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace ribbon {

namespace {

// What ribbon-play can be asked for, besides pictures.
constexpr std::array<std::string_view, 7> jobs = {"--sheet",  "--plot",  "--info",  "--json",
                                                  "--verify", "--bench", "--follow"};

constexpr std::string_view any_job = "--sheet --plot --info --json --verify --bench --follow";
constexpr std::string_view by_drawing = "--sheet --bench";
// --info tells how much memory pictures take.
constexpr std::string_view by_drawing_or_forecast = "--sheet --bench --info --json";

struct Row {
  std::string_view option;
  std::string_view looked_at_by;
};

// An option that is added and forgotten here is refused where no pictures are asked for, and never
// silently passed over.
constexpr std::array rows{Row{"RECORDING", any_job},
                          Row{"--threads", any_job},
                          Row{"--isa", any_job},
                          Row{"--quiet", any_job},
                          Row{"--progress", any_job},
                          Row{"--force", "--sheet --plot"},
                          Row{"--frames", "--sheet --plot --verify"},
                          Row{"--certify-every", "--verify"},
                          Row{"--between", "--verify"},
                          Row{"--size", "--bench --info --json"},
                          Row{"--view", by_drawing_or_forecast},
                          Row{"--turns", "--bench"},
                          Row{"--camera-path", "--bench"},
                          Row{"--preview", by_drawing_or_forecast},
                          Row{"--quality", by_drawing_or_forecast},
                          Row{"--samples", by_drawing_or_forecast},
                          Row{"--noise", by_drawing_or_forecast},
                          Row{"--texture", by_drawing_or_forecast},
                          Row{"--texture-back", by_drawing_or_forecast},
                          Row{"--environment", by_drawing_or_forecast},
                          Row{"--backdrop", by_drawing_or_forecast},
                          Row{"--thickness", by_drawing},
                          Row{"--ground", by_drawing},
                          Row{"--sun", by_drawing},
                          Row{"--exposure", by_drawing},
                          Row{"--tone", by_drawing},
                          Row{"--color-by", "--sheet"},
                          Row{"--color-range", "--sheet"}};

bool is_given(const std::vector<GivenArgument>& given, std::string_view name) {
  return std::ranges::find(given, name, &GivenArgument::name) != given.end();
}

std::vector<std::string_view> asked_for(const std::vector<GivenArgument>& given) {
  std::vector<std::string_view> asked;
  for (const std::string_view job : jobs)
    if (is_given(given, job)) asked.push_back(job);
  // There it only says how.
  if (is_given(given, "--verify")) std::erase(asked, "--json");
  return asked;
}

bool is_looked_at(std::string_view option, const std::vector<std::string_view>& asked) {
  if (std::ranges::find(jobs, option) != jobs.end()) return true;
  const auto* const row = std::ranges::find(rows, option, &Row::option);
  return row != rows.end() && std::ranges::any_of(asked, [row](std::string_view job) {
           return row->looked_at_by.find(job) != std::string_view::npos;
         });
}

}  // namespace

Result<void> check_job_options(const std::vector<GivenArgument>& given) {
  const std::vector<std::string_view> asked = asked_for(given);
  if (asked.empty() || is_given(given, "--output")) return {};
  for (const GivenArgument& argument : given) {
    if (is_looked_at(argument.name, asked)) continue;
    std::string by;
    for (const std::string_view job : asked) by.append(by.empty() ? "" : ", ").append(job);
    return failure(argument.name, "is nothing that " + by + " looks at", "leave it out");
  }
  return {};
}

}  // namespace ribbon

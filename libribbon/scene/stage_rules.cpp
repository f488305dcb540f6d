#include "scene/stage_rules.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "scene/held_rows.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

std::string stage_path(std::size_t stage) {
  return "stage[" + std::to_string(stage + 1) + "]";
}

std::string hand_path(std::size_t stage, std::size_t hand) {
  return stage_path(stage) + ".hand[" + std::to_string(hand + 1) + "]";
}

std::string span_text(const Span& span) {
  return shortest(span.begin) + " to " + shortest(span.end);
}

Result<void> force_is_known(const Document& document, const Scene& scene) {
  if (!scene.fastening)
    return failure(document.place(stage_path(0), ""),
                   "[[stage]] needs [fastening], which tells the axis and the speed of its hands",
                   "add '[fastening]' with for example 'speed = 0.3' below it");
  if (document.find("fastening", "pull") != nullptr)
    return failure(document.place("fastening", "pull"),
                   "'pull' in [fastening] is for scenes without stages",
                   "remove it, and write 'pull' below each [[stage.hand]]");
  if (std::ssize(scene.stages) > most_stages)
    return failure(document.place(stage_path(most_stages), ""), "there are too many stages",
                   "write at most " + std::to_string(most_stages));
  return {};
}

Result<void> hand_has_a_task(const Document& document, const std::string& path) {
  std::vector<std::string> tasks;
  for (const std::string task : {"pull", "hold", "carry"})
    if (document.find(path, task) != nullptr) tasks.push_back(task);
  if (tasks.empty())
    return failure(document.place(path, ""),
                   "a hand that neither pulls nor holds nor carries does nothing",
                   "add for example 'pull = [1, 0, 0]', 'pull = \"along\"' or 'hold = true'");
  if (tasks.size() > 1)
    return failure(document.place(path, tasks[1]),
                   "a hand cannot both " + tasks[0] + " and " + tasks[1],
                   "remove " + in_quotes(tasks[0]) + " or " + in_quotes(tasks[1]));
  return {};
}

// Some keys belong to one task.
Result<void> keys_fit_the_task(const Document& document, const HandScene& hand,
                               const std::string& path) {
  if (!pulls(*hand.task) && document.find(path, "yield") != nullptr)
    return failure(document.place(path, "yield"),
                   hand.task == HandTask::hold ? "a hand that holds does not yield"
                                               : "a hand that carries does not yield",
                   "remove 'yield'; the 'speed' of the hand tells how strong it is");
  if (hand.task != HandTask::carry && document.find(path, "height") != nullptr)
    return failure(document.place(path, "height"),
                   "'height' is how high a hand carries its part, but this one carries nothing",
                   "remove it, or write 'carry' with the id of a path in the drawing");
  return {};
}

// A span of one row alone, too.
bool share_rows(const Span& a, const Span& b) {
  if (a.begin == a.end || b.begin == b.end) return a.begin <= b.end && b.begin <= a.end;
  return a.begin < b.end && b.begin < a.end;
}

Result<void> hands_do_not_fight(const Document& document, const StageScene& stage,
                                std::size_t number) {
  for (std::size_t b = 0; b < stage.hands.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const auto* one = std::get_if<Span>(&stage.hands[a].at);
      const auto* other = std::get_if<Span>(&stage.hands[b].at);
      if (one == nullptr || other == nullptr || !share_rows(*one, *other)) continue;
      return failure(document.place(hand_path(number, b), "at"),
                     "two hands of '" + stage.name + "' fight over one part of the band: one has " +
                         span_text(*one) + ", the other " + span_text(*other),
                     "let their spans end where others begin, or remove one of the hands");
    }
  return {};
}

// Two hands of which each has a part may have the same row of a coarse ribbon.
Result<void> hands_have_rows(const Document& document, const Scene& scene, std::size_t number) {
  const StageScene& stage = scene.stages[number];
  std::vector<Span> spans;
  std::vector<std::size_t> hands;
  for (std::size_t i = 0; i < stage.hands.size(); ++i)
    if (const auto* span = std::get_if<Span>(&stage.hands[i].at)) {
      spans.push_back(*span);
      hands.push_back(i);
    }
  const std::vector<HeldRows> rows = held_rows(spans, scene.ribbon.along);
  const auto none =
      std::find_if(rows.begin(), rows.end(), [](const HeldRows& held) { return held.count() < 1; });
  if (none == rows.end()) return {};
  return failure(document.place(hand_path(number, hands[none - rows.begin()]), "at"),
                 "no row of the band is left for this hand: others of '" + stage.name +
                     "' have those at its part",
                 "give it a longer part, or the ribbon more rows ('along')");
}

Result<void> stage_can_end(const Document& document, const StageScene& stage, std::size_t number) {
  const std::string path = stage_path(number);
  if (stage.until_s && stage.at_most_s)
    return failure(document.place(path, "at_most"),
                   "'at_most' is for stages that last until they are tight, or all is carried",
                   "remove it, or write 'until = \"tight\"'");
  const bool is_tightened = stage.goal == StageGoal::tight;
  // All that nobody carries has arrived at once.
  if (stage.until_s || (stage.at_most_s && is_tightened)) return {};
  const bool any_works =
      std::any_of(stage.hands.begin(), stage.hands.end(), [&](const HandScene& hand) {
        return is_tightened ? pulls(*hand.task) : hand.task == HandTask::carry;
      });
  if (any_works) return {};
  return failure(document.place(path, "until"),
                 "'" + stage.name + "' can never reach its goal: " +
                     (is_tightened ? "what nobody pulls never becomes tight"
                                   : "what nobody carries never arrives"),
                 std::string("write how many seconds it lasts, for example 'until = 2', or add a "
                             "hand that ") +
                     (is_tightened ? "pulls" : "carries"));
}

Result<void> stages_fit_in(const Document& document, const Scene& scene) {
  double begins_s = 0;
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    const StageScene& stage = scene.stages[i];
    const double ends_s = begins_s + stage.until_s.value_or(0);
    if (begins_s >= scene.time.duration_s || ends_s > scene.time.duration_s * (1 + 1e-9))
      return failure(document.place(stage_path(i), stage.until_s ? "until" : ""),
                     "'" + stage.name + "' can never end: it begins after " + shortest(begins_s) +
                         " s at the earliest, and the run is over after " +
                         shortest(scene.time.duration_s) + " s",
                     "write a longer 'duration' in [time]");
    begins_s = ends_s;
  }
  return {};
}

}  // namespace

Result<void> check_stages(const Document& document, const Scene& scene) {
  if (scene.stages.empty()) return {};
  Result<void> kept = force_is_known(document, scene);
  for (std::size_t i = 0; i < scene.stages.size() && kept; ++i) {
    const StageScene& stage = scene.stages[i];
    if (stage.hands.empty())
      return failure(document.place(stage_path(i), ""), "'" + stage.name + "' has no hands",
                     "add '[[stage.hand]]' with for example 'at = [0, 0.02]' and 'pull = [1, 0, "
                     "0]' below it");
    for (std::size_t j = 0; j < stage.hands.size() && kept; ++j)
      kept = hand_has_a_task(document, hand_path(i, j)).and_then([&] {
        return keys_fit_the_task(document, stage.hands[j], hand_path(i, j));
      });
    if (kept) kept = hands_do_not_fight(document, stage, i);
    if (kept) kept = hands_have_rows(document, scene, i);
    if (kept) kept = stage_can_end(document, stage, i);
  }
  return kept ? stages_fit_in(document, scene) : kept;
}

}  // namespace ribbon

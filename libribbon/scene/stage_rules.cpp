#include "scene/stage_rules.h"

#include <algorithm>
#include <cstddef>
#include <string>

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
  const bool pulls = document.find(path, "pull") != nullptr;
  const bool holds = document.find(path, "hold") != nullptr;
  if (pulls && holds)
    return failure(document.place(path, "hold"), "a hand cannot both pull and hold",
                   "remove 'pull' or 'hold'");
  if (!pulls && !holds)
    return failure(document.place(path, ""), "a hand that neither pulls nor holds does nothing",
                   "add for example 'pull = [1, 0, 0]', 'pull = \"along\"' or 'hold = true'");
  if (holds && document.find(path, "yield") != nullptr)
    return failure(document.place(path, "yield"), "a hand that holds does not yield",
                   "remove 'yield'; the 'speed' of the hand tells how strong it is");
  return {};
}

Result<void> hands_do_not_fight(const Document& document, const StageScene& stage,
                                std::size_t number) {
  for (std::size_t b = 0; b < stage.hands.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const auto* one = std::get_if<Span>(&stage.hands[a].at);
      const auto* other = std::get_if<Span>(&stage.hands[b].at);
      if (one == nullptr || other == nullptr || one->end <= other->begin ||
          other->end <= one->begin)
        continue;
      return failure(document.place(hand_path(number, b), "at"),
                     "two hands of '" + stage.name + "' fight over one part of the band: one has " +
                         span_text(*one) + ", the other " + span_text(*other),
                     "let their spans end where others begin, or remove one of the hands");
    }
  return {};
}

Result<void> stage_can_end(const Document& document, const StageScene& stage, std::size_t number) {
  const std::string path = stage_path(number);
  if (stage.until_s && stage.at_most_s)
    return failure(document.place(path, "at_most"),
                   "'at_most' is for stages that last until they are tight",
                   "remove it, or write 'until = \"tight\"'");
  const bool any_pulls =
      std::any_of(stage.hands.begin(), stage.hands.end(),
                  [](const HandScene& hand) { return hand.task != HandTask::hold; });
  if (any_pulls || stage.until_s || stage.at_most_s) return {};
  return failure(document.place(path, "until"),
                 "'" + stage.name + "' can never end: what nobody pulls never becomes tight",
                 "write how many seconds it lasts, for example 'until = 2', or add a hand that "
                 "pulls");
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
      kept = hand_has_a_task(document, hand_path(i, j));
    if (kept) kept = hands_do_not_fight(document, stage, i);
    if (kept) kept = stage_can_end(document, stage, i);
  }
  return kept ? stages_fit_in(document, scene) : kept;
}

}  // namespace ribbon

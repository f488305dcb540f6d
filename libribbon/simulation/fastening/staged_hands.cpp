#include "simulation/fastening/staged_hands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <variant>

namespace ribbon {

using Eigen::Matrix3Xd;

namespace {

constexpr double guard_every_s = 0.05;

// The force on all of the band as published, of which hands take their part.
FasteningForce whole_force(const Scene& scene, const RestSize& size, const Cloth& cloth) {
  FasteningScene fastening = *scene.fastening;
  fastening.pull = FasteningPull::distributed;
  return {fastening, scene.air_resistance_per_s, size, cloth.positions, cloth.particle_mass_kg};
}

bool any_pulls_along(const StageScene& stage) {
  return std::any_of(stage.hands.begin(), stage.hands.end(),
                     [](const HandScene& hand) { return hand.task == HandTask::pull_along; });
}

// Each hand that pulls is asked by itself.
std::vector<int> groups_of(const std::vector<StageHand>& hands, const RibbonGrid& grid) {
  std::vector<int> groups(grid.along, -1);
  int group = 0;
  for (const StageHand& hand : hands) {
    if (!hand.pulls()) continue;
    std::fill_n(groups.begin() + hand.rows().first, hand.rows().count(), group);
    ++group;
  }
  return groups;
}

}  // namespace

StagedHands::StagedHands(const Scene& scene, const RestSize& size, const Cloth& cloth)
    : scene_(scene),
      size_(size),
      particle_mass_kg_(cloth.particle_mass_kg),
      along_(whole_force(scene, size, cloth)),
      given_up_(scene.stages.size()),
      begun_(cloth.positions),
      progress_(size.grid, {}, scene.time.step_s, scene.air_resistance_per_s),
      guard_(size.width_m),
      eased_(scene.time.step_s) {
  if (scene.fastening->max_speed_m_s)
    speed_limit_.emplace(*scene.fastening->max_speed_m_s, cloth.particle_mass_kg,
                         scene.air_resistance_per_s, scene.time.step_s);
  take_places();
}

// The hands of the present stage.
void StagedHands::take_places() {
  hands_.clear();
  Scene of_stage = scene_;
  of_stage.gravity_m_s2 = gravity_m_s2();
  std::vector<Span> spans;
  for (const HandScene& hand : present().hands) spans.push_back(std::get<Span>(hand.at));
  const std::vector<HeldRows> rows = held_rows(spans, size_.grid.along);
  for (std::size_t i = 0; i < rows.size(); ++i)
    hands_.emplace_back(present().hands[i], rows[i], of_stage, size_, particle_mass_kg_, begun_);
  progress_ = FasteningProgress(size_.grid, groups_of(hands_, size_.grid), scene_.time.step_s,
                                scene_.air_resistance_per_s);
}

void StagedHands::begin_step(const Cloth& cloth) {
  note_end();  // a take may have less patience
  if (!is_over() || are_over() || guard_.slipping_end()) return;
  ++stage_;
  begin_stage(cloth);
}

void StagedHands::begin_anew(const Cloth& cloth) {
  if (is_over()) begin_stage(cloth);
}

void StagedHands::begin_stage(const Cloth& cloth) {
  is_reached_ = false;
  given_up_[stage_] = false;
  elapsed_s_ = 0;
  begun_ = cloth.positions;
  take_places();
}

void StagedHands::note_end() {
  if (is_over() && !present().until_s && !is_reached_) given_up_[stage_] = true;
}

const Matrix3Xd& StagedHands::pull(const Cloth& cloth) {
  before_ = cloth.positions;
  force_.setZero(3, cloth.particle_count());
  command_.setZero(3, cloth.particle_count());
  grips_.clear();
  force_fraction_ = 0;
  if (are_over() || guard_.slipping_end()) return force_;
  if (any_pulls_along(present())) along_m_s_ = along_.at(cloth.positions) / along_.newton_per_m_s();
  const Workplace place{begun_, along_m_s_, eased_.bearable()};
  int pulling = 0;
  for (StageHand& hand : hands_) {
    if (!hand.pulls()) {
      grips_.push_back(hand.grip(cloth, place));
      continue;
    }
    force_fraction_ += hand.pull(cloth, place, force_, command_);
    ++pulling;
  }
  force_fraction_ = pulling > 0 ? force_fraction_ / pulling : eased_.bearable();
  if (speed_limit_) {
    limit_speeds(*scene_.fastening->max_speed_m_s, command_);
    speed_limit_->apply(cloth.velocities, force_);
  }
  return force_;
}

void StagedHands::follow(const Cloth& cloth) {
  eased_.pull_more();
  if (are_over() || guard_.slipping_end()) return;
  progress_.add(command_, before_, cloth.positions);
  for (StageHand& hand : hands_) hand.follow(cloth);
  elapsed_s_ += scene_.time.step_s;
  is_reached_ = !present().until_s && goal_is_reached();
  note_end();
}

bool StagedHands::is_over() const {
  const auto has_lasted = [this](const std::optional<double>& time_s) {
    return time_s && elapsed_s_ >= *time_s * (1 - 1e-9);
  };
  return present().until_s ? has_lasted(present().until_s)
                           : is_reached_ || has_lasted(present().at_most_s);
}

bool StagedHands::goal_is_reached() const {
  return std::all_of(hands_.begin(), hands_.end(), std::mem_fn(&StageHand::has_arrived)) &&
         (present().goal == StageGoal::carried || progress_.is_at_standstill());
}

bool StagedHands::are_over() const {
  return stage_ + 1 == std::ssize(scene_.stages) && is_over();
}

bool StagedHands::are_done() const {
  return are_over() && !present().until_s && present().goal == StageGoal::tight && is_reached_;
}

double StagedHands::friction() const {
  return present().friction.value_or(scene_.friction);
}

std::optional<Eigen::Vector3d> StagedHands::gravity_m_s2() const {
  const auto& own = present().gravity_m_s2;
  if (!own) return scene_.gravity_m_s2;
  return own->isZero(0) ? std::nullopt : own;
}

std::array<bool, 2> StagedHands::have_ends() const {
  const auto have = [this](int row) {
    return std::any_of(hands_.begin(), hands_.end(), [row](const StageHand& hand) {
      return !hand.pulls() && row >= hand.rows().first && row <= hand.rows().last;
    });
  };
  return {have(0), have(size_.grid.along - 1)};
}

bool StagedHands::guard_is_due() const {
  const auto looks = [](double time_s) { return std::floor(time_s / guard_every_s + 1e-9); };
  return !are_over() && !guard_.slipping_end() &&
         looks(elapsed_s_) > looks(elapsed_s_ - scene_.time.step_s);
}

void StagedHands::visit_state(StateArchive& archive) {
  auto& [scene, size, mass, along, speed_limit, stage, is_reached, given_up, elapsed, begun, hands,
         progress, guard, eased, force_fraction, along_of_step, force_of_step, command_of_step,
         grips_of_step, before_step] = *this;
  along.visit_state(archive);
  archive.visit(stage, 0, static_cast<int>(scene.stages.size()) - 1);
  archive.visit(is_reached);
  for (std::size_t i = 0; i < given_up.size(); ++i) {
    bool one = given_up[i];
    archive.visit(one);
    given_up[i] = one;
  }
  archive.visit(elapsed);
  if (elapsed < 0) archive.refuse("a stage began after it");
  archive.visit(begun);
  eased.visit_state(archive);
  archive.visit(force_fraction);
  if (archive.is_reading()) take_places();
  visit_carrying(archive);
  progress.visit_state(archive);
}

// A take may go on with other hands: what carries the same part goes on from where it was.
void StagedHands::visit_carrying(StateArchive& archive) {
  std::vector<StageHand*> carrying;
  for (StageHand& hand : hands_)
    if (hand.carries()) carrying.push_back(&hand);
  int count = static_cast<int>(carrying.size());
  archive.visit(count, 0, size_.grid.along);
  for (int i = 0; i < count && !archive.is_refused(); ++i) {
    int first_row = archive.is_reading() ? 0 : carrying[i]->rows().first;
    archive.visit(first_row, 0, size_.grid.along - 1);
    const auto same = std::find_if(carrying.begin(), carrying.end(), [&](const StageHand* hand) {
      return hand->rows().first == first_row;
    });
    if (same != carrying.end()) {
      (*same)->visit_state(archive);
      continue;
    }
    double gone_m = 0;
    bool has_arrived = false;
    archive.visit(gone_m);
    archive.visit(has_arrived);
  }
}

void StagedHands::visit_memory(StateArchive& archive) {
  progress_.visit_memory(archive);
  guard_.visit_memory(archive);
}

}  // namespace ribbon

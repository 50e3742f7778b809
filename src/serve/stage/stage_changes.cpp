#include "base/clock.hpp"
#include "base/error.hpp"
#include "serve/stage/stage.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace simreel::serve {

bool Stage::become(std::shared_ptr<Script> script, bool moving) {
  switch (changeBetween(*script_, *script)) {
    case Change::nothing:
    case Change::look:
      if (!framedAlike(*script_, *script)) {
        drawAs(std::move(script));
        return false;
      }
      takeLookOf(*script);
      return false;
    case Change::drawing:
      drawAs(std::move(script));
      return false;
    case Change::dress:
      dressAs(std::move(script));
      return false;
    case Change::simulation:
      break;
  }
  if (moving && started_ && !isNear(*script) && (retuneTo(script) || carryOverTo(script))) return true;
  simulateAs(std::move(script));
  return false;
}

/// True if a stored state is so few steps before the current frame that a drag stays smooth when the steps
/// are computed again.
bool Stage::isNear(const Script& script) const {
  constexpr int fewFrames = 2;
  const frame::WorldState* from = keptBefore(firstOther(storedSimulation_, script) - 1);
  return from != nullptr && world_->frame() - from->frame <= fewFrames;
}

void Stage::resimulate() {
  if (carried_) simulateAs(script_);
}

void Stage::allow(std::size_t memory) {
  memory_ = memory;
  kept_.allow(memory);
  if (past_ && kept_.bytes() + past_->kept.bytes() > memory_) past_.reset();
}

void Stage::startLike(const Stage& other, int frame) {
  if (started_ || other.carried_) return;
  const int last = std::min(frame, firstOther(other.storedSimulation_, *script_) - 1);
  const frame::WorldState* nearest = other.kept_.before(last);
  if (nearest != nullptr) kept_.keep(*nearest);
}

void Stage::takeLookOf(Script& from) {
  // Renderers and world may have been built from different scripts.
  std::set<Script*> all = {script_.get(), worldScript_.get()};
  for (const Drawer& drawer : drawers_)
    if (drawer.script) all.insert(drawer.script.get());
  for (Script* one : all) takeLook(*one, from);
  setTestScene(nullptr);
}

void Stage::drawAs(std::shared_ptr<Script> script) {
  drawers_ = {};
  setTestScene(nullptr);
  script_ = std::move(script);
  forgetBefore();
  follow();
}

/// Rebuilds the world with its current state.
void Stage::dressAs(std::shared_ptr<Script> script) {
  if (!carryOverTo(script)) {
    kept_.clear();  // The stored states do not fit the new world.
    simulateAs(std::move(script));
  }
  drawers_ = {};
}

/// Replaces the world and the script. The renderers remain, because the parts of the scene that they use
/// have not changed.
void Stage::adopt(std::unique_ptr<sim::World> world, std::shared_ptr<Script> script) {
  script_ = std::move(script);
  worldScript_ = script_;
  summaries_ = nullptr;
  world_ = std::move(world);
  summaries_ =
      std::make_unique<frame::Summaries>(*world_, [this](const auto& summary) { keepSummary(summary); });
  setTestScene(nullptr);
  forgetBefore();
  started_ = true;
  ready_ = true;
  follow();
  summaries_->start();
}

/// Continues the current state in the same world with other values. Returns false if that is not possible.
bool Stage::retuneTo(const std::shared_ptr<Script>& script) {
  const std::vector<std::size_t> objects = retunedObjects(*script_, *script);
  for (const std::size_t i : objects)
    if (!world_->retune(i, *script->scene.objects[i].parameters)) return false;
  if (objects.empty()) return false;
  script_ = script;
  carried_ = true;
  setTestScene(nullptr);
  return true;
}

/// Continues the current state in a new world for `script`. Returns false, without any change, if the state
/// does not fit.
bool Stage::carryOverTo(std::shared_ptr<Script> script) {
  if (!started_) {
    simulateAs(std::move(script));
    return true;
  }
  summaries_->takeAll();
  const auto begun = Clock::now();
  const frame::WorldState state = frame::stateOf(*world_);
  auto world = std::make_unique<sim::World>(script->scene);
  try {
    frame::putBack(*world, state.frame, state.parts, state.bytes, "the present state");
  } catch (const UserError&) {
    return false;
  }
  if (script->simulation != script_->simulation) {
    carried_ = true;
    making_ = 1000 * secondsSince(begun);
  }
  adopt(std::move(world), std::move(script));
  return true;
}

/// Builds a world for `script` and continues from a stored state that is still valid. If an exception is
/// thrown, nothing has changed.
void Stage::simulateAs(std::shared_ptr<Script> script) {
  if (started_) summaries_->takeAll();
  const int before = started_ ? world_->frame() : -1;
  auto world = std::make_unique<sim::World>(script->scene);
  if (carried_ || !drawsAlike(*script_, *script)) drawers_ = {};
  keepEqualStates(script);
  script_ = std::move(script);
  setTestScene(nullptr);
  summaries_ = nullptr;
  world_ = std::move(world);
  begin();
  startAtOrigin();
  if (const frame::WorldState* nearest = kept_.before(before)) static_cast<void>(putBack(*nearest));
}

/// Keeps the states of frames before the frame at which the simulations begin to differ. If there are no
/// such states, moves all states to past_, because a change is often undone.
void Stage::keepEqualStates(const std::shared_ptr<Script>& script) {
  const int first = firstOther(storedSimulation_, *script);
  if (kept_.before(first - 1) != nullptr) {
    kept_.forgetFrom(first);
    for (Series& series : series_)
      series.values.erase(series.values.lower_bound(first), series.values.end());
  } else {
    std::optional<Past> back;
    if (past_ && firstOther(past_->of, *script) == farFrame) back = std::move(past_);
    past_.reset();
    if (!kept_.frames().empty()) past_ = Past{storedSimulation_, std::move(kept_), std::move(series_)};
    kept_ = back ? std::move(back->kept) : KeptStates(memory_);
    series_ = back ? std::move(back->series) : std::vector<Series>{};
  }
  storedSimulation_ = simulatedOf(*script);
}

}  // namespace simreel::serve

#include "sim/world/world.hpp"

#include "base/error.hpp"
#include "sim/core/race_checked.hpp"
#include "sim/core/retunable.hpp"
#include "sim/world/state.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

World::World(const scene::Scene& scene, bool timing,
             const std::function<void(long done, long total)>& presteps)
    : state_(std::make_unique<State>(scene, timing, presteps)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::advanceTo(int frame, const Watch& watch, const Stepped& stepped) {
  SIMREEL_CHECK(frame + state_->preroll >= state_->done);
  while (state_->done < frame + state_->preroll) {
    if (state_->onFrameBefore_ && state_->done + 1 == frame + state_->preroll) tellBefore();
    state_->passed = false;
    const double time = (state_->done - state_->preroll) / state_->fps;
    state_->stepping = true;
    state_->startFrame();
    for (std::size_t n = 0; n < state_->groups.size(); ++n) {
      const std::vector<std::size_t>& members = state_->links.order()[n].objects;
      if (state_->groups[n] != nullptr)
        state_->groups[n]->step(
            time, !watch ? StepGroup::Watch()
                         : [&](std::size_t member, int step) { watch(members[member], step); });
      else
        state_->objects[members[0]]->step(
            time, watch ? StepWatch([&](int step) { watch(members[0], step); }) : StepWatch());
      for (const std::size_t i : members)
        if (stepped) stepped(i);
    }
    ++state_->done;
    state_->stepping = false;
    state_->observe();
  }
}

void World::onFrameBefore(std::function<void(const Drawables& before)> callback) {
  state_->onFrameBefore_ = std::move(callback);
}

void World::tellBefore() {
  if (state_->passed) complete();
  do state_->onFrameBefore_(drawables());
  while (grow());
}

void World::advanceUndrawn(int frame) {
  if (state_->done < frame + state_->preroll) state_->passed = true;
  while (state_->done < frame + state_->preroll) {
    state_->stepping = true;
    state_->startFrame();
    for (std::size_t n = 0; n < state_->groups.size(); ++n) {
      const std::size_t first = state_->links.order()[n].objects[0];
      if (state_->groups[n] != nullptr)
        state_->groups[n]->step(time(), {});
      else if (state_->isRead[first])
        state_->objects[first]->step(time(), {});
      else
        state_->objects[first]->pass(time());
    }
    ++state_->done;
    state_->stepping = false;
    state_->observe();
  }
}

bool World::isWhole() const {
  return !state_->stepping;
}

void World::complete() {
  state_->passed = false;
  for (const StepNode& node : state_->links.order())
    for (const std::size_t i : node.objects) state_->objects[i]->resumed(time());
}

void World::visitCheckpointData(CarryOver& carry,
                                const std::function<void(const std::string& object)>& begin) {
  for (std::size_t i = 0; i < state_->objects.size(); ++i) {
    begin(state_->names[i]);
    state_->objects[i]->visitCheckpointData(carry);
  }
  if (state_->lags.empty()) return;
  begin("camera");
  for (Lag& lag : state_->lags) lag.visitCheckpointData(carry);
}

void World::resumeAt(int frame) {
  SIMREEL_CHECK(frame >= firstFrame());
  state_->done = frame + state_->preroll;
  complete();
}

int World::firstFrame() const {
  return -state_->preroll;
}

std::size_t World::objectCount() const {
  return state_->objects.size();
}

const std::string& World::objectName(std::size_t index) const {
  return state_->names.at(index);
}

std::string World::stepName(std::size_t index) const {
  for (const StepNode& node : state_->links.order())
    if (node.objects.size() > 1 &&
        std::find(node.objects.begin(), node.objects.end(), index) != node.objects.end())
      return fmt::format("{} and {} more in contact", objectName(node.objects[0]), node.objects.size() - 1);
  return objectName(index);
}

int World::frame() const {
  return state_->done - state_->preroll;
}

double World::time() const {
  return frame() / state_->fps;
}

Drawables World::drawables() const {
  Drawables all;
  for (std::size_t i = 0; i < state_->objects.size(); ++i) {
    const std::size_t surfaces = all.surfaces.size();
    const std::size_t instances = all.instances.size();
    state_->objects[i]->publish(time(), all);
    const double lastJumpSeconds = state_->objects[i]->jumpedBy(time());
    for (std::size_t k = surfaces; k < all.surfaces.size(); ++k) {
      all.surfaces[k].object = &state_->names[i];
      all.surfaces[k].lastJumpSeconds = lastJumpSeconds;
      if (all.surfaces[k].material->finish.doubleSided) all.surfaces[k].doubleSided = true;
    }
    for (std::size_t k = instances; k < all.instances.size(); ++k)
      all.instances[k].object = &state_->names[i];
    for (sim::Writing& writing : all.writings)
      if (writing.object == nullptr) writing.object = &state_->names[i];
  }
  if (const auto tracked = state_->tracked)
    if (const auto middle = state_->trackedPlace())
      all.places.push_back(
          {&state_->names[*tracked], *middle, state_->objects[*tracked]->jumpedBy(time())});
  if (!state_->tracked)
    for (const Lag& lag : state_->lags)
      if (const auto place = lag.place()) all.dampedCamera.push_back(*place);
  return all;
}

bool World::grow() {
  bool remade = false;
  for (const auto& object : state_->objects) remade = object->grow() || remade;
  return remade;
}

std::vector<World::ArrayName> World::arrays() const {
  return state_->summaries->arrays();
}

std::vector<World::CountNames> World::countNames() const {
  return state_->summaries->countNames();
}

std::vector<std::string> World::races() {
  std::vector<std::string> all;
  for (const auto& object : state_->objects)
    if (auto* checked = dynamic_cast<RaceChecked*>(object.get()))
      for (std::string& line : checked->races(time())) all.push_back(std::move(line));
  return all;
}

const Simulation& World::object(std::size_t index) const {
  return *state_->objects.at(index);
}

bool World::retune(std::size_t index, const scene::Parameters& now) {
  auto* retunable = dynamic_cast<Retunable*>(state_->objects.at(index).get());
  return retunable != nullptr && retunable->retune(now);
}

void World::startSummary() {
  state_->summaries->start(frame());
}

std::optional<World::Summary> World::takeSummary(bool wait) {
  return state_->summaries->next(wait);
}

}  // namespace simreel::sim

#include "sim/world/state.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/path.hpp"
#include "sim/world/list.hpp"
#include "sim/world/port_check.hpp"
#include "sim/world/setup.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace simreel::sim {

World::State::State(const scene::Scene& scene, bool timing, const std::function<void(long, long)>& presteps)
    : fps(scene.time.fps),
      preroll(prerollOf(scene)),
      bones(scene),
      colliders(collidersOf(scene, &bones)),
      links(scene.objects, [this] { return now(); }),
      objects(links.simulations()),
      camera(scene.camera),
      picture{scene.render.size, &camera} {
  if (const auto mistakes = portMistakes(scene); !mistakes.empty())
    throw UserError(ExitCode::usage, mistakes.front());
  Setting setting{scene.numerics == scene::Numerics::fast, scene.seed, 1.0 / scene.time.fps, &colliders,
                  timing};
  setting.aspect = static_cast<float>(scene.render.size.x) / static_cast<float>(scene.render.size.y);
  for (const std::string& remark : scene.remarks) warnLinesOnce(remark);
  for (const std::string& remark : portRemarks(scene)) warn("{}", remark);
  if (scene.objects.empty())
    warn("the scene has no objects, so the picture is empty; add for example {}",
         R"("objects": {"ball": {"sphere": {}}})");
  setting.links = &links;
  setting.startTime = startOf(scene);
  setting.presteps = presteps;
  for (const scene::Object& object : scene.objects) names.push_back(object.name);
  links.provide(&bones);
  links.provide(&picture);
  makeMeshes(scene);
  makeObjects(scene, setting);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (scene.camera.track && scene.camera.track->object == names[i]) tracked = i;
  findRead(scene);
  startFrame();
  summaries = std::make_unique<SummaryQueue>(objects, names);
  makeLags(setting.frameSeconds);
  findObservers(scene);
  observe();
}

void World::State::makeLags(double frameSeconds) {
  const double damping = tracked         ? camera.track->damping
                         : camera.follow ? camera.follow->damping
                                         : camera.damping;
  if (damping > 0) lags.assign(camera.follow ? 2 : 1, Lag(damping, frameSeconds));
}

void World::State::findObservers(const scene::Scene& scene) {
  std::set<std::size_t> seen;
  const auto see = [&](const std::string& object) {
    seen.insert(static_cast<std::size_t>(std::find(names.begin(), names.end(), object) - names.begin()));
  };
  if (!lags.empty() && tracked) seen.insert(*tracked);
  if (!lags.empty() && camera.follow) see(camera.follow->object);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    auto* observer = dynamic_cast<FrameObserver*>(objects[i].get());
    if (observer == nullptr) continue;
    observers.push_back(observer);
    for (const Ports::Want& want : portsOf(scene.objects[i]).wants)
      if (want.when == When::afterFrame) see(PartName(want.name).object);
  }
  observed.assign(seen.begin(), seen.end());
}

std::optional<glm::vec3> World::State::trackedPlace() const {
  if (!lags.empty()) return lags.front().place();
  return objects[*tracked]->middle(now());
}

std::vector<glm::vec3> World::State::ahead() const {
  if (tracked) {
    const auto place = objects[*tracked]->middle(now());
    return place ? std::vector<glm::vec3>{*place} : std::vector<glm::vec3>();
  }
  if (!camera.follow) return {camera.target.at(now())};
  Drawables all;
  for (const auto& object : objects) object->publish(now(), all);
  const Path* path = pathOf(all, camera.follow->object);
  if (path == nullptr) return {};
  const Stand stand = standOn(*path->points, *camera.follow, now());
  return {stand.target, stand.eye};
}

void World::State::observe() {
  for (const std::size_t i : observed) {
    if (passed) objects[i]->resumed(now());
    do {
      Drawables unseen;
      objects[i]->publish(now(), unseen);
    } while (objects[i]->grow());
  }
  for (FrameObserver* observer : observers) observer->observe(now());
  if (lags.empty()) return;
  const std::vector<glm::vec3> places = ahead();
  for (std::size_t i = 0; i < lags.size(); ++i)
    if (i < places.size())
      lags[i].follow(glm::dvec3(places[i]));
    else
      lags[i].lose();
}

void World::State::findRead(const scene::Scene& scene) {
  isRead.resize(names.size());
  for (const scene::Object& object : scene.objects)
    for (const Ports::Want& want : portsOf(object).wants)
      for (std::size_t i = 0; i < names.size(); ++i)
        if (want.when == When::frameStart && PartName(want.name).object == names[i]) isRead[i] = true;
  for (const StepNode& node : links.order())
    for (const std::size_t i : node.objects)
      if (auto* starter = dynamic_cast<FrameStarter*>(objects[i].get())) starters.push_back(starter);
}

void World::State::startFrame() const {
  for (FrameStarter* starter : starters) starter->frameStarts();
}

void World::State::makeMeshes(const scene::Scene& scene) {
  const double reach = meshReach(scene);
  if (reach < 0) return;
  MeshColliderPlan plan(scene, reach);
  if (plan.count() == 0) return;
  meshes = std::make_unique<DistanceFields>(std::move(plan));
  links.provide(meshes.get());
}

void World::State::makeObjects(const scene::Scene& scene, Setting& setting) {
  for (const StepNode& node : links.order()) {
    for (const std::size_t i : node.objects) {
      const scene::Object& object = scene.objects[i];
      namingObject(object, [&] { links.made(i, simulationNamed(object.kind).make(object, setting)); });
    }
    groups.push_back(node.group == nullptr ? nullptr : makeGroup(scene, node, setting));
  }
}

std::unique_ptr<StepGroup> World::State::makeGroup(const scene::Scene& scene, const StepNode& node,
                                                   const Setting& setting) {
  int steps = 0;
  for (const std::size_t i : node.objects) steps = std::max(steps, objects[i]->stepsPerFrame());
  links.setSteps(*node.group, steps);
  std::vector<void*> members;
  for (const std::size_t i : node.objects) {
    if (objects[i]->stepsPerFrame() != steps)
      links.made(i, simulationNamed(scene.objects[i].kind).make(scene.objects[i], setting));
    members.push_back(links.find(*node.group, names[i]));
  }
  return node.group->group(setting, members, steps);
}

}  // namespace simreel::sim

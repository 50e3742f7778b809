#include "sim/world/state.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "sim/core/path.hpp"
#include "sim/world/list.hpp"
#include "sim/world/relations.hpp"
#include "sim/world/setup.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

namespace simreel::sim {

World::State::State(const scene::Scene& scene, bool timing, const std::function<void(long, long)>& presteps)
    : fps(scene.time.fps),
      preroll(prerollOf(scene)),
      bones(scene),
      colliders(collidersOf(scene, &bones)),
      objects(scene.objects.size()),
      order(stepOrder(scene)),
      camera(scene.camera) {
  if (const auto mistakes = relationMistakes(scene); !mistakes.empty())
    throw UserError(ExitCode::usage, mistakes.front());
  Setting setting{scene.numerics == scene::Numerics::fast, scene.seed, 1.0 / scene.time.fps, &colliders,
                  timing};
  setting.clothsInContact = hasClothsInContact(scene);
  for (const std::string& remark : scene.remarks) warnLinesOnce(remark);
  for (const std::string& remark : relationRemarks(scene)) warn("{}", remark);
  setting.startTime = startOf(scene);
  setting.presteps = presteps;
  for (const scene::Object& object : scene.objects) {
    names.push_back(object.name);
    quantities.emplace_back();
    for (const scene::Quantity& quantity : object.parameters->quantities())
      quantities.back().emplace_back(quantity.name);
  }
  setting.quantityNamed = [this](const std::string& name, const std::string& quantity) {
    return quantityNamed(name, quantity);
  };
  setting.fieldNamed = [this](const std::string& name) { return fieldNamed(name); };
  setting.wallsNamed = [this](const std::string& name) -> const Walls& { return wallsNamed(name); };
  setting.windNamed = [this](const std::string& name) -> const FluidWind& { return windNamed(name); };
  setting.skinNamed = [this](const std::string& name) -> SkinnedSurface& { return skinNamed(name); };
  setting.heldBySkin = [this](const std::string& body, std::span<const glm::dvec3> points, double time) {
    return bones.heldBySkin(body, points, time);
  };
  setting.boneNamed = [this](const std::string& body, const std::string& bone) {
    return bones.named(body, bone);
  };
  makeFields(scene);
  setting.meshes = meshes.get();
  for (const std::size_t i : order) {
    objects[i] = simulationNamed(scene.objects[i].kind).make(scene.objects[i], setting);
    if (objects[i]->heights() != nullptr) setting.heights = objects[i]->heights();
  }
  keepInStep(scene, setting);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (scene.camera.track && scene.camera.track->object == names[i]) tracked = i;
  findRead(scene);
  readOthers();
  summaries = std::make_unique<SummaryQueue>(objects, names);
  makeLags(setting.frameSeconds);
  findObservers();
  observe();
}

void World::State::makeLags(double frameSeconds) {
  const double damping = tracked         ? camera.track->damping
                         : camera.follow ? camera.follow->damping
                                         : camera.damping;
  if (damping > 0) lags.assign(camera.follow ? 2 : 1, Lag(damping, frameSeconds));
}

void World::State::findObservers() {
  std::set<std::size_t> seen;
  if (!lags.empty() && tracked) seen.insert(*tracked);
  if (!lags.empty() && camera.follow)
    for (std::size_t i = 0; i < names.size(); ++i)
      if (camera.follow->object == names[i]) seen.insert(i);
  for (const auto& object : objects) {
    auto* observer = dynamic_cast<FrameObserver*>(object.get());
    if (observer == nullptr) continue;
    observers.push_back(observer);
    for (const std::string& name : observer->observed())
      seen.insert(static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
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

bool World::State::isOf(const std::string& field, const std::string& object) {
  return field == object || field.starts_with(object + ".");
}

void World::State::findRead(const scene::Scene& scene) {
  isRead.resize(names.size());
  for (std::size_t k = 0; k < names.size(); ++k)
    if (const auto* reading = dynamic_cast<const FieldReading*>(scene.objects[k].parameters.get()))
      for (const FieldReading::From& from : reading->readsFields())
        for (std::size_t i = 0; i < names.size(); ++i) {
          if (!isOf(from.name, names[i])) continue;
          isRead[i] = true;
          auto* reader = dynamic_cast<FieldReader*>(objects[k].get());
          const auto* owner = dynamic_cast<const FieldParts*>(scene.objects[i].parameters.get());
          if (reader != nullptr && owner != nullptr) reader->meets(from.name, *owner);
        }
  for (const std::size_t i : order)
    if (auto* reader = dynamic_cast<FieldReader*>(objects[i].get())) readers.push_back(reader);
}

void World::State::readOthers() const {
  for (FieldReader* reader : readers) reader->readOthers();
}

void World::State::makeFields(const scene::Scene& scene) {
  const double reach = meshReach(scene);
  if (reach < 0) return;
  MeshColliderPlan plan(scene, reach);
  if (plan.count() > 0) meshes = std::make_unique<DistanceFields>(std::move(plan));
}

void World::State::keepInStep(const scene::Scene& scene, Setting& setting) {
  for (const bool balls : {false, true})  // which come last
    for (const std::size_t i : order)
      if (LockStep* member = objects[i]->lockStep(); member != nullptr && member->isOfBalls() == balls) {
        touching.push_back(i);
        setting.contactSubsteps = std::max(setting.contactSubsteps, objects[i]->stepsPerFrame());
      }
  if (touching.empty()) return;
  std::vector<LockStep*> members;
  for (const std::size_t i : touching) {
    if (objects[i]->stepsPerFrame() != setting.contactSubsteps)
      objects[i] = simulationNamed(scene.objects[i].kind).make(scene.objects[i], setting);
    members.push_back(objects[i]->lockStep());
  }
  std::vector<ContactSolid*> solids;
  for (const std::size_t i : order)
    if (ContactSolid* solid = objects[i]->solid()) solids.push_back(solid);
  contact = std::make_unique<ContactGroup>(members, solids, setting.contactSubsteps, setting.frameSeconds,
                                           setting.fast);
}

bool World::State::isTouching(std::size_t object) const {
  return std::find(touching.begin(), touching.end(), object) != touching.end();
}

Field World::State::fieldNamed(const std::string& name) const {
  Drawables drawables;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i] && isOf(name, names[i])) objects[i]->publish((done - preroll) / fps, drawables);
  for (const Field& field : drawables.fields)
    if (*field.name == name) return field;
  fail(ExitCode::usage, "no object has a field named \"{}\"", name);
}

double World::State::quantityNamed(const std::string& name, const std::string& quantity) const {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i] || name != names[i]) continue;
    const auto& known = quantities[i];
    const auto found = std::find(known.begin(), known.end(), quantity);
    if (found != known.end())
      return objects[i]->measure().at(static_cast<std::size_t>(found - known.begin()));
  }
  fail(ExitCode::usage, "no object \"{}\" measures \"{}\"", name, quantity);
}

const Walls& World::State::wallsNamed(const std::string& name) const {
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i] && name == names[i])
      if (const Walls* walls = objects[i]->walls()) return *walls;
  fail(ExitCode::usage, "no object named \"{}\" has walls", name);
}

const FluidWind& World::State::windNamed(const std::string& name) const {
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i] && name == names[i])
      if (const FluidWind* wind = objects[i]->wind()) return *wind;
  fail(ExitCode::usage, "no object named \"{}\" is a fluid", name);
}

SkinnedSurface& World::State::skinNamed(const std::string& name) const {
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i] && name == names[i])
      if (SkinnedSurface* skin = objects[i]->skin()) return *skin;
  fail(ExitCode::usage, "no object named \"{}\" is a body", name);
}

}  // namespace simreel::sim

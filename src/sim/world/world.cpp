#include "sim/world/world.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "sim/body/bones.hpp"
#include "sim/collide/distance_fields.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/core/field_reader.hpp"
#include "sim/core/frame_observer.hpp"
#include "sim/core/path.hpp"
#include "sim/core/retunable.hpp"
#include "sim/world/lag.hpp"
#include "sim/world/list.hpp"
#include "sim/world/relations.hpp"
#include "sim/world/setup.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

struct World::State {
  double fps;
  int preroll;
  int done = 0;  ///< frames simulated, the pre-roll's included
  Bones bones;
  std::vector<ColliderShape> colliders;
  std::unique_ptr<DistanceFields> meshes;  ///< of the rigid meshes that collide, where something may touch
  std::vector<std::unique_ptr<Simulation>> objects;
  std::vector<std::size_t> touching;  ///< objects that are in contact, in their order
  std::unique_ptr<ContactGroup> contact;
  std::vector<std::size_t> order;  ///< in which objects are made and stepped
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> quantities;  ///< that each object measures
  std::optional<std::size_t> tracked;                ///< the object that the camera looks at
  std::vector<FieldReader*> readers;  ///< objects that take in fields of others before each frame
  std::vector<bool> isRead;           ///< whether an object is one of these others
  scene::Camera camera;
  std::vector<Lag> lags;  ///< of the camera behind what it looks at, and behind where it would stand
  std::vector<FrameObserver*> observers;  ///< among the objects
  std::vector<std::size_t> observed;      ///< objects that these, or the lag, look at
  std::unique_ptr<SummaryQueue> summaries;
  std::function<void(const Drawables& before)> hearBefore;
  bool passed = false;  ///< whether nobody may look at the present frame

  State(const scene::Scene& scene, bool timing, const std::function<void(long, long)>& presteps)
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
      if (scene.camera.tracks && scene.camera.track.object == names[i]) tracked = i;
    findRead(scene);
    readOthers();
    summaries = std::make_unique<SummaryQueue>(objects, names);
    makeLags(setting.frameSeconds);
    findObservers();
    observe();
  }

  void makeLags(double frameSeconds) {
    const double damping = tracked          ? camera.track.damping
                           : camera.follows ? camera.follow.damping
                                            : camera.damping;
    if (damping > 0) lags.assign(camera.follows ? 2 : 1, Lag(damping, frameSeconds));
  }

  /// Who notes something of every frame, and of which objects.
  void findObservers() {
    std::set<std::size_t> seen;
    if (!lags.empty() && tracked) seen.insert(*tracked);
    if (!lags.empty() && camera.follows)
      for (std::size_t i = 0; i < names.size(); ++i)
        if (camera.follow.object == names[i]) seen.insert(i);
    for (const auto& object : objects) {
      auto* observer = dynamic_cast<FrameObserver*>(object.get());
      if (observer == nullptr) continue;
      observers.push_back(observer);
      for (const std::string& name : observer->observed())
        seen.insert(static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
    }
    observed.assign(seen.begin(), seen.end());
  }

  [[nodiscard]] double now() const { return (done - preroll) / fps; }

  /// What the camera looks at, which may lag behind its object.
  [[nodiscard]] std::optional<glm::vec3> trackedPlace() const {
    if (!lags.empty()) return lags.front().place();
    return objects[*tracked]->middle(now());
  }

  /// What the lags go after in this frame, as sim::Drawables::lagging has it; empty while it is not there.
  [[nodiscard]] std::vector<glm::vec3> ahead() const {
    if (tracked) {
      const auto place = objects[*tracked]->middle(now());
      return place ? std::vector<glm::vec3>{*place} : std::vector<glm::vec3>();
    }
    if (!camera.follows) return {camera.target.at(now())};
    Drawables all;
    for (const auto& object : objects) object->publish(now(), all);
    const Path* path = pathOf(all, camera.follow.object);
    if (path == nullptr) return {};
    const Stand stand = standOn(*path->points, camera.follow, now());
    return {stand.target, stand.eye};
  }

  /// Tells those who note something of every frame. What they look at is as it is drawn, and what is made
  /// only to be drawn is made here, so that it does not matter which frames are.
  void observe() {
    for (const std::size_t i : observed) {
      if (passed) objects[i]->resumed(now());
      do {
        Drawables unseen;
        objects[i]->publish(now(), unseen);
      } while (objects[i]->settle());
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

  [[nodiscard]] static bool isOf(const std::string& field, const std::string& object) {
    return field == object || field.starts_with(object + ".");
  }

  void findRead(const scene::Scene& scene) {
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

  void readOthers() const {
    for (FieldReader* reader : readers) reader->readOthers();
  }

  void makeFields(const scene::Scene& scene) {
    const double reach = meshReach(scene);
    if (reach < 0) return;
    MeshColliderPlan plan(scene, reach);
    if (plan.count() > 0) meshes = std::make_unique<DistanceFields>(std::move(plan));
  }

  /// All that are in contact take as many substeps as the one that needs most.
  void keepInStep(const scene::Scene& scene, Setting& setting) {
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

  [[nodiscard]] bool isTouching(std::size_t object) const {
    return std::find(touching.begin(), touching.end(), object) != touching.end();
  }

  /// As its object publishes it.
  [[nodiscard]] Field fieldNamed(const std::string& name) const {
    Drawables drawables;
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (objects[i] && isOf(name, names[i])) objects[i]->publish((done - preroll) / fps, drawables);
    for (const Field& field : drawables.fields)
      if (*field.name == name) return field;
    fail(ExitCode::usage, "no object has a field named \"{}\"", name);
  }

  [[nodiscard]] double quantityNamed(const std::string& name, const std::string& quantity) const {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (!objects[i] || name != names[i]) continue;
      const auto& known = quantities[i];
      const auto found = std::find(known.begin(), known.end(), quantity);
      if (found != known.end())
        return objects[i]->measure().at(static_cast<std::size_t>(found - known.begin()));
    }
    fail(ExitCode::usage, "no object \"{}\" measures \"{}\"", name, quantity);
  }

  [[nodiscard]] const Walls& wallsNamed(const std::string& name) const {
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (objects[i] && name == names[i])
        if (const Walls* walls = objects[i]->walls()) return *walls;
    fail(ExitCode::usage, "no object named \"{}\" has walls", name);
  }

  [[nodiscard]] const FluidWind& windNamed(const std::string& name) const {
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (objects[i] && name == names[i])
        if (const FluidWind* wind = objects[i]->wind()) return *wind;
    fail(ExitCode::usage, "no object named \"{}\" is a fluid", name);
  }

  [[nodiscard]] SkinnedSurface& skinNamed(const std::string& name) const {
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (objects[i] && name == names[i])
        if (SkinnedSurface* skin = objects[i]->skin()) return *skin;
    fail(ExitCode::usage, "no object named \"{}\" is a body", name);
  }
};

World::World(const scene::Scene& scene, bool timing,
             const std::function<void(long done, long total)>& presteps)
    : state_(std::make_unique<State>(scene, timing, presteps)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::advanceTo(int frame, const Watch& watch, const Stepped& stepped) {
  SIMREEL_CHECK(frame + state_->preroll >= state_->done);
  while (state_->done < frame + state_->preroll) {
    if (state_->hearBefore && state_->done + 1 == frame + state_->preroll) tellBefore();
    state_->passed = false;
    const double time = (state_->done - state_->preroll) / state_->fps;
    state_->readOthers();
    for (const std::size_t i : state_->order) {
      if (state_->isTouching(i)) continue;
      const StepWatch one = watch ? StepWatch([&](int step) { watch(i, step); }) : StepWatch();
      state_->objects[i]->step(time, one);
      if (stepped) stepped(i);
    }
    if (state_->contact != nullptr) {
      state_->contact->step(
          time, !watch ? ContactGroup::Watch()
                       : [&](std::size_t member, int step) { watch(state_->touching[member], step); });
      for (const std::size_t i : state_->touching)
        if (stepped) stepped(i);
    }
    ++state_->done;
    state_->observe();
  }
}

void World::onFrameBefore(std::function<void(const Drawables& before)> hear) {
  state_->hearBefore = std::move(hear);
}

void World::tellBefore() {
  if (state_->passed) show();
  do state_->hearBefore(drawables());
  while (settle());
}

void World::passTo(int frame) {
  if (state_->done < frame + state_->preroll) state_->passed = true;
  while (state_->done < frame + state_->preroll) {
    state_->readOthers();
    for (const std::size_t i : state_->order) {
      if (state_->isTouching(i)) continue;
      if (state_->isRead[i])
        state_->objects[i]->step(time(), {});
      else
        state_->objects[i]->pass(time());
    }
    if (state_->contact) state_->contact->step(time(), {});
    ++state_->done;
    state_->observe();
  }
}

void World::show() {
  state_->passed = false;
  for (const std::size_t i : state_->order) state_->objects[i]->resumed(time());
}

void World::carryOver(CarryOver& carry, const std::function<void(const std::string& object)>& begin) {
  for (std::size_t i = 0; i < state_->objects.size(); ++i) {
    begin(state_->names[i]);
    state_->objects[i]->carryOver(carry);
  }
  if (state_->lags.empty()) return;
  begin("camera");
  for (Lag& lag : state_->lags) lag.carryOver(carry);
}

void World::resumeAt(int frame) {
  SIMREEL_CHECK(frame >= firstFrame());
  state_->done = frame + state_->preroll;
  show();
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
  const auto& group = state_->touching;
  if (group.size() < 2 || !state_->isTouching(index)) return objectName(index);
  return fmt::format("{} and {} more in contact", objectName(group[0]), group.size() - 1);
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
    for (std::size_t k = surfaces; k < all.surfaces.size(); ++k) {
      all.surfaces[k].object = &state_->names[i];
      if (all.surfaces[k].material->finish.doubleSided) all.surfaces[k].doubleSided = true;
    }
    for (std::size_t k = instances; k < all.instances.size(); ++k)
      all.instances[k].object = &state_->names[i];
    for (sim::Writing& writing : all.writings)
      if (writing.object == nullptr) writing.object = &state_->names[i];
  }
  if (const auto tracked = state_->tracked)
    if (const auto middle = state_->trackedPlace())
      all.places.push_back({&state_->names[*tracked], *middle});
  if (!state_->tracked)
    for (const Lag& lag : state_->lags)
      if (const auto place = lag.place()) all.lagging.push_back(*place);
  return all;
}

bool World::settle() {
  bool remade = false;
  for (const auto& object : state_->objects) remade = object->settle() || remade;
  return remade;
}

std::vector<World::ArrayName> World::arrays() const {
  return state_->summaries->arrays();
}

std::vector<World::CountNames> World::countNames() const {
  return state_->summaries->countNames();
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
  return state_->summaries->take(wait);
}

}  // namespace simreel::sim

#include "sim/world/world.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/element_array.hpp"
#include "gl/errors.hpp"
#include "sim/body/bones.hpp"
#include "sim/collide/distance_fields.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/core/state_hash.hpp"
#include "sim/world/list.hpp"
#include "sim/world/relations.hpp"
#include "sim/world/setup.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Hash sums and loss report of one frame: 16 bytes for each state array, and 16 bytes of status for each
/// object.
struct Pending {
  int frame;
  int slot;
  GLsync fence;
  std::vector<int> countRows;  ///< elements of each object that counts
};

}  // namespace

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
  std::vector<bool> remarked;  ///< of each object, whether its remark was made
  std::vector<ArrayName> arrays;

  StateHash hash;
  gl::Buffer sums;  ///< uvec4 per array
  // What the CPU reads is copied into memory of its own: reading a buffer of the device's would wait for
  // all frames that are under way.
  gl::Buffer sumCopies;  ///< uvec4 per array per slot
  gl::Buffer statuses;   ///< uvec4 per object per slot
  /// Objects that count, and the first of their rows in a slot of countCopies.
  struct Counting {
    std::size_t object;
    std::size_t firstRow;
  };
  std::vector<Counting> counting;
  std::size_t countRowsOfSlot = 0;
  gl::Buffer countCopies;  ///< uvec4 per step of a frame per slot
  std::deque<Pending> pending;
  int nextSlot = 0;

  State(const scene::Scene& scene, bool timing, const std::function<void(long, long)>& presteps)
      : fps(scene.time.fps),
        preroll(prerollOf(scene)),
        bones(scene),
        colliders(collidersOf(scene, &bones)),
        objects(scene.objects.size()),
        order(stepOrder(scene)),
        remarked(scene.objects.size()) {
    if (const auto mistakes = relationMistakes(scene); !mistakes.empty())
      throw UserError(ExitCode::usage, mistakes.front());
    Setting setting{scene.numerics == scene::Numerics::fast, scene.seed, 1.0 / scene.time.fps, &colliders,
                    timing};
    setting.clothsInContact = hasClothsInContact(scene);
    for (const std::string& remark : relationRemarks(scene)) warn("{}", remark);
    setting.startTime = startOf(scene);
    setting.presteps = presteps;
    for (const scene::Object& object : scene.objects) names.push_back(object.name);
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
    for (std::size_t i = 0; i < objects.size(); ++i)
      for (const StateArray& array : objects[i]->state())
        arrays.push_back(
            {scene.objects[i].name, array.name, static_cast<long>(array.buffer->bytes() / 16)});
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (objects[i]->counts().steps != nullptr) {
        counting.push_back({i, countRowsOfSlot});
        countRowsOfSlot += objects[i]->counts().steps->bytes() / 16;
      }
    const auto copies = [](const char* label, std::size_t rows) {
      return gl::Buffer::mapped(label, rows * maxSummaries * 16, false);
    };
    countCopies = copies("copies of counts", countRowsOfSlot);
    sums = gl::Buffer("state hash sums", std::max<std::size_t>(1, arrays.size()) * 16);
    sumCopies = copies("copies of state hash sums", arrays.size());
    statuses = copies("status copies", objects.size());
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

  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    for (const Pending& p : pending) glDeleteSync(p.fence);
  }

  [[nodiscard]] bool isTouching(std::size_t object) const {
    return std::find(touching.begin(), touching.end(), object) != touching.end();
  }

  /// As its object publishes it.
  [[nodiscard]] Field fieldNamed(const std::string& name) const {
    Drawables drawables;
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (objects[i] && (name == names[i] || name.starts_with(names[i] + ".")))
        objects[i]->publish((done - preroll) / fps, drawables);
    for (const Field& field : drawables.fields)
      if (*field.name == name) return field;
    fail(ExitCode::usage, "no object has a field named \"{}\"", name);
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

  void start(int frame) {
    SIMREEL_CHECK(pending.size() < maxSummaries);
    const int slot = nextSlot;
    nextSlot = (nextSlot + 1) % maxSummaries;
    const std::vector<unsigned> zero(4 * arrays.size());
    sums.write(0, std::as_bytes(std::span(zero)));
    gl::barrier();
    std::size_t array = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      for (const StateArray& state : objects[i]->state()) {
        hash.add(*state.buffer, array, sums, array);
        ++array;
      }
      if (const gl::Buffer* status = objects[i]->status()) {
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glCopyNamedBufferSubData(status->name(), statuses.name(), 0, statusOffset(slot, i), 16);
      }
    }
    const std::vector<int> countRows = copyCounts(slot);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    if (!arrays.empty())
      glCopyNamedBufferSubData(sums.name(), sumCopies.name(), 0, static_cast<GLintptr>(sumOffset(slot)),
                               static_cast<GLsizeiptr>(arrays.size()) * 16);
    pending.push_back({frame, slot, glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0), countRows});
    glFlush();
  }

  /// Returns how many elements each object has.
  [[nodiscard]] std::vector<int> copyCounts(int slot) const {
    std::vector<int> rows;
    if (!counting.empty()) glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    for (const Counting& c : counting) {
      const CountTable table = objects[c.object]->counts();
      glCopyNamedBufferSubData(table.steps->name(), countCopies.name(), 0,
                               static_cast<GLintptr>(countOffset(slot, c)),
                               static_cast<GLsizeiptr>(table.rows) * table.elements * 16);
      rows.push_back(table.rows * table.elements);
    }
    return rows;
  }

  [[nodiscard]] std::size_t countOffset(int slot, const Counting& counts) const {
    return (static_cast<std::size_t>(slot) * countRowsOfSlot + counts.firstRow) * 16;
  }

  /// Of a mapped buffer, behind a fence.
  static void copyOut(const gl::Buffer& from, std::size_t offset, std::span<std::byte> to) {
    SIMREEL_CHECK(offset + to.size() <= from.bytes());
    const std::byte* first = static_cast<const std::byte*>(from.memory()) + offset;
    std::copy(first, first + to.size(), to.begin());
  }

  void readCounts(const Pending& from, Summary& summary) const {
    for (std::size_t i = 0; i < counting.size(); ++i) {
      auto& rows = summary.counts.emplace_back(static_cast<std::size_t>(from.countRows[i]));
      if (!rows.empty())
        copyOut(countCopies, countOffset(from.slot, counting[i]), std::as_writable_bytes(std::span(rows)));
    }
  }

  [[nodiscard]] std::size_t sumOffset(int slot) const {
    return static_cast<std::size_t>(slot) * arrays.size() * 16;
  }

  [[nodiscard]] GLintptr statusOffset(int slot, std::size_t object) const {
    return static_cast<GLintptr>((static_cast<std::size_t>(slot) * objects.size() + object) * 16);
  }

  void checkStatus(int frame, int slot) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (objects[i]->status() == nullptr) continue;
      unsigned words[4] = {};
      copyOut(statuses, static_cast<std::size_t>(statusOffset(slot, i)),
              std::as_writable_bytes(std::span(words)));
      if (words[0] != 0xffffffffU)
        throw UserError(ExitCode::device, objects[i]->explainLoss(words[0], words[1]));
      if (words[2] == 0 || remarked[i]) continue;
      remarked[i] = true;
      warn("{}", objects[i]->remark(frame));
    }
  }

  /// The hash of all state is the sum of its arrays' hashes, word by word.
  [[nodiscard]] Summary summary(int frame, int slot) const {
    std::vector<glm::uvec4> words(arrays.size());
    copyOut(sumCopies, sumOffset(slot), std::as_writable_bytes(std::span(words)));
    Summary result{frame, {}, {}, {}};
    glm::uvec4 total(0);
    for (const glm::uvec4& w : words) {
      total += w;
      result.arrays.push_back(StateHash::text(w));
    }
    result.stateHash = StateHash::text(total);
    return result;
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
  for (; state_->done < frame + state_->preroll; ++state_->done) {
    const double time = (state_->done - state_->preroll) / state_->fps;
    for (const std::size_t i : state_->order) {
      if (state_->isTouching(i)) continue;
      const StepWatch one = watch ? StepWatch([&](int step) { watch(i, step); }) : StepWatch();
      state_->objects[i]->step(time, one);
      if (stepped) stepped(i);
    }
    if (state_->contact == nullptr) continue;
    state_->contact->step(
        time, !watch ? ContactGroup::Watch()
                     : [&](std::size_t member, int step) { watch(state_->touching[member], step); });
    for (const std::size_t i : state_->touching)
      if (stepped) stepped(i);
  }
}

void World::passTo(int frame) {
  for (; state_->done < frame + state_->preroll; ++state_->done) {
    for (const std::size_t i : state_->order)
      if (!state_->isTouching(i)) state_->objects[i]->pass(time());
    if (state_->contact) state_->contact->step(time(), {});
  }
}

void World::show() {
  for (const std::size_t i : state_->order) state_->objects[i]->resumed(time());
}

void World::carryOver(CarryOver& carry, const std::function<void(const std::string& object)>& begin) {
  for (std::size_t i = 0; i < state_->objects.size(); ++i) {
    begin(state_->names[i]);
    state_->objects[i]->carryOver(carry);
  }
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
    for (std::size_t k = surfaces; k < all.surfaces.size(); ++k) all.surfaces[k].object = &state_->names[i];
    for (std::size_t k = instances; k < all.instances.size(); ++k)
      all.instances[k].object = &state_->names[i];
  }
  return all;
}

bool World::settle() {
  bool remade = false;
  for (const auto& object : state_->objects) remade = object->settle() || remade;
  return remade;
}

std::vector<World::ArrayName> World::arrays() const {
  return state_->arrays;
}

std::vector<World::CountNames> World::countNames() const {
  std::vector<CountNames> names;
  for (const State::Counting& c : state_->counting) {
    CountNames& entry = names.emplace_back();
    entry.object = state_->names[c.object];
    const CountTable table = state_->objects[c.object]->counts();
    entry.elements = table.elements;
    entry.measured = table.measured;
    for (const char* column : table.columns) entry.columns.emplace_back(column);
  }
  return names;
}

const Simulation& World::object(std::size_t index) const {
  return *state_->objects.at(index);
}

void World::startSummary() {
  state_->start(frame());
}

std::optional<World::Summary> World::takeSummary(bool wait) {
  if (state_->pending.empty()) return std::nullopt;
  const Pending oldest = state_->pending.front();
  const GLuint64 patience = wait ? GLuint64{60'000'000'000} : 0;
  GLenum result = glClientWaitSync(oldest.fence, GL_SYNC_FLUSH_COMMANDS_BIT, patience);
  while (wait && result == GL_TIMEOUT_EXPIRED) result = glClientWaitSync(oldest.fence, 0, patience);
  if (result == GL_TIMEOUT_EXPIRED) return std::nullopt;
  if (result == GL_WAIT_FAILED)
    fail(ExitCode::device, "the device stopped answering at frame {}", oldest.frame);
  glDeleteSync(oldest.fence);
  state_->pending.pop_front();
  state_->checkStatus(oldest.frame, oldest.slot);
  Summary summary = state_->summary(oldest.frame, oldest.slot);
  state_->readCounts(oldest, summary);
  gl::checkCalls();
  return summary;
}

}  // namespace simreel::sim

#include "sim/world.hpp"

#include "base/error.hpp"
#include "gl/program.hpp"
#include "gl/vec4_array.hpp"
#include "sim/list.hpp"
#include "sim/shape.hpp"

#include <cmath>
#include <deque>
#include <vector>

namespace simreel::sim {

namespace {

constexpr int slots = 8;
constexpr int texelsPerInvocation = 64;

/// Hash sum and loss report of one frame: 16 bytes of sums, then 16 bytes of status for each object.
struct Pending {
  int frame;
  int slot;
  GLsync fence;
};

std::vector<ColliderShape> collect(const scene::Scene& scene) {
  std::vector<ColliderShape> shapes;
  for (const scene::Object& object : scene.objects)
    if (const auto* shape = dynamic_cast<const ShapeParameters*>(object.parameters.get()))
      if (shape->collides) shapes.push_back(shape->shape);
  if (scene.hasGround) {
    ColliderShape ground;
    ground.kind = ColliderShape::Kind::plane;
    ground.position = glm::vec3(0, scene.ground.height, 0);
    shapes.push_back(ground);
  }
  return shapes;
}

}  // namespace

struct World::State {
  double fps;
  int preroll;
  int done = 0;  ///< frames simulated, the pre-roll's included
  std::vector<ColliderShape> colliders;
  std::vector<std::unique_ptr<Simulation>> objects;

  gl::Program hash;
  gl::Buffer sums;      ///< uvec4 per slot
  gl::Buffer statuses;  ///< uvec4 per object per slot
  std::deque<Pending> pending;
  int nextSlot = 0;

  explicit State(const scene::Scene& scene)
      : fps(scene.time.fps),
        preroll(static_cast<int>(std::lround(scene.time.start * scene.time.fps))),
        colliders(collect(scene)),
        hash(gl::Program::compute("common/state_hash.comp")) {
    const Setting setting{scene.numerics == scene::Numerics::fast, scene.seed, 1.0 / scene.time.fps,
                          &colliders};
    for (const scene::Object& object : scene.objects)
      for (const SimulationKind& kind : simulations())
        if (object.kind == kind.kind.name) objects.push_back(kind.make(object, setting));
    SIMREEL_CHECK_EQ(objects.size(), scene.objects.size());
    sums = gl::Buffer("state hash sums", slots * 16);
    statuses = gl::Buffer("status copies", std::max<std::size_t>(1, objects.size()) * slots * 16);
  }

  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    for (const Pending& p : pending) glDeleteSync(p.fence);
  }

  /// Adds one state array to the slot's sum; `salt` tells arrays of equal content apart.
  void addToHash(const gl::Buffer& buffer, int slot, unsigned salt) const {
    const gl::Texture words = gl::Texture::view("state words", GL_RGBA32UI, buffer);
    const int texels = static_cast<int>(buffer.bytes() / 16);
    words.bind(0);
    sums.bindStorage(0);
    hash.set("texels", texels);
    hash.set("perInvocation", texelsPerInvocation);
    hash.set("slot", slot);
    hash.set("salt", salt);
    hash.dispatch((texels - 1) / texelsPerInvocation + 1);
  }

  void start(int frame) {
    SIMREEL_CHECK(pending.size() < slots);
    const int slot = nextSlot;
    nextSlot = (nextSlot + 1) % slots;
    const unsigned zero[4] = {0, 0, 0, 0};
    sums.write(static_cast<std::size_t>(slot) * 16, std::as_bytes(std::span(zero)));
    gl::barrier();
    unsigned salt = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      for (const StateArray& array : objects[i]->state())
        addToHash(*array.buffer, slot, ++salt * 0x9e3779b9U);
      if (const gl::Buffer* status = objects[i]->status()) {
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glCopyNamedBufferSubData(status->name(), statuses.name(), 0, statusOffset(slot, i), 16);
      }
    }
    pending.push_back({frame, slot, glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)});
    glFlush();
  }

  [[nodiscard]] GLintptr statusOffset(int slot, std::size_t object) const {
    return static_cast<GLintptr>((static_cast<std::size_t>(slot) * objects.size() + object) * 16);
  }

  void checkStatus(int slot) const {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (objects[i]->status() == nullptr) continue;
      unsigned words[4] = {};
      statuses.read(static_cast<std::size_t>(statusOffset(slot, i)),
                    std::as_writable_bytes(std::span(words)));
      if (words[0] != 0xffffffffU)
        throw UserError(ExitCode::device, objects[i]->explainLoss(words[0], words[1]));
    }
  }

  [[nodiscard]] std::string hashText(int slot) const {
    unsigned words[4] = {};
    sums.read(static_cast<std::size_t>(slot) * 16, std::as_writable_bytes(std::span(words)));
    return fmt::format("{:08x}{:08x}{:08x}{:08x}", words[0], words[1], words[2], words[3]);
  }
};

World::World(const scene::Scene& scene) : state_(std::make_unique<State>(scene)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::advanceTo(int frame) {
  SIMREEL_CHECK(frame + state_->preroll >= state_->done);
  for (; state_->done < frame + state_->preroll; ++state_->done) {
    const double time = (state_->done - state_->preroll) / state_->fps;
    for (const auto& object : state_->objects) object->step(time);
  }
}

int World::frame() const {
  return state_->done - state_->preroll;
}

double World::time() const {
  return frame() / state_->fps;
}

Drawables World::drawables() const {
  Drawables all;
  for (const auto& object : state_->objects) object->publish(time(), all);
  return all;
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
  state_->checkStatus(oldest.slot);
  return Summary{oldest.frame, state_->hashText(oldest.slot)};
}

}  // namespace simreel::sim

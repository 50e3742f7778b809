#include "sim/particles/particles.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/limits.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/particles/balls.hpp"
#include "sim/particles/gravity_tree.hpp"
#include "sim/particles/kernels.hpp"
#include "sim/particles/pairs.hpp"
#include "sim/particles/plan.hpp"
#include "sim/ports/moving_points.hpp"
#include "sim/touch/touch.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simreel::sim {

namespace {

constexpr int maxAnywhere = 1 << 26;

/// Returns the maximum number of particles for the current device. It is limited by the size of one array
/// and by one dispatch of workgroups of 64.
int maxParticles() {
  constexpr std::int64_t bytes = sizeof(glm::vec4);
  std::int64_t max = gl::limits().storageBlockBytes / bytes;
  max = std::min(max, gl::limits().texelBufferTexels);
  max = std::min(max, std::int64_t{64} * gl::limits().groupsX);
  return static_cast<int>(std::min<std::int64_t>(max, maxAnywhere));
}

const std::vector<ColliderShape>& shapesIn(const Setting& setting) {
  static const std::vector<ColliderShape> none;
  return setting.colliders != nullptr ? *setting.colliders : none;
}

class Particles : public Simulation, public LockStep {
 public:
  Particles(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        material_(object.material),
        plan_(parametersOf<ParticleParameters>(object).withContactSubsteps(
                  setting.together<LockStep>().steps),
              setting.seed, setting.frameSeconds, maxParticles(), shapesIn(setting)) {
    const ParticleParameters& p = plan_.parameters();
    touch_ = Touch(name_, setting,
                   {.walls = p.walls,
                    .wind = p.wind ? p.wind->fluid : "",
                    .solids = p.collides,
                    .margin = p.margin,
                    .bounce = p.bounce,
                    .colliders = plan_.colliderCount(),
                    .substeps = p.substeps,
                    .substepSeconds = plan_.substepSeconds()});
    if (p.method == GravityMethod::allPairs) pairs_ = PairGravity(setting.fast);
    if (p.method == GravityMethod::tree) tree_.emplace(name_, plan_.count(), setting.fast);
    const ParticleCloud cloud = plan_.firstCloud();
    positions_[0] = gl::Vec4Array(name_ + " positions", cloud.positions);
    inContact_ = setting.together<LockStep>().led && p.meetsCloths();
    if (twoPositions()) {
      positions_[1] = gl::Vec4Array(name_ + " next positions", cloud.positions);
    }
    if (inContact_)
      savedAccelerations_ =
          gl::Buffer(name_ + " accelerations before a frame", 16 * cloud.positions.size());
    velocities_ = gl::Vec4Array(name_ + " velocities", cloud.velocities);
    if (plan_.rolls()) {
      const std::size_t all = cloud.positions.size();
      spins_ = gl::Vec4Array(name_ + " spins", std::vector<glm::vec4>(all));
      turns_ = gl::Vec4Array(name_ + " turns", std::vector<glm::vec4>(all, glm::vec4(0, 0, 0, 1)));
    }
    if (inContact_ && plan_.rolls()) {
      savedSpins_ = gl::Buffer(name_ + " spins before a frame", spins_.buffer().bytes());
      savedTurns_ = gl::Buffer(name_ + " turns before a frame", turns_.buffer().bytes());
    }
    moving_ = {&positions_[0], &velocities_, plan_.count(), p.size, plan_.fastestAtStart(cloud)};
    accelerations_ =
        gl::Vec4Array(name_ + " accelerations", std::vector<glm::vec4>(cloud.positions.size()));
    const unsigned fine[4] = {0xffffffffU, 0xffffffffU, 0, 0};
    status_ = gl::Buffer::of<unsigned>(name_ + " status", fine);
    makeKernels(setting.fast);
    steps_ = StepBlocks<shader::ParticleStep>(name_ + " steps", p.substeps);
    if (colors_.empty()) colors_ = {glm::vec3(0.02F), glm::vec3(1.0F)};
    if (!p.trails) return;
    trails_ = std::make_unique<ParticleTrails>(name_, *p.trails, plan_.count(), instances(), material_,
                                               setting.fast);
    trails_->record(positions_[0], velocities_);
  }

  void step(double time, const StepWatch& watch) override {
    beginFrame(time);
    for (int i = 0; i < plan_.parameters().substeps; ++i) {
      if (twoPositions()) {
        predict(i);
        finish();
      } else {
        advance(i);
      }
      if (watch) watch(i + 1);
    }
    endFrame(time);
  }

  void connect(Outlets& outlets) override {
    if (inContact_) outlets.provide<LockStep>(this);
    outlets.provide(&moving_);
  }
  [[nodiscard]] ContactPart contactPart() const override { return plan_.contactPart(); }
  void beginFrame(double time) override {
    if (!primed_) prime(time);
    stepsOfFrame_ = plan_.frame(time);
    steps_.upload(stepsOfFrame_);
    touch_.beginFrame(time);
    if (inContact_) copy(accelerations_.buffer(), savedAccelerations_);
    if (!inContact_ || !plan_.rolls()) return;
    copy(spins_.buffer(), savedSpins_);
    copy(turns_.buffer(), savedTurns_);
  }
  void predict(int substep) override {
    gl::barrier();
    keep_.dispatch(plan_.count(),
                   {.count = plan_.count(), .starts = positions_[0], .positions = positions_[1]});
    next_ = 1;
    advance(substep);
    if (balls_) balls_->solve(partAt(substep), positions_[0], positions_[1], velocities_, turns_);
  }
  void settle(int substep) override {
    if (!settles_) return;
    gl::barrier();
    settle_.dispatch(plan_.count(), {.part = partAt(substep), .starts = positions_[0]});
  }
  [[nodiscard]] Contact::Part arrays() const override {
    return {&positions_[0], &positions_[1], &velocities_};
  }
  void finish() override {
    std::swap(positions_[0], positions_[1]);
    next_ = 0;
  }
  void restored() override {
    copy(savedAccelerations_, accelerations_.buffer());
    if (!plan_.rolls()) return;
    copy(savedSpins_, spins_.buffer());
    copy(savedTurns_, turns_.buffer());
  }
  void endFrame(double /*time*/) override {
    gl::barrier();
    if (trails_) trails_->record(positions_[0], velocities_);
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    drawables.instances.push_back(instances());
    if (trails_) drawables.surfaces.push_back(trails_->surface(positions_[0], velocities_));
  }

  void visitCheckpointData(CarryOver& carry) override {
    plan_.visitCheckpointData(carry);
    carry.number("primed", primed_);
    carry.array("positions", positions_[0].buffer());
    carry.array("velocities", velocities_.buffer());
    carry.array("accelerations", accelerations_.buffer());
    if (plan_.rolls()) {
      carry.array("spins", spins_.buffer());
      carry.array("turns", turns_.buffer());
    }
    if (trails_) trails_->visitCheckpointData(carry);
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    std::vector<StateArray> all = {{"positions", &positions_[0].buffer()},
                                   {"velocities", &velocities_.buffer()}};
    if (!plan_.rolls()) return all;
    all.push_back({"spins", &spins_.buffer()});
    all.push_back({"turns", &turns_.buffer()});
    return all;
  }
  [[nodiscard]] std::vector<double> measure() const override {
    double alive = 0, mass = 0, kinetic = 0;
    glm::dvec3 momentum(0);
    const auto positions = positions_[0].buffer().readAll<glm::vec4>();
    const auto velocities = velocities_.buffer().readAll<glm::vec4>();
    for (std::size_t i = 0; i < static_cast<std::size_t>(plan_.count()); ++i) {
      if (velocities[i].w < 0) continue;
      const double m = positions[i].w;
      const glm::dvec3 v(velocities[i]);
      alive += 1;
      mass += m;
      momentum += m * v;
      kinetic += 0.5 * m * glm::dot(v, v);
    }
    return {alive, mass, glm::length(momentum), kinetic};
  }
  [[nodiscard]] int stepsPerFrame() const override { return plan_.parameters().substeps; }
  [[nodiscard]] std::string elementName(long element) const override {
    return fmt::format("particle {}", element);
  }
  [[nodiscard]] PointTable points() const override {
    const auto positions = positions_[0].buffer().readAll<glm::vec4>();
    const auto velocities = velocities_.buffer().readAll<glm::vec4>();
    PointTable table{{"x", "y", "z", "mass", "vx", "vy", "vz", "age"}, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(plan_.count()); ++i) {
      const glm::vec4& p = positions[i];
      const glm::vec4& v = velocities[i];
      if (v.w >= 0) table.values.insert(table.values.end(), {p.x, p.y, p.z, p.w, v.x, v.y, v.z, v.w});
    }
    return table;
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &status_; }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    return fmt::format(
        "particles \"{}\" blew up in substep {} at particle {}: its position or velocity is not a number "
        "or "
        "beyond 1e8; use more substeps ({} per frame now), a greater softening or smaller masses",
        name_, step, element, plan_.parameters().substeps);
  }
  [[nodiscard]] std::string remark(int frame) const override {
    return fmt::format(
        "particles \"{}\" move by more than their radius in a substep (frame {}), and may pass through "
        "each "
        "other; raise \"substeps\" ({} per frame now)",
        name_, frame, plan_.parameters().substeps);
  }

 private:
  void makeKernels(bool fast) {
    const ParticleParameters& p = plan_.parameters();
    const gl::Defines defines = gl::kernelDefines(fast);
    const ParticleFields fields = {.attractor = p.attractor.has_value(),
                                   .turbulence = p.turbulence.strength > 0};
    const bool shapes = plan_.colliderCount() > 0;
    const ParticleSolids solids = {
        .touch = touch_.variant(), .solids = shapes || touch_.meshCount() > 0, .rolls = plan_.rolls()};
    kick_ = gl::Kernel<ParticleKick>(defines, {.wind = solids.touch.wind, .fields = fields});
    if (attracts())
      drift_ = gl::Kernel<ParticleDrift>(defines, solids);
    else
      whole_ = gl::Kernel<ParticleWhole>(defines, {.solids = solids, .fields = fields});
    settles_ = shapes || touch_.meets();
    if (twoPositions()) keep_ = gl::Kernel<ParticleKeep>(defines);
    if (inContact_) settle_ = gl::Kernel<ParticleSettle>(defines, solids);
    if (p.contact) balls_.emplace(name_, plan_, solids, fast);
    if (!p.emitters.empty())
      birth_ =
          gl::Kernel<ParticleBirth>(defines, {.solids = solids, .fields = fields, .attracts = attracts()});
  }

  /// Returns true if a substep needs the positions at its start until its end.
  [[nodiscard]] bool twoPositions() const { return inContact_ || plan_.parameters().contact.has_value(); }
  [[nodiscard]] bool attracts() const { return plan_.parameters().method != GravityMethod::none; }

  /// Advances the particles in positions_[next_] by one substep.
  void advance(int substep) {
    gl::barrier();
    const ParticlePart part = partAt(substep);
    if (attracts())
      drift_.dispatch(plan_.count(), {part, accelerations_});
    else
      whole_.dispatch(plan_.count(), {part, accelerations_});
    giveBirth(stepsOfFrame_[static_cast<std::size_t>(substep)], part);
    if (!attracts()) return;
    attract();
    kick_.dispatch(plan_.count(), {part, accelerations_});
  }

  static void copy(const gl::Buffer& from, const gl::Buffer& to) {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glCopyNamedBufferSubData(from.name(), to.name(), 0, 0, static_cast<GLsizeiptr>(to.bytes()));
    gl::barrier();
  }

  void giveBirth(const shader::ParticleStep& step, const ParticlePart& part) const {
    int newborns = 0;
    for (const shader::EmitterStep& emitter : step.emitters) newborns += emitter.newborns;
    birth_.dispatch(newborns, {part, accelerations_});
  }

  /// Computes the initial accelerations with a kick of zero length.
  void prime(double time) {
    steps_.upload(std::vector{plan_.prime(time)});
    gl::barrier();
    if (attracts()) attract();
    kick_.dispatch(plan_.count(), {partAt(0), accelerations_});
    primed_ = true;
  }

  void attract() {
    const ParticleParameters& p = plan_.parameters();
    if (p.method == GravityMethod::tree)
      tree_->accelerate(positions_[next_], accelerations_, plan_.count(), p.gravity, p.softening,
                        p.opening);
    else
      pairs_.accelerate(positions_[next_], accelerations_, plan_.count(), p.gravity, p.softening);
  }

  [[nodiscard]] ParticlePart partAt(int substep) const {
    return {.step = steps_.at(static_cast<std::size_t>(substep)),
            .touch = touch_.at(substep),
            .status = status_,
            .positions = positions_[next_],
            .velocities = velocities_,
            .spins = spins_};
  }

  [[nodiscard]] Instances instances() const {
    const ParticleParameters& p = plan_.parameters();
    Instances instances;
    instances.positions = &positions_[0].view();
    instances.velocities = &velocities_.view();
    instances.capacity = plan_.count();
    instances.shape = p.shape;
    instances.mesh = p.mesh;
    if (plan_.rolls() && p.shape == Instances::Shape::mesh) {
      instances.turning = Instances::Turning::quaternion;
      instances.turns = &turns_.view();
    }
    if (p.alongVelocity) instances.turning = Instances::Turning::velocity;
    instances.size = p.size;
    instances.massExponent = p.massExponent;
    instances.massReference = plan_.massReference();
    instances.colorBy = p.colorBy;
    instances.colorRange = p.colorRange;
    instances.colors = p.colors.empty() ? &colors_ : &p.colors;
    instances.additive = p.additive;
    instances.brightness = p.brightness;
    instances.fade = p.emitters.empty() ? 0.0F : p.fade;
    instances.material = &material_;
    return instances;
  }

  std::string name_;
  scene::Material material_;
  ParticlePlan plan_;
  gl::Vec4Array positions_[2];  ///< [0] current positions; [1] positions after the substep, used only if
                                ///< the particles touch cloths or each other
  gl::Vec4Array velocities_, accelerations_;
  gl::Vec4Array spins_, turns_;  ///< of balls that turn: angular velocities in rad/s, and orientations as
                                 ///< unit quaternions (x, y, z, w)
  gl::Buffer savedSpins_, savedTurns_;  ///< the same at the start of the frame, for particles in contact
  gl::Buffer savedAccelerations_;  ///< for particles in contact: accelerations at the start of the frame
  int next_ = 0;                   ///< index into positions_ of the array that kernels read and write
  bool inContact_ = false;         ///< true if the particles collide with cloths
  bool settles_ = false;           ///< true if the particles collide with other objects
  gl::Buffer status_;
  StepBlocks<shader::ParticleStep> steps_;
  std::vector<shader::ParticleStep> stepsOfFrame_;
  Touch touch_;
  gl::Kernel<ParticleKeep> keep_;
  gl::Kernel<ParticleSettle> settle_;
  gl::Kernel<ParticleDrift> drift_;
  gl::Kernel<ParticleWhole> whole_;
  gl::Kernel<ParticleBirth> birth_;
  gl::Kernel<ParticleKick> kick_;
  std::optional<BallContact> balls_;  ///< contact of the particles with each other, if any
  PairGravity pairs_;
  std::optional<GravityTree> tree_;
  std::unique_ptr<ParticleTrails> trails_;  ///< null if there are no trails
  MovingPoints moving_;                     ///< outlet for objects that draw the velocities
  std::vector<glm::vec3> colors_;           ///< default colour map, used if the parameters have none
  bool primed_ = false;
};

}  // namespace

SimulationKind particlesKind() {
  return kindOf<ParticleParameters>(
      "particles", "Particles that attract each other, follow fields or stream from emitters.",
      [](const scene::Object& object, const Setting& setting) {
        static_cast<void>(ParticlePlan(parametersOf<ParticleParameters>(object), setting.seed,
                                       setting.frameSeconds, maxAnywhere, shapesIn(setting)));
      },
      makeSimulation<Particles>);
}

}  // namespace simreel::sim

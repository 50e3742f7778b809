#include "sim/particles/plan.hpp"

#include "base/error.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/particles/apart.hpp"
#include "sim/particles/file.hpp"
#include "sim/particles/start.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>

#define FUNCTION inline
#define precise
namespace simreel::shader {
namespace {
#include "glsl/particles/pace.glsl"
}
}  // namespace simreel::shader
#undef precise
#undef FUNCTION

namespace simreel::sim {

namespace {

/// Returns the maximum number of slots that an emitter uses at any time.
double ringSize(const Emitter& emitter) {
  return std::ceil(static_cast<double>(emitter.rate) * emitter.lifetime *
                   (1.0 + emitter.lifetimeVariation)) +
         1.0;
}

constexpr double maxNeighbours = 256;

int centralCount(const ParticleGroup& group) {
  return group.shape != ParticleGroup::Shape::file && group.centralMass > 0 ? 1 : 0;
}

ParticleParameters withSubsteps(ParticleParameters parameters, double frameSeconds) {
  parameters.substeps = parameters.substepsPerFrame(frameSeconds);
  return parameters;
}

}  // namespace

ParticlePlan::ParticlePlan(ParticleParameters parameters, int seed, double frameSeconds, int maxParticles,
                           const std::vector<ColliderShape>& colliders)
    : parameters_(withSubsteps(std::move(parameters), frameSeconds)),
      seed_(seed),
      substepSeconds_(frameSeconds / parameters_.substeps),
      colliders_("a cloud of particles", parameters_.collides ? colliders : std::vector<ColliderShape>(),
                 parameters_.substeps, substepSeconds_) {
  double total = 0;
  for (const ParticleGroup& group : parameters_.groups) {
    files_.emplace_back();
    if (group.shape == ParticleGroup::Shape::file)
      files_.back() = readParticles(group.file, group.totalMass, maxParticles);
    total += groupCount(files_.size() - 1) + centralCount(group);
  }
  for (const Emitter& emitter : parameters_.emitters) total += ringSize(emitter);
  if (total > maxParticles)
    fail(ExitCode::usage,
         "{:.0f} particles, emitters' slots included, are more than the {} that fit here; lower \"count\", "
         "\"rate\" or \"lifetime\"",
         total, maxParticles);
  for (std::size_t i = 0; i < parameters_.groups.size(); ++i)
    count_ += groupCount(i) + centralCount(parameters_.groups[i]);
  for (const Emitter& emitter : parameters_.emitters) {
    Ring ring;
    ring.first = count_;
    ring.size = static_cast<int>(ringSize(emitter));
    count_ += ring.size;
    rings_.push_back(ring);
  }
  if (parameters_.contact) balls_ = planBalls();
}

shader::BallConstants ParticlePlan::planBalls() const {
  const ParticleParameters& p = parameters_;
  float lightest = massReference(), heaviest = lightest;
  const auto include = [&](float mass) {
    lightest = std::min(lightest, mass);
    heaviest = std::max(heaviest, mass);
  };
  for (std::size_t i = 0; i < p.groups.size(); ++i) {
    if (p.groups[i].shape != ParticleGroup::Shape::file)
      include(p.groups[i].totalMass / static_cast<float>(p.groups[i].count));
    if (centralCount(p.groups[i]) > 0) include(p.groups[i].centralMass);
    for (const glm::vec4& particle : files_[i].positions) include(particle.w);
  }
  for (const Emitter& emitter : p.emitters) include(emitter.mass);
  const auto scale = [&](float mass) {
    return std::pow(static_cast<double>(mass) / massReference(), static_cast<double>(p.massExponent));
  };
  // A ball of radius R has room for about 3.6 (1 + R / r)^2 neighbours of radius r.
  const double ratio = scale(heaviest) / scale(lightest);
  const double neighbours = 3.96 * (1 + ratio) * (1 + ratio);
  if (neighbours > maxNeighbours)
    fail(
        ExitCode::usage,
        "particles in contact: the largest has {:.3g} times the radius of the smallest, and 7 times is the "
        "most; lower \"massExponent\", or give masses that differ less",
        ratio);
  shader::BallConstants balls;
  balls.radius = p.ballRadius();
  balls.friction = p.contact->friction;
  balls.restitution = p.contact->restitution;
  balls.rolls = p.contact->rolls ? 1 : 0;
  balls.sizeExponent = p.massExponent;
  balls.perMassReference = 1.0F / massReference();
  balls.perCell = static_cast<float>(1 / (2.11 * p.ballRadius() * scale(heaviest)));
  balls.perDt = static_cast<float>(1 / substepSeconds_);
  balls.tableMask = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(count_, 2)))) * 2 - 1;
  balls.listed = 4 * static_cast<int>(std::ceil(neighbours / 4));
  return balls;
}

int ParticlePlan::ballImpacts() const {
  int impacts = 1;
  for (float left = balls_.restitution; left > 0.1F && impacts < shader::mostBallImpacts; ++impacts)
    left *= balls_.restitution;
  return impacts;
}

float ParticlePlan::massReference() const {
  const ParticleParameters& p = parameters_;
  if (p.groups.empty()) return p.emitters.empty() ? 1.0F : p.emitters.front().mass;
  const ParticleGroup& group = p.groups.front();
  return group.totalMass / static_cast<float>(std::max(groupCount(0), 1));
}

int ParticlePlan::groupCount(std::size_t group) const {
  const ParticleGroup& g = parameters_.groups[group];
  return g.shape == ParticleGroup::Shape::file ? static_cast<int>(files_[group].positions.size()) : g.count;
}

/// Returns the masses at the centre of a group, which are at most a hundredth of the group's radius away
/// from it.
std::vector<Companion> ParticlePlan::companionsOf(std::size_t group) const {
  const ParticleGroup& disk = parameters_.groups[group];
  const auto near = [&](const glm::vec3& position) {
    return glm::length(position - disk.position) <= 0.01F * disk.radius;
  };
  std::vector<Companion> found;
  for (std::size_t i = 0; i < parameters_.groups.size(); ++i) {
    const ParticleGroup& other = parameters_.groups[i];
    const bool round =
        other.shape == ParticleGroup::Shape::plummer || other.shape == ParticleGroup::Shape::ball;
    if (i != group && round && near(other.position)) found.push_back({other.totalMass, other.radius});
  }
  if (parameters_.attractor && near(parameters_.attractor->position.at(0)))
    found.push_back({parameters_.attractor->mass.at(0), parameters_.attractorSoftening});
  return found;
}

ParticleCloud ParticlePlan::firstCloud() const {
  ParticleCloud all;
  all.positions.reserve(static_cast<std::size_t>(count_));
  all.velocities.reserve(static_cast<std::size_t>(count_));
  for (std::size_t i = 0; i < parameters_.groups.size(); ++i) {
    const ParticleGroup& group = parameters_.groups[i];
    ParticleCloud cloud = group.shape == ParticleGroup::Shape::file
                              ? files_[i]
                              : startGroup(group, static_cast<int>(i), seed_, parameters_.gravity,
                                           parameters_.softening, companionsOf(i));
    placeGroup(cloud, group);
    all.positions.insert(all.positions.end(), cloud.positions.begin(), cloud.positions.end());
    all.velocities.insert(all.velocities.end(), cloud.velocities.begin(), cloud.velocities.end());
  }
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const auto slots = static_cast<std::size_t>(rings_[i].size);
    all.positions.insert(all.positions.end(), slots,
                         glm::vec4(parameters_.emitters[i].position.at(0), 0.0F));
    all.velocities.insert(all.velocities.end(), slots, glm::vec4(0, 0, 0, -1));
  }
  SIMREEL_CHECK_EQ(all.positions.size(), static_cast<std::size_t>(count_));
  if (parameters_.contact) moveApart(all, balls_);
  return all;
}

float ParticlePlan::fastestAtStart(const ParticleCloud& cloud) const {
  float fastest = 0;
  for (const glm::vec4& v : cloud.velocities)
    if (v.w >= 0) fastest = std::max(fastest, std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
  for (const Emitter& emitter : parameters_.emitters)
    for (const auto& key : emitter.velocity.keys())
      fastest = std::max(fastest, (1 + emitter.speedVariation) * glm::length(key.value));
  return fastest;
}

shader::ParticleFields ParticlePlan::fields(double time) const {
  const ParticleParameters& p = parameters_;
  shader::ParticleFields f{};
  f.acceleration = glm::vec4(p.acceleration.at(time), 0.0F);
  if (p.attractor)
    f.attractor = glm::vec4(p.attractor->position.at(time), p.gravity * p.attractor->mass.at(time));
  // The noise field drifts along a fixed direction that is not a coordinate axis.
  const glm::dvec3 way = glm::dvec3(0.36, 0.48, 0.8) * (p.turbulence.speed * time);
  f.turbulenceDrift = glm::vec4(way.x, way.y, way.z, 0);
  return f;
}

shader::ParticleStep ParticlePlan::between(double start, double end) const {
  const ParticleParameters& p = parameters_;
  const auto seconds = static_cast<float>(start < end ? substepSeconds_ : 0);
  shader::ParticleStep s{};
  s.fields = fields(end);
  s.fieldsBefore = fields(start);
  s.pace = shader::paceOf(seconds, p.slowing());
  s.dt = seconds;
  s.perTurbulenceSize = 1.0F / p.turbulence.size;
  s.count = count_;
  s.substep = done_;
  s.seed = seed_;
  s.emitterCount = static_cast<int>(rings_.size());
  s.windDrag = p.wind ? p.wind->drag : 0.0F;
  s.constants = p;
  s.constants.damping = p.slowing();
  s.turbulence = p.turbulence;
  if (!p.contact) return s;
  // With contact, the whole kick precedes the drift, so that a ball at rest has no velocity between
  // substeps.
  s.pace.firstKick = seconds;
  s.pace.secondKick = 0;
  s.balls = balls_;
  s.balls.restSpeed = static_cast<float>(glm::length(p.acceleration.at(end)) * substepSeconds_);
  s.balls.bounceFrom = 3 * s.balls.restSpeed;
  return s;
}

ContactPart ParticlePlan::contactPart() const {
  ContactPart part;
  part.balls = true;
  part.positions = firstCloud().positions;
  part.thickness = parameters_.margin;
  part.bounce = parameters_.bounce;
  if (parameters_.cloths != "all") part.meets = parameters_.cloths;
  for (const glm::vec4& p : part.positions) part.heaviest = std::max(part.heaviest, p.w);
  for (const Emitter& emitter : parameters_.emitters) part.heaviest = std::max(part.heaviest, emitter.mass);
  return part;
}

shader::ParticleStep ParticlePlan::prime(double time) const {
  return between(time, time);
}

std::vector<shader::ParticleStep> ParticlePlan::frame(double time) {
  std::vector<shader::ParticleStep> steps(static_cast<std::size_t>(parameters_.substeps));
  const auto colliders = colliders_.frame(time);
  for (int i = 0; i < parameters_.substeps; ++i) {
    const double start = time + i * substepSeconds_;
    const double end = time + (i + 1) * substepSeconds_;
    shader::ParticleStep& s = steps[static_cast<std::size_t>(i)];
    s = between(start, end);
    s.colliderCount = colliders_.count();
    std::ranges::copy(colliders[static_cast<std::size_t>(i)], s.colliders);
    for (std::size_t e = 0; e < rings_.size(); ++e)
      births(s.emitters[e], parameters_.emitters[e], rings_[e], start, end);
    ++done_;
  }
  return steps;
}

void ParticlePlan::births(shader::EmitterStep& s, const Emitter& emitter, Ring& ring, double start,
                          double end) const {
  if (!ring.started) {
    // If "from" is 0, the emitter starts at the start of the run, including the pre-roll.
    ring.begin = emitter.from > 0 ? std::max<double>(emitter.from, start) : start;
    ring.started = true;
  }
  const auto rate = static_cast<double>(emitter.rate);
  const double until = std::min<double>(end, emitter.until);
  // Particle n, counted from 0, is born at begin + (n + 1) / rate. The tolerance 1e-6 ensures that rounding
  // does not lose the last particle of a whole number of periods.
  const auto due = std::max(
      ring.born, static_cast<long long>(std::floor(rate * std::max(until - ring.begin, 0.0) + 1e-6)));
  // If more births are due than the ring has slots, all but the last of these particles have already died
  // at the end of the substep.
  const auto newborns = static_cast<int>(std::min<long long>(due - ring.born, ring.size));
  const long long first = due - newborns;
  const double birth = ring.begin + static_cast<double>(first + 1) / rate;
  s.position = glm::vec4(emitter.position.at(end), 0);
  s.positionBefore = glm::vec4(emitter.position.at(start), 0);
  s.velocity = glm::vec4(emitter.velocity.at(end), 0);
  s.velocityBefore = glm::vec4(emitter.velocity.at(start), 0);
  // The expression 1 - cos(a) = 2 sin^2(a / 2) is exactly 0 if there is no spread.
  const float half = shader::exactSin(emitter.spread * 0.00872664626F);
  s.coneHeight = 2.0F * half * half;
  s.birthInterval = static_cast<float>(1 / rate);
  s.firstLived = static_cast<float>(end - birth);
  s.firstSlot = ring.first;
  s.slots = ring.size;
  s.firstPlace = static_cast<int>(first % ring.size);
  s.newborns = newborns;
  s.firstSerial = static_cast<int>(static_cast<std::uint32_t>(first));
  s.constants = emitter;
  ring.born = due;
}

}  // namespace simreel::sim

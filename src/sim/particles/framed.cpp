// Extent that an automatic camera shows of particles at the start of their motion.
#include "base/error.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/particles/file.hpp"
#include "sim/particles/parameters.hpp"
#include "sim/particles/start.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Radius, in scale lengths, that contains most of a Plummer sphere or a disk.
constexpr float scaleLengths = 3.0F;

constexpr int maxFileParticles = 1 << 24;

void includeBall(std::optional<scene::Box>& box, const glm::vec3& middle, const glm::vec3& half) {
  scene::include(box, middle - half);
  scene::include(box, middle + half);
}

/// Returns the placed particles of the group's file. Returns an empty list if the file cannot be read. The
/// constructor of the simulation reports this error.
std::vector<glm::vec4> particlesOfFile(const ParticleGroup& group) {
  try {
    ParticleCloud cloud = readParticles(group.file, group.totalMass, maxFileParticles);
    placeGroup(cloud, group);
    return cloud.positions;
  } catch (const UserError&) {
    return {};
  }
}

/// Extends the box by the initial extent of a group, without the radius of a particle of the reference
/// mass. The group's later motion is unpredictable.
void includeGroup(std::optional<scene::Box>& box, const ParticleGroup& group, const ShownRadius& shown) {
  using Shape = ParticleGroup::Shape;
  if (group.shape == Shape::file) {
    for (const glm::vec4& particle : particlesOfFile(group))
      includeBall(box, glm::vec3(particle), glm::vec3(shown.beyond(particle.w)));
    return;
  }
  const bool open = group.shape == Shape::plummer || group.shape == Shape::disk;
  const float extent = group.radius * (open ? scaleLengths : 1.0F);
  glm::vec3 half(extent);
  if (group.shape == Shape::disk && group.rotation == glm::vec3(0))
    half.y = extent * std::min(group.thickness * scaleLengths, 1.0F);
  includeBall(box, group.position, half + shown.beyond(group.totalMass / static_cast<float>(group.count)));
  if (group.centralMass > 0) includeBall(box, group.position, glm::vec3(shown.beyond(group.centralMass)));
}

/// Extends the box by the flight of the particles over one lifetime, without damping and attraction, and by
/// the widening of their velocity cone.
void includeEmitter(std::optional<scene::Box>& box, const Emitter& emitter, const glm::vec3& acceleration,
                    float beyond) {
  constexpr int looks = 16;
  const float spreadAngle = std::min(emitter.spread / 57.29578F, 1.0F);
  for (const auto& key : emitter.position.keys()) {
    const glm::vec3 velocity = emitter.velocity.at(key.time);
    for (int i = 0; i <= looks; ++i) {
      const float t = emitter.lifetime * static_cast<float>(i) / looks;
      includeBall(box, key.value + velocity * t + acceleration * (0.5F * t * t),
                  glm::vec3(emitter.radius + 0.7F * spreadAngle * glm::length(velocity) * t + beyond));
    }
  }
}

}  // namespace

float ShownRadius::of(float mass) const {
  return exponent == 0 ? radius : radius * shader::exactPow(std::max(mass, 0.0F) / reference, exponent);
}

float ShownRadius::beyond(float mass) const {
  return std::max(of(mass) - radius, 0.0F);
}

ShownRadius ParticleParameters::shownRadius() const {
  ShownRadius shown{.radius = 0.5F * size, .exponent = massExponent, .reference = 1};
  if (massExponent == 0) return shown;
  if (groups.empty()) {
    if (!emitters.empty()) shown.reference = emitters.front().mass;
    return shown;
  }
  const ParticleGroup& first = groups.front();
  auto count = static_cast<float>(first.count);
  if (first.shape == ParticleGroup::Shape::file)
    count = static_cast<float>(std::max<std::size_t>(particlesOfFile(first).size(), 1));
  shown.reference = first.totalMass / count;
  return shown;
}

std::optional<scene::Box> ParticleParameters::framed() const {
  const ShownRadius shown = shownRadius();
  std::optional<scene::Box> box;
  for (const ParticleGroup& group : groups) includeGroup(box, group, shown);
  // Falling particles stay visible down to y = 0 or, if they start below, down by the width of the cloud.
  if (box && acceleration.at(0).y < 0) {
    const glm::vec3 extent = box->max - box->min;
    box->min.y = box->min.y > 0 ? 0.0F : box->min.y - std::max(extent.x, extent.z);
  }
  for (const Emitter& emitter : emitters)
    includeEmitter(box, emitter, acceleration.at(0), shown.beyond(emitter.mass));
  if (!box) return box;
  box->min -= 0.5F * size;
  box->max += 0.5F * size;
  box->round = emitters.empty() && groups.size() == 1 && groups[0].shape != ParticleGroup::Shape::cube &&
               !(acceleration.at(0).y < 0);
  return box;
}

}  // namespace simreel::sim

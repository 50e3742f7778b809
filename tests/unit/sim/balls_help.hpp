#pragma once
// Helpers for tests of contact of particles with each other. They use the CPU twin, which equals the GPU
// bit for bit.
#include "reference/particles_twin.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

namespace simreel::balls {

constexpr double frame = 1.0 / 60;

struct Ball {
  glm::vec3 position, velocity;
  float mass = 1;
};

inline sim::ParticleParameters parametersOf(int count, float restitution, float friction = 0) {
  sim::ParticleParameters p;
  p.method = sim::GravityMethod::none;
  p.groups.emplace_back().count = count;
  p.contact.emplace();
  p.contact->radius = 0.05F;
  p.contact->restitution = restitution;
  p.contact->friction = friction;
  p.substeps = 16;
  return p;
}

inline ParticlesTwin placed(const std::vector<Ball>& all, const sim::ParticleParameters& p) {
  ParticlesTwin twin(sim::ParticlePlan(p, 1, frame));
  for (std::size_t i = 0; i < all.size(); ++i) {
    twin.positions[i] = glm::vec4(all[i].position, all[i].mass);
    twin.velocities[i] = glm::vec4(all[i].velocity, 0);
  }
  return twin;
}

inline void run(ParticlesTwin& twin, int frames) {
  for (int i = 0; i < frames; ++i) twin.step(i * frame);
}

inline glm::dvec3 momentumOf(const ParticlesTwin& twin) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < twin.positions.size(); ++i)
    sum += static_cast<double>(twin.positions[i].w) * glm::dvec3(twin.velocities[i]);
  return sum;
}

inline double energyOf(const ParticlesTwin& twin) {
  double sum = 0;
  for (std::size_t i = 0; i < twin.positions.size(); ++i) {
    const glm::dvec3 v(twin.velocities[i]);
    sum += 0.5 * twin.positions[i].w * glm::dot(v, v);
  }
  return sum;
}

/// Returns a floor and, if `half` is positive, four walls at this distance from the axis.
inline std::vector<sim::ColliderShape> box(float half, double friction) {
  std::vector<sim::ColliderShape> planes(half > 0 ? 5 : 1);
  for (sim::ColliderShape& plane : planes) {
    plane.kind = sim::ColliderShape::Kind::plane;
    plane.position = glm::vec3(0);
    plane.rotation = glm::vec3(0);
    plane.friction = friction;
  }
  for (std::size_t i = 1; i < planes.size(); ++i) {
    const float side = i % 2 == 1 ? 1.0F : -1.0F;
    planes[i].position = i < 3 ? glm::vec3(side * half, 0, 0) : glm::vec3(0, 0, side * half);
    planes[i].rotation = i < 3 ? glm::vec3(0, 0, 90 * side) : glm::vec3(-90 * side, 0, 0);
  }
  return planes;
}

/// Drops `count` balls from a lattice that is `wide` balls wide. Returns the twin after `frames` frames.
inline ParticlesTwin heap(int count, int wide, float friction, float half, int frames) {
  sim::ParticleParameters p = parametersOf(count, 0.2F, friction);
  p.acceleration = glm::vec3(0, -9.81F, 0);
  p.autoSubsteps = true;
  p.collides = true;
  p.bounce = 0.2F;
  p.margin = 0.05F;
  ParticlesTwin twin(sim::ParticlePlan(p, 1, frame, 1 << 20, box(half, friction)));
  for (int i = 0; i < count; ++i) {
    const int layer = i / (wide * wide);
    const auto across = [&](int k, int shift) {
      return (static_cast<float>(k) + 0.3F * static_cast<float>(layer % shift) -
              0.5F * static_cast<float>(wide - 1)) *
             0.103F;
    };
    twin.positions[static_cast<std::size_t>(i)] = glm::vec4(
        across(i % wide, 2), 0.05F + 0.095F * static_cast<float>(layer), across(i / wide % wide, 3), 1);
    twin.velocities[static_cast<std::size_t>(i)] = glm::vec4(0);
  }
  run(twin, frames);
  return twin;
}

/// Returns the deepest overlap of two balls, as a fraction of the radius.
inline double deepest(const ParticlesTwin& twin) {
  double maximum = 0;
  for (std::size_t i = 0; i < twin.positions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec3 separation = glm::dvec3(twin.positions[i]) - glm::dvec3(twin.positions[j]);
      maximum = std::max(maximum, (0.1 - glm::length(separation)) / 0.05);
    }
  return maximum;
}

inline scene::Scene parsedScene(const std::string& object, const std::string& scene = {}) {
  return scene::parseScene(
      "{\"version\": 1, " + scene + "\"objects\": {\"cloud\": {\"particles\": " + object + "}}}",
      "test.json", {}, sim::kinds());
}

}  // namespace simreel::balls

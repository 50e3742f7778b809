#pragma once
#include "reference/cloth_twin.hpp"
#include "reference/contact_twin.hpp"
#include "reference/particles_twin.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

inline std::vector<glm::uvec3> facesOfSheet(glm::ivec2 size) {
  std::vector<glm::uvec3> faces;
  for (int y = 0; y + 1 < size.y; ++y)
    for (int x = 0; x + 1 < size.x; ++x) {
      const auto a = static_cast<unsigned>(y * size.x + x);
      const unsigned b = a + 1, c = a + static_cast<unsigned>(size.x), d = c + 1;
      faces.emplace_back(a, c, b);
      faces.emplace_back(b, c, d);
    }
  return faces;
}

/// A solid. The function `at` returns its vertex positions at a time, with w = 0.
struct PileSolid {
  std::function<std::vector<glm::vec4>(double time)> at;
  std::vector<glm::uvec3> faces;
  float friction = -1;  ///< friction coefficient; if negative, the cloths' friction applies
};

/// CPU twins of cloths that touch themselves, each other, balls and solids.
struct Pile {
  std::vector<std::unique_ptr<ClothTwin>> cloths;
  std::unique_ptr<ParticlesTwin> balls;  ///< twin of the balls; null if there are no balls
  std::vector<PileSolid> solids;
  std::unique_ptr<ContactTwin> contact;
  std::vector<glm::uvec3> faces;  ///< faces of all parts, with global vertex indices
  unsigned firstSolid = 0;        ///< global index of the first solid vertex
  double frameSeconds = 1.0 / 60.0;
  int frame = 0;

  Pile(const std::vector<simreel::sim::ClothParameters>& parameters,
       const std::vector<simreel::sim::ColliderShape>& colliders, float thickness, float friction,
       std::vector<PileSolid> solids_ = {}, const simreel::sim::ParticleParameters* particles = nullptr)
      : solids(std::move(solids_)) {
    std::vector<simreel::sim::ContactPart> parts;
    unsigned first = 0;
    for (const simreel::sim::ClothParameters& p : parameters) {
      cloths.push_back(std::make_unique<ClothTwin>(simreel::sim::ClothPlan(p, 5, frameSeconds, colliders)));
      parts.push_back({cloths.back()->positions, facesOfSheet(p.size), thickness, friction, {}});
      for (const glm::uvec3& f : parts.back().faces) faces.push_back(f + first);
      first += static_cast<unsigned>(cloths.back()->positions.size());
    }
    if (particles != nullptr) {
      simreel::sim::ParticleParameters p = *particles;
      p.substeps = static_cast<int>(std::lround(frameSeconds / cloths.front()->plan().substepSeconds()));
      balls = std::make_unique<ParticlesTwin>(
          simreel::sim::ParticlePlan(p, 5, frameSeconds, 1 << 10, colliders));
      parts.push_back(balls->plan().contactPart());
      first += static_cast<unsigned>(balls->positions.size());
    }
    firstSolid = first;
    for (const PileSolid& solid : solids) {
      parts.push_back({solid.at(0), solid.faces, 0, solid.friction, {}, true});
      for (const glm::uvec3& f : solid.faces) faces.push_back(f + first);
      first += static_cast<unsigned>(parts.back().positions.size());
    }
    contact = std::make_unique<ContactTwin>(
        simreel::sim::ContactPlan(parts, cloths.front()->plan().substepSeconds()));
  }

  void step() {
    std::vector<std::vector<simreel::shader::ClothStep>> steps;
    for (const auto& cloth : cloths) steps.push_back(cloth->plan().frame(frame * frameSeconds));
    if (balls) balls->beginFrame(frame * frameSeconds);
    for (std::size_t i = 0; i < steps.front().size(); ++i) {
      std::vector<ContactTwin::Part> parts;
      for (std::size_t c = 0; c < cloths.size(); ++c) {
        cloths[c]->predict(steps[c][i], 1, static_cast<int>(i));
        parts.push_back({&cloths[c]->positions, &cloths[c]->next, &cloths[c]->velocities});
      }
      if (balls) {
        balls->predict(static_cast<int>(i));
        parts.push_back({&balls->starts, &balls->positions, &balls->velocities});
      }
      const double dt = cloths.front()->plan().substepSeconds();
      std::vector<std::vector<glm::vec4>> places;
      for (const double time : {frame * frameSeconds + static_cast<double>(i) * dt,
                                frame * frameSeconds + static_cast<double>(i + 1) * dt})
        for (const PileSolid& solid : solids) places.push_back(solid.at(time));
      for (std::size_t k = 0; k < solids.size(); ++k)
        parts.push_back({&places[k], &places[solids.size() + k], nullptr});
      contact->push(parts, i == 0);
      for (std::size_t c = 0; c < cloths.size(); ++c) cloths[c]->settle(steps[c][i], static_cast<int>(i));
      if (balls) balls->settle(static_cast<int>(i));
      contact->hold(parts);
      for (const auto& cloth : cloths) cloth->finish();
    }
    ++frame;
  }

  [[nodiscard]] std::vector<glm::dvec3> points() const {
    std::vector<glm::dvec3> all;
    for (const auto& cloth : cloths)
      for (const glm::vec4& p : cloth->positions) all.emplace_back(p);
    for (const PileSolid& solid : solids)
      for (const glm::vec4& p : solid.at(frame * frameSeconds)) all.emplace_back(p);
    return all;
  }
};

inline simreel::sim::ClothParameters silk(glm::ivec2 size, float spacing, glm::vec3 position,
                                          glm::vec3 rotation) {
  simreel::sim::ClothParameters p;
  p.size = size;
  p.spacing = spacing;
  p.position = position;
  p.rotation = rotation;
  p.jitter = 1e-4F;
  p.fabric.emplace();
  p.fabric->material = simreel::sim::FabricMaterial::cotton;
  p.wind = glm::vec3(0);
  p.substeps = 16;
  p.damping = 0.5F;
  p.contact.emplace();
  p.pins.clear();
  return p;
}

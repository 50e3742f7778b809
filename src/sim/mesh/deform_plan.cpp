#include "sim/mesh/deform_plan.hpp"

#include "base/error.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double mostPhase = 9000.0;  // exactSin holds for 1e4

/// The angle within one turn, so that its bits do not run out with time.
float reduced(double angle) {
  return static_cast<float>(angle - turn * std::floor(angle / turn));
}

/// Cosine and sine of degrees, the same bits everywhere.
glm::vec2 heading(float degrees) {
  const float angle = degrees * 0.017453293F;
  return {shader::exactCos(angle), shader::exactSin(angle)};
}

shader::Displacement of(const Ripple& r, double time) {
  shader::Displacement d{};
  d.kind.x = shader::rippleKind;
  d.a = {reduced(time * r.speed + 6.0), r.amplitude, static_cast<float>(turn / r.wavelength), r.decay};
  d.b = {r.centre, 0};
  return d;
}

shader::Displacement of(const Wave& w, double time) {
  const double k = turn / w.length;
  // On deep water w^2 = g k.
  const double rate = w.speed > 0 ? k * w.speed : std::sqrt(9.81 * k);
  shader::Displacement d{};
  d.kind.x = shader::waveKind;
  d.a = {heading(w.direction), static_cast<float>(k), w.amplitude};
  // A cusp where Q A k = 1; more would fold the surface over itself.
  d.b = {reduced(rate * time - w.phase * 0.017453292519943295),
         w.steepness * std::min(w.amplitude, static_cast<float>(1.0 / k)), 0, 0};
  return d;
}

shader::Displacement of(const Sway& s, double time) {
  shader::Displacement d{};
  d.kind.x = shader::swayKind;
  d.a = {heading(s.direction), s.amplitude, 1.0F / s.height};
  d.b = {s.base, static_cast<float>(turn / s.wavelength), s.lean, s.gusts};
  const double phase = time * s.speed;
  d.c = {reduced(phase), reduced(1.73 * phase), reduced(3.91 * phase), 0};
  return d;
}

shader::Displacement of(const Push& p) {
  shader::Displacement d{};
  d.kind.x = shader::pushKind;
  d.a = {p.softness, p.base, p.height > 0 ? 1.0F / p.height : 0.0F, 0};
  return d;
}

/// R^T v: a rotation undone.
glm::vec3 unturned(const glm::mat4& m, const glm::vec3& v) {
  const auto row = [&](int i) { return m[i].x * v.x + m[i].y * v.y + m[i].z * v.z; };
  return {row(0), row(1), row(2)};
}

}  // namespace

DeformPlan::DeformPlan(const std::string& name, const MeshParameters& parameters, const Mesh& mesh,
                       const std::vector<ColliderShape>& colliders)
    : parameters_(parameters),
      vertices_(static_cast<int>(mesh.positions.size())),
      low_(mesh.positions.at(0)),
      high_(mesh.positions.at(0)) {
  for (const glm::vec3& p : mesh.positions) {
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
  bool touched = false;
  for (const DisplacementParameters& d : parameters_.deform.list) {
    touched = touched || d.push.on || d.footprints.on;
    if (!d.footprints.on) continue;
    hasTrail_ = true;
    footprints_ = d.footprints;
    trailCells_ = d.footprints.cells;
  }
  for (const ColliderShape& shape : colliders)
    if (touched && shape.kind != ColliderShape::Kind::plane) pressers_.push_back(shape);
  if (pressers_.size() > shader::mostPressers)
    fail(ExitCode::usage,
         "mesh \"{}\" gives way to at most {} spheres and capsules, the scene has {}; set \"collides\": "
         "false on some",
         name, shader::mostPressers, pressers_.size());
  checkPhases(name);
}

void DeformPlan::checkPhases(const std::string& name) const {
  const double reach = glm::length(glm::dvec3(glm::max(glm::abs(low_), glm::abs(high_))));
  const auto check = [&](const char* what, double wavelength, double extent) {
    if (turn / wavelength * extent > mostPhase)
      fail(ExitCode::usage,
           "mesh \"{}\": a wavelength of {} m of its {} is too short for a mesh that reaches {:.3g} m; it "
           "has to "
           "be at least {:.3g} m",
           name, wavelength, what, extent, turn * extent / mostPhase);
  };
  for (const DisplacementParameters& d : parameters_.deform.list) {
    if (d.ripple.on) check("ripple", d.ripple.wavelength, reach + glm::length(glm::dvec3(d.ripple.centre)));
    for (const Wave& w : d.waves) check("waves", w.length, reach);
    if (d.sway.on) check("sway", d.sway.wavelength, 17 * reach);
  }
}

shader::Presser DeformPlan::presser(const ColliderShape& shape, double time) const {
  // Into the mesh's own space: x = R^T (x' - position) / scale.
  const glm::mat4 turned = rotationMatrix(parameters_.rotation.at(time));
  const glm::vec3 origin = parameters_.position.at(time);
  const float smaller = 1.0F / parameters_.scale.at(time);
  const glm::vec3 along = glm::vec3(rotationMatrix(shape.rotation.at(time))[1]) * (0.5F * shape.length);
  const glm::vec3 centre = shape.position.at(time);
  const glm::vec3 a = unturned(turned, centre - along - origin) * smaller;
  const glm::vec3 b = unturned(turned, centre + along - origin) * smaller;
  return presserBetween(a, b, shape.radius * smaller);
}

shader::Presser DeformPlan::presserBetween(const glm::vec3& a, const glm::vec3& b, float radius) {
  const glm::vec3 axis = b - a;
  const float flat = axis.x * axis.x + axis.z * axis.z;
  const float squared = flat + axis.y * axis.y;
  shader::Presser p{};
  p.a = {a, radius};
  p.b = {b, squared > 1e-12F ? 1.0F / squared : 0.0F};
  p.c = {flat > 1e-12F ? 1.0F / flat : 0.0F, 0, 0, 0};
  return p;
}

shader::DeformStep DeformPlan::swept(double before, double now) const {
  shader::DeformStep step = at(now);
  for (std::size_t i = 0; i < pressers_.size(); ++i)
    if (pressers_[i].length == 0)
      step.pressers[i] = presserBetween(glm::vec3(presser(pressers_[i], before).a),
                                        glm::vec3(step.pressers[i].a), step.pressers[i].a.w);
  return step;
}

void DeformPlan::setTrail(shader::DeformStep& step) const {
  const Footprints& f = footprints_;
  const float width = std::max(high_.x - low_.x, 1e-3F) / static_cast<float>(trailCells_.x - 1);
  const float depth = std::max(high_.z - low_.z, 1e-3F) / static_cast<float>(trailCells_.y - 1);
  step.trailCells = {trailCells_, 0, 0};
  step.trailPlace = {low_.x, low_.z, 1.0F / width, 1.0F / depth};
  step.trailShape = {width, depth, f.height, f.depth};
  step.trailRim = {f.rim, 1.0F / f.rimWidth, 0, 0};
}

shader::DeformStep DeformPlan::at(double time) const {
  shader::DeformStep step{};
  int count = 0;
  const auto add = [&](const shader::Displacement& d) { step.displacements[count++] = d; };
  for (const DisplacementParameters& d : parameters_.deform.list) {
    if (d.ripple.on) add(of(d.ripple, time));
    for (const Wave& w : d.waves) add(of(w, time));
    if (d.sway.on) add(of(d.sway, time));
    if (d.push.on) add(of(d.push));
    if (d.footprints.on) {
      shader::Displacement prints{};
      prints.kind.x = shader::footprintsKind;
      add(prints);
    }
  }
  step.counts = {count, static_cast<int>(pressers_.size()), vertices_, 0};
  setTrail(step);
  for (std::size_t i = 0; i < pressers_.size(); ++i) step.pressers[i] = presser(pressers_[i], time);
  return step;
}

}  // namespace simreel::sim

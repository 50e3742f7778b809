#include "sim/mesh/deform_plan.hpp"

#include "base/error.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/core/turn.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double maxPhase = 9000.0;  // maximum phase in radians; exactSin is valid up to 1e4, so this
                                     // leaves a margin

/// Returns the angle reduced to one turn, so that its precision does not decrease with time.
float reduced(double angle) {
  return static_cast<float>(angle - turn * std::floor(angle / turn));
}

shader::Displacement of(const Ripple& r, double time) {
  shader::Displacement d{};
  d.kind = shader::rippleKind;
  d.ripple = r;
  d.ripple.phase = reduced(time * r.speed + 6.0);
  d.ripple.wavenumber = static_cast<float>(turn / r.wavelength);
  return d;
}

shader::Displacement of(const Wave& w, double time) {
  const double k = turn / w.length;
  // For deep-water waves, the angular frequency w and the wavenumber k satisfy w^2 = g k.
  const double rate = w.speed > 0 ? k * w.speed : std::sqrt(9.81 * k);
  shader::Displacement d{};
  d.kind = shader::waveKind;
  d.wave = w;
  d.wave.heading = cosineAndSine(w.direction);
  // If surge times k is 1, the crest is a cusp. A larger surge would fold the surface over itself.
  d.wave.surge = w.steepness * std::min(w.amplitude, static_cast<float>(1.0 / k));
  d.wave.wavenumber = static_cast<float>(k);
  d.wave.phase = reduced(rate * time - w.initial * 0.017453292519943295);
  return d;
}

shader::Displacement of(const Sway& s, double time) {
  const double phase = time * s.speed;
  shader::Displacement d{};
  d.kind = shader::swayKind;
  d.sway = s;
  d.sway.heading = cosineAndSine(s.direction);
  d.sway.perHeight = 1.0F / s.height;
  d.sway.wavenumber = static_cast<float>(turn / s.wavelength);
  d.sway.phases = {reduced(phase), reduced(1.73 * phase), reduced(3.91 * phase), 0};
  return d;
}

shader::Displacement of(const Push& p) {
  shader::Displacement d{};
  d.kind = shader::pushKind;
  d.push = p;
  d.push.perHeight = p.height > 0 ? 1.0F / p.height : 0.0F;
  return d;
}

/// Returns R^T v, the vector v with the rotation R undone.
glm::vec3 unturned(const glm::mat4& m, const glm::vec3& v) {
  const auto row = [&](int i) { return m[i].x * v.x + m[i].y * v.y + m[i].z * v.z; };
  return {row(0), row(1), row(2)};
}

}  // namespace

Sway Sway::onMesh(float low, float high) const {
  Sway s = *this;
  if (fitted.base) s.base = low;
  // A mesh that does not rise above the base has nothing that sways; its values do not matter.
  if (const float rise = high - s.base; fitted.height && rise > 1e-6F) s.height = rise;
  if (fitted.amplitude) s.amplitude = 0.2F * s.height;
  if (fitted.wavelength) s.wavelength = 3 * s.height;
  return s;
}

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
  footprints_.cells = {2, 2};
  bool touched = false;
  for (const DisplacementParameters& d : parameters_.deform.list) {
    touched = touched || d.push.on || d.footprints.on;
    if (d.footprints.on) footprints_ = d.footprints;
  }
  measureTrail();
  for (const ColliderShape& shape : colliders)
    if (touched && shape.kind != ColliderShape::Kind::plane && !shape.carrier) pressers_.push_back(shape);
  if (pressers_.size() > shader::maxPressers)
    fail(ExitCode::usage,
         "mesh \"{}\" gives way to at most {} spheres and capsules, the scene has {}; set \"collides\": "
         "false on some",
         name, shader::maxPressers, pressers_.size());
  checkPhases(name);
}

void DeformPlan::checkPhases(const std::string& name) const {
  const double reach = glm::length(glm::dvec3(glm::max(glm::abs(low_), glm::abs(high_))));
  const auto check = [&](const char* what, double wavelength, double extent) {
    if (turn / wavelength * extent > maxPhase)
      fail(ExitCode::usage,
           "mesh \"{}\": a wavelength of {} m of its {} is too short for a mesh that reaches {:.3g} m; it "
           "has to "
           "be at least {:.3g} m",
           name, wavelength, what, extent, turn * extent / maxPhase);
  };
  for (const DisplacementParameters& d : parameters_.deform.list) {
    if (d.ripple.on) check("ripple", d.ripple.wavelength, reach + glm::length(glm::dvec3(d.ripple.centre)));
    for (const Wave& w : d.waves) check("waves", w.length, reach);
    if (d.sway.on) check("sway", d.sway.onMesh(low_.y, high_.y).wavelength, 17 * reach);
  }
}

shader::Presser DeformPlan::presser(const ColliderShape& shape, double time) const {
  // Transforms the collider into the mesh's local space: x = R^T (x' - position) / scale, where R is the
  // mesh's rotation.
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
  p.start = glm::vec4(a, 0);
  p.end = glm::vec4(b, 0);
  p.radius = radius;
  p.perLength2 = squared > 1e-12F ? 1.0F / squared : 0.0F;
  p.perFlat2 = flat > 1e-12F ? 1.0F / flat : 0.0F;
  return p;
}

shader::DeformStep DeformPlan::swept(double before, double now) const {
  shader::DeformStep step = at(now);
  for (std::size_t i = 0; i < pressers_.size(); ++i)
    if (pressers_[i].length == 0)
      step.pressers[i] = presserBetween(glm::vec3(presser(pressers_[i], before).start),
                                        glm::vec3(step.pressers[i].start), step.pressers[i].radius);
  return step;
}

void DeformPlan::measureTrail() {
  Footprints& f = footprints_;
  f.corner = {low_.x, low_.z};
  f.cellSize = {std::max(high_.x - low_.x, 1e-3F) / static_cast<float>(f.cells.x - 1),
                std::max(high_.z - low_.z, 1e-3F) / static_cast<float>(f.cells.y - 1)};
  f.perCell = 1.0F / f.cellSize;
  f.perRimWidth = 1.0F / f.rimWidth;
}

shader::DeformStep DeformPlan::at(double time) const {
  shader::DeformStep step{};
  int count = 0;
  const auto add = [&](const shader::Displacement& d) { step.displacements[count++] = d; };
  for (const DisplacementParameters& d : parameters_.deform.list) {
    if (d.ripple.on) add(of(d.ripple, time));
    for (const Wave& w : d.waves) add(of(w, time));
    if (d.sway.on) add(of(d.sway.onMesh(low_.y, high_.y), time));
    if (d.push.on) add(of(d.push));
    if (d.footprints.on) {
      shader::Displacement prints{};
      prints.kind = shader::footprintsKind;
      add(prints);
    }
  }
  step.displacementCount = count;
  step.presserCount = static_cast<int>(pressers_.size());
  step.vertexCount = vertices_;
  step.trail = footprints_;
  for (std::size_t i = 0; i < pressers_.size(); ++i) step.pressers[i] = presser(pressers_[i], time);
  return step;
}

}  // namespace simreel::sim

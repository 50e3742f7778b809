#include "sim/cloth/plan.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace simreel::sim {

namespace {

shader::PinFrame pinFrame(const PinGroup& group, double time) {
  // The affine transform is x' = pivot + move + R S (x - pivot), with the rotation R and the scale S.
  glm::mat4 m = rotationMatrix(group.rotate.at(time));
  const glm::vec3 scale = group.scale.at(time);
  const glm::vec3 move = group.move.at(time);
  for (int i = 0; i < 3; ++i) m[i] *= scale[i];
  shader::PinFrame frame{};
  glm::vec4* rows[3] = {&frame.row0, &frame.row1, &frame.row2};
  for (int i = 0; i < 3; ++i) {
    const float turned = m[0][i] * group.pivot.x + m[1][i] * group.pivot.y + m[2][i] * group.pivot.z;
    *rows[i] = glm::vec4(m[0][i], m[1][i], m[2][i], group.pivot[i] - turned + move[i]);
  }
  return frame;
}

/// Interpolates linearly between the values at the beginning and the end of a frame, where `now` runs from
/// 0 to 1.
template <class T>
T betweenEnds(const std::array<T, 2>& ends, double now) {
  return ends[0] * (1 - now) + ends[1] * now;
}

/// Returns the transform that applies `frame` first and `carrier` second.
shader::PinFrame carriedFrame(const shader::PinFrame& frame, const glm::dmat4& carrier) {
  const glm::dvec4 rows[3] = {glm::dvec4(frame.row0), glm::dvec4(frame.row1), glm::dvec4(frame.row2)};
  shader::PinFrame result{};
  glm::vec4* to[3] = {&result.row0, &result.row1, &result.row2};
  for (int i = 0; i < 3; ++i) {
    glm::dvec4 row = rows[0] * carrier[0][i] + rows[1] * carrier[1][i] + rows[2] * carrier[2][i];
    row.w += carrier[3][i];
    *to[i] = glm::vec4(row);
  }
  return result;
}

/// Applies the rotation and scale of a frame to a direction. The result has w = 1.
glm::vec4 turned(const shader::PinFrame& frame, glm::vec3 way) {
  const auto row = [&](const glm::vec4& r) { return r.x * way.x + r.y * way.y + r.z * way.z; };
  return {row(frame.row0), row(frame.row1), row(frame.row2), 1.0F};
}

/// Returns a remark on a "wind" that is far stronger than gravity; empty if it is not. A scene that means
/// the velocity of air gives such a force.
std::string windAdvice(const ClothParameters& parameters) {
  double force = 0;
  for (const auto& key : parameters.wind.keys())
    force = std::max(force, static_cast<double>(glm::length(key.value)));
  const double weight = 9.81 * static_cast<double>(parameters.particleMass(parameters.size / 2));
  constexpr double strong = 50;
  if (parameters.mesh || force <= strong * weight) return "";
  return fmt::format(
      "\"wind\" is a force on each particle in N, here up to {:.3g} times the particle's weight; for "
      "moving air give \"air\": {{\"velocity\": [x, y, z]}} in m/s instead",
      force / weight);
}

}  // namespace

ClothPlan::ClothPlan(const ClothParameters& parameters, int seed, double frameSeconds,
                     const std::vector<ColliderShape>& colliders,
                     const std::function<Carrier(const std::string&, const std::string&)>& boneNamed,
                     double startTime, const HeldBySkin& heldBySkin, double edge)
    : parameters_(parameters),
      seed_(seed),
      substeps_(parameters.substepsPerFrame(frameSeconds)),
      substepSeconds_(frameSeconds / substeps_),
      colliders_("a cloth", colliders, substeps_, substepSeconds_),
      edge_(edge > 0 ? edge : parameters.spacing) {
  if (const std::string problem = parameters_.instability(frameSeconds); !problem.empty())
    warn("cloth: {}", problem);
  if (const std::string advice = windAdvice(parameters_); !advice.empty()) warn("cloth: {}", advice);
  if (parameters_.fabric) {
    const shader::FabricConstants fabric = parameters_.fabric->constants();
    parameters_.shearCompliance = 1.0F / fabric.shear;
    parameters_.margin += 0.5F * fabric.thickness;
  }
  thinCount_ = colliders_.putThinLast(edge_, parameters_.margin,
                                      static_cast<double>(parameters_.smallColliders) * edge_);
  for (const PinGroup& group : parameters_.pins) {
    PinCarrier& carrier = carriers_.emplace_back();
    if (group.to.empty() || group.onSkin()) continue;
    SIMREEL_CHECK(boneNamed);
    carrier.at = boneNamed(group.to, group.bone);
    carrier.fromStart = glm::inverse(carrier.at(startTime));
  }
  const glm::mat4 turn = rotationMatrix(parameters_.rotation);
  alongX_ = glm::vec3(turn[0]) * parameters_.spacing;
  alongY_ = glm::vec3(turn[2]) * parameters_.spacing;
  origin_ = parameters_.position - alongX_ * (0.5F * static_cast<float>(parameters_.size.x - 1)) -
            alongY_ * (0.5F * static_cast<float>(parameters_.size.y - 1));
  const auto& pins = parameters_.pins;
  if (parameters_.mesh ||
      std::none_of(pins.begin(), pins.end(), [](const PinGroup& g) { return g.onSkin(); }))
    return;
  std::vector<glm::vec3> rest;
  for (int y = 0; y < parameters_.size.y; ++y)
    for (int x = 0; x < parameters_.size.x; ++x) rest.push_back(restAt(x, y));
  skinPins_.attach(parameters_.pins, owners(), rest, heldBySkin, startTime);
}

glm::vec3 ClothPlan::restAt(int x, int y) const {
  return origin_ + alongX_ * static_cast<float>(x) + alongY_ * static_cast<float>(y);
}

std::vector<int> ClothPlan::owners() const {
  std::vector<int> owners(
      static_cast<std::size_t>(parameters_.size.x) * static_cast<std::size_t>(parameters_.size.y), -1);
  for (std::size_t group = 0; group < parameters_.pins.size(); ++group)
    for (const int i : parameters_.pinnedBy(parameters_.pins[group]))
      owners[static_cast<std::size_t>(i)] = static_cast<int>(group);
  return owners;
}

std::vector<glm::vec4> ClothPlan::firstPositions() const {
  const glm::ivec2 size = parameters_.size;
  std::vector<glm::vec4> positions;
  positions.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec3 noise = shader::signedUnits(shader::hash3(
          {static_cast<unsigned>(x), static_cast<unsigned>(y), static_cast<unsigned>(seed_)}));
      positions.emplace_back(restAt(x, y) + noise * parameters_.jitter,
                             1.0F / parameters_.particleMass({x, y}));
    }
  for (const PinGroup& group : parameters_.pins)
    for (const int i : parameters_.pinnedBy(group)) positions[static_cast<std::size_t>(i)].w = 0.0F;
  return positions;
}

std::vector<glm::vec4> ClothPlan::firstVelocities() const {
  const glm::ivec2 size = parameters_.size;
  std::vector<glm::vec4> velocities(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y),
                                    glm::vec4(0));
  for (std::size_t group = 0; group < parameters_.pins.size(); ++group)
    for (const int i : parameters_.pinnedBy(parameters_.pins[group]))
      velocities[static_cast<std::size_t>(i)].w = static_cast<float>(group);
  for (const unsigned i : skinPins_.particles()) velocities[i].w = heldBySkinMark;
  return velocities;
}

std::vector<std::array<glm::dmat4, 2>> ClothPlan::pinsAround(double time) const {
  const double end = time + substeps_ * substepSeconds_;
  std::vector<std::array<glm::dmat4, 2>> pins;
  for (const PinCarrier& carrier : carriers_) {
    auto& pair = pins.emplace_back();
    if (carrier.at) pair = {carrier.at(time) * carrier.fromStart, carrier.at(end) * carrier.fromStart};
  }
  return pins;
}

Softness ClothPlan::softness() const {
  if (!parameters_.keepsEnergy() || parameters_.mesh) return {};
  // A straight line whose tension gives it the frequency w is stable up to a softening of 1 / (w dt)^2. In
  // a swing, the tension is three times the hanging weight.
  const double squared = substepSeconds_ * substepSeconds_;
  const double maximum = 1.0 / (3.0 * parameters_.hangingSquared() * squared);
  return {std::max(std::min(softSeconds * softSeconds / squared, maximum), minSoftening), substepSeconds_};
}

// A substep relaxes each diagonal once, so its effective stiffness is 1 / (compliance + w h^2), where w is
// the sum of the inverse masses of both ends and h the time step of constraints. The factor 2/3 on w was
// measured with rubber sheets that hang, with 4 to 64 substeps. Constraints that keep energy are softened
// in a different way.
double ClothPlan::diagonalStiffness() const {
  const double shear = parameters_.fabric.value_or(Fabric{}).constants().shear;
  if (parameters_.keepsEnergy()) return shear;
  const double reach = constraintPart * substepSeconds_;
  const double inverseMasses = 2.0 / parameters_.particleMass({1, 1});
  return 1 / (1 / shear + 2.0 / 3 * inverseMasses * reach * reach);
}

// Sets the values for moving air at the start of a substep, and moves the gusts.
void ClothPlan::setAir(shader::ClothStep& s, double start) {
  const Air moved = parameters_.air.value_or(Air{});
  const glm::vec3 air = parameters_.air ? moved.velocity.at(start) : glm::vec3(0);
  const auto speed =
      static_cast<float>(std::sqrt(static_cast<double>(air.x) * air.x + static_cast<double>(air.y) * air.y +
                                   static_cast<double>(air.z) * air.z));
  for (int axis = 0; axis < 3; ++axis) drift_[axis] += air[axis] * substepSeconds_;
  s.airVelocity = glm::vec4(air, 0);
  s.gustDrift = glm::vec4(drift_[0], drift_[1], drift_[2], 0);
  s.gustSpeed = moved.gusts * speed;
  s.perGustSize = 1.0F / moved.gustSize;
  s.air = moved;
}

// Sets the transforms of the pins at the end of a substep, and the directions of clamped borders.
void ClothPlan::setPins(shader::ClothStep& s, double end,
                        const std::vector<std::array<glm::dmat4, 2>>& pins, double part) const {
  const ClothParameters& p = parameters_;
  for (std::size_t g = 0; g < p.pins.size(); ++g) {
    s.frames[g] = pinFrame(p.pins[g], end);
    if (carriers_[g].at) s.frames[g] = carriedFrame(s.frames[g], betweenEnds(pins[g], part));
  }
  const glm::vec3 inwards[4] = {alongX_, -alongX_, alongY_, -alongY_};
  for (int border = 0; border < 4; ++border)
    if (const int group = p.clampOf(border); group >= 0)
      s.clamped[border] = turned(s.frames[group], inwards[border]);
}

std::vector<shader::ClothStep> ClothPlan::frame(double time) {
  std::vector<shader::ClothStep> steps(static_cast<std::size_t>(substeps_));
  const ClothParameters& p = parameters_;
  const Fabric cloth = p.fabric.value_or(Fabric{});
  const shader::FabricConstants fabric = cloth.ofLinks(diagonalStiffness());
  const auto colliders = colliders_.frame(time);
  const auto pins = pinsAround(time);
  for (int i = 0; i < substeps_; ++i) {
    const double start = time + i * substepSeconds_;
    const double end = time + (i + 1) * substepSeconds_;
    shader::ClothStep& s = steps[static_cast<std::size_t>(i)];
    s.gravity = glm::vec4(p.gravity.at(start), 0);
    s.wind = glm::vec4(p.wind.at(start), 0);
    setAir(s, start);
    s.origin = glm::vec4(origin_, 0);
    s.alongX = glm::vec4(alongX_, 0);
    s.alongY = glm::vec4(alongY_, 0);
    s.dt = static_cast<float>(substepSeconds_);
    s.perDt = static_cast<float>(1.0 / substepSeconds_);
    const double damped = cloth.stretchDamping / (cloth.stretchDamping + substepSeconds_);
    s.dampedPart = static_cast<float>(damped);
    const double reach = p.keepsEnergy() ? substepSeconds_ : constraintPart * substepSeconds_;
    s.perReach = static_cast<float>(1.0 / reach);
    s.trendDt = static_cast<float>(substepSeconds_ / 18);
    // The faces of a mesh are relaxed twice, in forward and in reverse order.
    const double rounds = p.mesh && !p.keepsEnergy() ? 2.0 : 1.0;
    s.complianceScale = static_cast<float>(rounds * (1.0 - damped) / (reach * reach));
    s.softening = softness().lines > 0 ? static_cast<float>(softness().lines) : 1.0F;
    s.kept = keptOf(p.damping, substepSeconds_);
    s.colliderCount = colliderCount();
    s.thinCount = thinCount_;
    s.thinRoom = static_cast<float>(3 * edge_);
    s.substep = static_cast<int>(done_);
    s.seed = seed_;
    s.constants = p;
    s.fabric = fabric;
    s.perBend = fabric.bending / (p.spacing * p.spacing);
    std::ranges::copy(colliders[static_cast<std::size_t>(i)], s.colliders);
    setPins(s, end, pins, static_cast<double>(i + 1) / substeps_);
    ++done_;
  }
  return steps;
}

}  // namespace simreel::sim

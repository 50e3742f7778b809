#pragma once
#include "sim/cloth/parameters.hpp"
#include "sim/cloth/quantities.hpp"
#include "sim/cloth/skin_pins.hpp"
#include "sim/collide/colliders.hpp"
#include "sim/core/carry_over.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// The springs of a sheet: each particle has one of each family, to the neighbour at `reach`. Constraints
/// of the structural ones are solved a line at a time (glsl/cloth/line_model.glsl), after all others.
struct SpringFamily {
  glm::ivec2 reach;  ///< cells
  int kind;          ///< 0 structural, 1 shear, 2 bend (glsl/cloth/model.glsl)
};
inline constexpr SpringFamily springFamilies[] = {{{1, 0}, 0},  {{0, 1}, 0}, {{1, 1}, 1},
                                                  {{-1, 1}, 1}, {{2, 0}, 2}, {{0, 2}, 2}};
/// The families that are relaxed pair by pair; a fabric bends by forces instead.
inline std::span<const SpringFamily> relaxedFamilies(const ClothParameters& parameters) {
  return std::span(springFamilies).subspan(2, parameters.hasFabric ? 2 : 4);
}

/// Everything of a cloth that is decided on the CPU: its first state and, frame by frame, what each substep
/// is told. Shared by the GPU simulation and its CPU twin, so both start and go on from the same numbers.
class ClothPlan {
 public:
  /// Throws UserError(usage) when there are more colliders than the kernels hold, or "auto" takes more
  /// substeps than there may be; warns once when the given substeps are fewer than it needs.
  /// `boneNamed`, `startTime`, `heldBySkin`: as of Setting; who has pins that a body carries needs them.
  /// `edge`: the longest between vertices (m), 0: a grid's spacing.
  ClothPlan(const ClothParameters& parameters, int seed, double frameSeconds,
            const std::vector<ColliderShape>& colliders,
            const std::function<Carrier(const std::string& body, const std::string& bone)>& boneNamed = {},
            double startTime = 0, const HeldBySkin& heldBySkin = {}, double edge = 0);

  /// The same in every step: those that vertices feel, and thin ones that edges and faces do.
  [[nodiscard]] int colliderCount() const { return colliders_.count() - thinCount_; }
  [[nodiscard]] int thinCount() const { return thinCount_; }
  /// xyz in m, w inverse mass in 1/kg (0: pinned); size.x * size.y elements, x fastest.
  [[nodiscard]] std::vector<glm::vec4> firstPositions() const;
  /// xyz in m/s (zero), w the pin group of a pinned particle.
  [[nodiscard]] std::vector<glm::vec4> firstVelocities() const;
  /// The substeps of the frame that starts at `time` (s). Call in order: gusts drift from frame to frame.
  [[nodiscard]] std::vector<shader::ClothStep> frame(double time);
  void carryOver(CarryOver& carry) {
    carry.number("steps begun", done_);
    for (double& drift : drift_) carry.number("gusts' drift", drift);
  }

  [[nodiscard]] const ClothParameters& parameters() const { return parameters_; }
  [[nodiscard]] const SkinPins& skinPins() const { return skinPins_; }  ///< of a grid
  [[nodiscard]] int substeps() const { return substeps_; }
  /// Of all frames that were asked for.
  [[nodiscard]] int stepsBegun() const { return static_cast<int>(done_); }
  [[nodiscard]] double substepSeconds() const { return substepSeconds_; }
  /// Of constraints that keep energy; zero of others.
  [[nodiscard]] Softness softness() const;
  /// N/m, of the diagonals of a fabric in one substep.
  [[nodiscard]] double diagonalStiffness() const;

 private:
  /// Of each particle of a grid: its pin group; -1: free.
  [[nodiscard]] std::vector<int> owners() const;
  [[nodiscard]] glm::vec3 restAt(int x, int y) const;
  /// What a frame that starts at `time` begins and ends with, of each pin group, on top of its own frame.
  [[nodiscard]] std::vector<std::array<glm::dmat4, 2>> pinsAround(double time) const;

  ClothParameters parameters_;
  int seed_;
  int substeps_;
  double substepSeconds_;
  ColliderPlan colliders_;
  double edge_;  ///< m
  int thinCount_ = 0;
  /// What carries a pin group, and its inverse at the start; empty: nothing.
  struct PinCarrier {
    Carrier at;
    glm::dmat4 fromStart{1};
  };
  std::vector<PinCarrier> carriers_;
  SkinPins skinPins_;
  glm::vec3 alongX_, alongY_, origin_;
  double drift_[3] = {0, 0, 0};
  std::uint32_t done_ = 0;  ///< substeps so far
};

}  // namespace simreel::sim

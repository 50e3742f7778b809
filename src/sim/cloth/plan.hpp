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

/// Family of springs of a sheet: each particle is linked to the neighbour at the offset `reach`. Structural
/// constraints are solved for a whole line together (glsl/cloth/line_model.glsl), after the other families.
struct SpringFamily {
  glm::ivec2 reach;  ///< offset in cells along x and y
  int kind;          ///< kind of spring: 0 structural, 1 shear, 2 bend (glsl/cloth/model.glsl)
};
inline constexpr SpringFamily springFamilies[] = {{{1, 0}, 0},  {{0, 1}, 0}, {{1, 1}, 1},
                                                  {{-1, 1}, 1}, {{2, 0}, 2}, {{0, 2}, 2}};
/// Returns the families that are relaxed pair by pair. A fabric omits the bending families, because it
/// bends by forces.
inline std::span<const SpringFamily> relaxedFamilies(const ClothParameters& parameters) {
  return std::span(springFamilies).subspan(2, parameters.fabric ? 2 : 4);
}

/// The part of a cloth that the CPU computes: the initial state and the uniform data of each substep. The
/// GPU simulation and its CPU reference both use it, so they compute from identical numbers.
class ClothPlan {
 public:
  /// Throws UserError(usage) if there are more colliders than the kernels support or if "auto" needs too
  /// many substeps. Warns once if the given number of substeps is too small. `boneNamed`, `startTime` and
  /// `heldBySkin` are the members of Setting; pins that a body carries require them. `edge` is the length
  /// of the longest edge in metres; 0 means the grid's spacing.
  ClothPlan(const ClothParameters& parameters, int seed, double frameSeconds,
            const std::vector<ColliderShape>& colliders,
            const std::function<Carrier(const std::string& body, const std::string& bone)>& boneNamed = {},
            double startTime = 0, const HeldBySkin& heldBySkin = {}, double edge = 0);

  /// Returns the number of colliders that are tested against vertices; it is the same in every substep.
  /// Thin colliders are not included, because they are tested against edges and faces (see thinCount()).
  [[nodiscard]] int colliderCount() const { return colliders_.count() - thinCount_; }
  [[nodiscard]] int thinCount() const { return thinCount_; }
  /// Returns size.x * size.y elements, x fastest: xyz is the position in metres, w the inverse mass in 1/kg
  /// (0 if pinned).
  [[nodiscard]] std::vector<glm::vec4> firstPositions() const;
  /// Returns one element per particle: xyz is the velocity in m/s (zero), w the pin group of a pinned
  /// particle.
  [[nodiscard]] std::vector<glm::vec4> firstVelocities() const;
  /// Returns the data of the substeps of the frame that starts at `time` (seconds). Frames must be
  /// requested in order, because the drift of the gusts accumulates.
  [[nodiscard]] std::vector<shader::ClothStep> frame(double time);
  void visitCheckpointData(CarryOver& carry) {
    carry.number("steps begun", done_);
    for (double& drift : drift_) carry.number("gusts' drift", drift);
  }

  [[nodiscard]] const ClothParameters& parameters() const { return parameters_; }
  [[nodiscard]] const SkinPins& skinPins() const { return skinPins_; }  ///< valid only for a grid
  [[nodiscard]] int substeps() const { return substeps_; }
  /// Returns the total number of substeps of all frames requested so far.
  [[nodiscard]] int stepsBegun() const { return static_cast<int>(done_); }
  [[nodiscard]] double substepSeconds() const { return substepSeconds_; }
  /// Returns the softness of the constraints; zero if they do not keep energy.
  [[nodiscard]] Softness softness() const;
  /// Returns the effective stiffness (N/m) that the diagonals of a fabric have in one substep.
  [[nodiscard]] double diagonalStiffness() const;

 private:
  /// Returns the pin group of each particle of a grid, or -1 if it is not pinned.
  [[nodiscard]] std::vector<int> owners() const;
  [[nodiscard]] glm::vec3 restAt(int x, int y) const;
  /// Returns the transform of each pin group's carrier, relative to the start of the run, at the beginning
  /// and at the end of the frame that starts at `time`.
  [[nodiscard]] std::vector<std::array<glm::dmat4, 2>> pinsAround(double time) const;
  void setAir(shader::ClothStep& s, double start);
  void setPins(shader::ClothStep& s, double end, const std::vector<std::array<glm::dmat4, 2>>& pins,
               double part) const;

  ClothParameters parameters_;
  int seed_;
  int substeps_;
  double substepSeconds_;
  ColliderPlan colliders_;
  double edge_;  ///< length of the longest edge in metres
  int thinCount_ = 0;
  /// Moving frame that carries a pin group, and the inverse of that frame at the start of the run. The
  /// frame is null if nothing carries the group.
  struct PinCarrier {
    Carrier at;
    glm::dmat4 fromStart{1};
  };
  std::vector<PinCarrier> carriers_;
  SkinPins skinPins_;
  glm::vec3 alongX_, alongY_, origin_;
  double drift_[3] = {0, 0, 0};
  std::uint32_t done_ = 0;  ///< number of substeps of all frames requested so far
};

}  // namespace simreel::sim

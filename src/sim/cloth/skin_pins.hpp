#pragma once
#include "sim/cloth/parameters.hpp"
#include "sim/core/carrier.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// What pinned particles that follow the skin of a body have instead of a pin group, in their velocity's w.
inline constexpr float heldBySkinMark = -1.0F;

/// Particles that follow places of a body's skin, in a straight line from a frame's beginning to its end,
/// as the skin itself does (glsl/cloth/hold.comp).
class SkinPins {
 public:
  /// `owners`: of each particle its pin group, or -1; `rest` (m, world): where they are at `startTime`.
  void attach(const std::vector<PinGroup>& groups, const std::vector<int>& owners,
              const std::vector<glm::vec3>& rest, const HeldBySkin& heldBySkin, double startTime);
  [[nodiscard]] int count() const { return static_cast<int>(particles_.size()); }
  [[nodiscard]] const std::vector<unsigned>& particles() const { return particles_; }
  /// Of the frame from `begin` to `end` (s), two a particle: xyz where it is at the beginning (m), w its
  /// number; where at the end.
  [[nodiscard]] std::vector<glm::vec4> frame(double begin, double end) const;

 private:
  std::vector<SkinHolder> holders_;
  std::vector<unsigned> particles_;  ///< holder by holder
};

}  // namespace simreel::sim

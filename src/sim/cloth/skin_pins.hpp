#pragma once
#include "sim/cloth/parameters.hpp"
#include "sim/core/carrier.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Value of a particle's velocity.w if the particle is pinned to a body's skin; other pinned particles
/// store their pin group there.
inline constexpr float heldBySkinMark = -1.0F;

/// Particles that follow points of a body's skin. Within a frame they move in a straight line, like the
/// skin (glsl/cloth/hold.comp).
class SkinPins {
 public:
  /// Attaches to the skin those particles whose pin groups are held by a skin. `owners` holds the pin group
  /// of each particle, or -1; `rest` holds the positions at `startTime` in world space, in metres.
  void attach(const std::vector<PinGroup>& groups, const std::vector<int>& owners,
              const std::vector<glm::vec3>& rest, const HeldBySkin& heldBySkin, double startTime);
  [[nodiscard]] int count() const { return static_cast<int>(particles_.size()); }
  [[nodiscard]] const std::vector<unsigned>& particles() const { return particles_; }
  /// Returns two elements per attached particle for the frame from `begin` to `end` (seconds): the position
  /// at the beginning (metres) with the particle's index in w, then the position at the end.
  [[nodiscard]] std::vector<glm::vec4> frame(double begin, double end) const;

 private:
  std::vector<SkinHolder> holders_;
  std::vector<unsigned> particles_;  ///< particle indices, grouped by SkinHolder
};

}  // namespace simreel::sim

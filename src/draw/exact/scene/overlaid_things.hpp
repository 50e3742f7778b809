#pragma once
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <cstddef>
#include <deque>

#include <glm/vec3.hpp>

namespace simreel::draw {

/// Returns the linear RGB colour of object number i in the overlay "objects". The hues of consecutive
/// numbers are a golden section apart, so that any few numbers have distinct hues.
[[nodiscard]] glm::vec3 objectColor(std::size_t i);

/// Prepares drawables for an overlay.
class OverlaidThings {
 public:
  /// Gives all surfaces and instances opaque materials that suit the scene's overlay, and removes glows.
  /// Does nothing without an overlay. The materials are valid until the next call.
  void apply(const scene::Scene& scene, sim::Drawables& drawables);

 private:
  std::deque<scene::Material> materials_;
};

}  // namespace simreel::draw

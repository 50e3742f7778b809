#pragma once
#include "scene/scene.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace simreel::scene {

/// Interface of the parameters of objects that look empty until they have run for a while.
class HasWarmUp {
 public:
  virtual ~HasWarmUp() = default;
  /// Returns the seconds after which the object looks the same from then on, at most some seconds. Returns
  /// 0 if its first state is part of the scene.
  [[nodiscard]] virtual double warmUp() const = 0;
};

/// Returns the seconds that a scene without "start" simulates before frame 0: the longest of its objects.
/// Returns 0 if the scene has an object with a first state of its own, because that object would move, too.
[[nodiscard]] inline double warmUpOf(const Scene& scene) {
  constexpr std::array<std::string_view, 20> still = {
      "arrows",  "body",     "box",    "capsule",     "chart", "colorBar", "cone",
      "contour", "cylinder", "disc",   "flow",        "image", "isolines", "mesh",
      "plane",   "scaleBar", "sphere", "streamlines", "text",  "torus"};
  double seconds = 0;
  for (const Object& object : scene.objects) {
    if (std::find(still.begin(), still.end(), object.kind) != still.end()) continue;
    const auto* warm = dynamic_cast<const HasWarmUp*>(object.parameters.get());
    const double own = warm == nullptr ? 0 : warm->warmUp();
    if (own == 0) return 0;
    seconds = std::max(seconds, own);
  }
  return seconds;
}

}  // namespace simreel::scene

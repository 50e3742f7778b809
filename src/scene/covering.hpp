#pragma once

namespace simreel::scene {

/// Interface of the parameters of objects that may be drawn over the whole picture.
class Covering {
 public:
  virtual ~Covering() = default;
  /// True if the object hides everything in the world at time 0.
  [[nodiscard]] virtual bool covers() const = 0;
};

}  // namespace simreel::scene

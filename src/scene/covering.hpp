#pragma once

namespace simreel::scene {

/// Interface of parameters of objects that may be drawn over the whole picture.
class Covering {
 public:
  virtual ~Covering() = default;
  /// True if the object hides everything in the world at the start.
  [[nodiscard]] virtual bool covers() const = 0;
};

}  // namespace simreel::scene

#pragma once

namespace simreel::scene {

/// Interface of the parameters of objects that weight may pull through the ground.
class Falling {
 public:
  virtual ~Falling() = default;
  /// Returns the lowest height in metres that weight alone takes a part of the object to within `seconds`
  /// of its start, among the parts that start above `ground`. The result is infinity if there is no such
  /// part, or if the ground stops the object.
  [[nodiscard]] virtual double fallsTo(double seconds, double ground) const = 0;
};

}  // namespace simreel::scene

#pragma once
#include <string>

namespace simreel::scene {

/// Interface of the parameters of objects that are drawn on the rectangle of another object, such as arrows
/// on a flow.
class DrawnOn {
 public:
  virtual ~DrawnOn() = default;
  /// Returns the name of the other object.
  [[nodiscard]] virtual const std::string& source() const = 0;
  /// True if an automatic camera must show the rectangle of a source that does not request it itself. Only
  /// scenes since version 2 do so.
  [[nodiscard]] virtual bool framesSource() const = 0;
};

}  // namespace simreel::scene

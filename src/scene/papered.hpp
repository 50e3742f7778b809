#pragma once
#include <string>

namespace simreel::scene {

/// Interface of parameters of objects that may be drawn in the colours of a field.
class Papered {
 public:
  virtual ~Papered() = default;
  /// Returns the name of the field whose colours the object has if its material has no "skin"; empty: none.
  /// `object`: name of the object itself.
  [[nodiscard]] virtual std::string fieldShown(const std::string& object) const = 0;
};

}  // namespace simreel::scene

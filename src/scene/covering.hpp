#pragma once

namespace simreel::scene {

/// Interface of the parameters of objects whose field is drawn over the picture or behind everything.
class Covering {
 public:
  /// none: not drawn. part: over a part of the picture, or not opaque. whole: over the whole picture, so
  /// that it hides everything in the world. behind: behind all objects.
  enum class Extent { none, part, whole, behind };
  virtual ~Covering() = default;
  /// Returns the part of the picture that the field covers at time 0.
  [[nodiscard]] virtual Extent covering() const = 0;
  /// True if the field has colours of its own for its states, which a skin of this field keeps.
  [[nodiscard]] virtual bool hasStates() const { return false; }
};

}  // namespace simreel::scene

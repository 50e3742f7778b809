#pragma once
#include <glm/vec2.hpp>

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
  /// Keeps strips of the picture free at the right and at the bottom, as fractions of the picture. Only a
  /// field whose fit is "contain" is drawn smaller.
  virtual void leaveRoom(glm::vec2 /*room*/) {}
  /// True if the field has colours of its own for its states, which a skin of this field keeps.
  [[nodiscard]] virtual bool hasStates() const { return false; }
};

}  // namespace simreel::scene

#pragma once
#include "scene/scene.hpp"

namespace simreel::sim {

/// A simulation that can be given other values on its way.
class Retunable {
 public:
  virtual ~Retunable() = default;
  /// Takes over from `now`, of its own kind, what each frame asks for anew, where nothing else differs and
  /// no array or kernel comes of it. It goes on from its present state, which came out of the values
  /// before. False, and nothing has happened: it has to be made anew.
  [[nodiscard]] virtual bool retune(const scene::Parameters& now) = 0;
};

}  // namespace simreel::sim

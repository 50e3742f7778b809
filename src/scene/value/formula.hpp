#pragma once
#include "scene/value/animated.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::scene {

/// Value of one or more components that a scene gives as numbers, as expressions, or as one to four numbers
/// that move along keyframes.
struct Formula {
  struct Part {
    double number = 0;
    std::string text = {};  ///< expression; empty: the number

    bool operator==(const Part&) const = default;
  };
  std::vector<Part> parts;                    ///< components; a matrix row by row
  std::optional<Animated<glm::vec4>> moving;  ///< in place of parts
  int width = 0;                              ///< components of `moving`

  [[nodiscard]] bool empty() const { return parts.empty() && !moving; }
  [[nodiscard]] std::size_t components() const {
    return moving ? static_cast<std::size_t>(width) : parts.size();
  }
};

/// Formulas under names, in the scene's order; a single one without a name is the value of the whole.
struct Formulas {
  struct Named {
    std::string name;
    Formula formula;
  };
  std::vector<Named> list;

  [[nodiscard]] const Formula* find(std::string_view name) const {
    for (const Named& one : list)
      if (one.name == name) return &one.formula;
    return nullptr;
  }
};

/// Most components of a formula: four matrices of 4 x 4.
inline constexpr std::size_t maxFormulaParts = 64;

}  // namespace simreel::scene

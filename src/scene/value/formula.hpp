#pragma once
#include "scene/value/animated.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::scene {

/// Value of one or more components. It consists of numbers and expressions, or of keyframes of one to four
/// numbers.
struct Formula {
  struct Part {
    double number = 0;
    std::string text = {};  ///< expression; if it is empty, `number` is the value

    bool operator==(const Part&) const = default;
  };
  std::vector<Part> parts;                    ///< components; a matrix is in row-major order
  std::optional<Animated<glm::vec4>> moving;  ///< keyframes; they replace `parts`
  int width = 0;                              ///< number of components that `moving` uses

  [[nodiscard]] bool empty() const { return parts.empty() && !moving; }
  [[nodiscard]] std::size_t components() const {
    return moving ? static_cast<std::size_t>(width) : parts.size();
  }
};

/// Formulas with names, in the order of the scene. A single formula may have no name.
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

/// Maximum number of components of a formula: the 32-bit numbers in a uniform block of 64 KB.
inline constexpr std::size_t maxFormulaParts = 16384;

}  // namespace simreel::scene

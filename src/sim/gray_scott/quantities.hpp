#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// GrayScottParameters::quantities() of a state, in that order. `cells`: two
/// cells (u, v, u, v) an element, rows of (width + 1) / 2.
[[nodiscard]] std::vector<double> measureGrayScott(std::span<const glm::vec4> cells, glm::ivec2 size);

/// Patches of a torus where `inside` is not 0, joined over edges: their number, and the cells of the
/// largest.
struct Patches {
  int count = 0;
  int largest = 0;
};
[[nodiscard]] Patches patchesOf(const std::vector<char>& inside, glm::ivec2 size);

/// Wavelength (cells) that carries most of a torus' variance: middle of the highest rings of the power
/// spectrum, each ring summed over directions. 0 for an even field. Fields wider or higher than 384 cells
/// are averaged down by a whole factor first.
[[nodiscard]] double dominantWavelength(std::span<const float> values, glm::ivec2 size);

}  // namespace simreel::sim

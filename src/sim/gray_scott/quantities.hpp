#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the values of GrayScottParameters::quantities() for a state, in the order of quantities().
/// `cells` has two cells (u, v, u, v) per element, in rows of (width + 1) / 2 elements.
[[nodiscard]] std::vector<double> measureGrayScott(std::span<const glm::vec4> cells, glm::ivec2 size);

/// Connected components of the cells whose `inside` is not 0: their number, and the number of cells in the
/// largest. Cells are connected over edges on a periodic grid.
struct Patches {
  int count = 0;
  int largest = 0;
};
[[nodiscard]] Patches patchesOf(const std::vector<char>& inside, glm::ivec2 size);

/// Returns the wavelength (cells) that carries most of the variance of a periodic field: the power-weighted
/// mean around the peak of the power spectrum, which is summed over directions. Returns 0 for a uniform
/// field. A field that is wider or higher than 384 cells is first averaged down by an integer factor.
[[nodiscard]] double dominantWavelength(std::span<const float> values, glm::ivec2 size);

}  // namespace simreel::sim

#pragma once
#include <filesystem>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Velocities at the centres of the cells of a grid, stored row by row from the top. Their x component
/// points right, the y component down.
struct FlowGrid {
  glm::ivec2 size{0, 0};           ///< width and height in cells
  float cell = 1;                  ///< width of a cell in metres
  std::vector<glm::dvec2> values;  ///< m/s
};

/// Reads velocities from an npy file of the shape (rows, columns, 2) or from a CSV file with the columns x,
/// y, u and v, whose points form a regular grid and may be in any order. `up` is true if the rows of an npy
/// file are ordered upwards. `cell` is the cell width of an npy file in metres. Throws UserError with file
/// and line.
[[nodiscard]] FlowGrid readFlow(const std::filesystem::path& file, bool up, float cell);

}  // namespace simreel::sim

#pragma once
#include "sim/fluid/wind.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of a fluid's wind that acts on other objects. It contains the flow with the ring of border
/// cells.
struct WindTwin {
  simreel::shader::WindGrid grid{};
  std::vector<glm::vec4> flow = {};

  [[nodiscard]] glm::vec4 cell(int x, int y) const {
    return flow.at(static_cast<std::size_t>((y + 1) * (grid.size.x + 2) + x + 1));
  }
};

/// Provides the wind that kernels read (glsl/fluid/wind_array.glsl). There is no wind until blow() has been
/// called with a wind.
struct WindKernel {
  bool blown = false;
  const WindTwin* windTwin = nullptr;
  simreel::shader::WindGrid windGrid{};

  void blow(const std::optional<WindTwin>& wind) {
    blown = wind.has_value();
    if (!blown) return;
    windTwin = &*wind;
    windGrid = wind->grid;
  }
  [[nodiscard]] glm::vec4 loadWindCell(int x, int y) const { return windTwin->cell(x, y); }
};

#pragma once
#include "sim/fluid/wind.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// A fluid as the wind of others on the CPU: its flow, with the ring around it.
struct WindTwin {
  simreel::shader::WindGrid grid{};
  std::vector<glm::vec4> flow = {};

  [[nodiscard]] glm::vec4 cell(int x, int y) const {
    return flow.at(static_cast<std::size_t>((y + 1) * (grid.size.x + 2) + x + 1));
  }
};

/// What kernels ask of their wind (glsl/fluid/wind_array.glsl): none until there is one to blow.
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

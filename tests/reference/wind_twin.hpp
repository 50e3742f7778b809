#pragma once
#include "sim/fluid/wind.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// A fluid on the CPU as the wind of other objects: its flow with the border ring.
struct WindTwin {
  simreel::shader::WindGrid grid{};
  std::vector<glm::vec4> flow = {};

  [[nodiscard]] glm::vec4 cell(int x, int y) const {
    return flow.at(static_cast<std::size_t>((y + 1) * (grid.size.x + 2) + x + 1));
  }
};

/// The wind's interface for kernels (glsl/fluid/wind_array.glsl); no wind until a fluid is set.
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

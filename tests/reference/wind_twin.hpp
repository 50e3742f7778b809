#pragma once
#include "sim/fluid/wind.hpp"

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

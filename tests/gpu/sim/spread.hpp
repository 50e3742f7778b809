#pragma once
#include "gpu/context.hpp"
#include "reference/spread_twin.hpp"
#include "sim/spread/epidemic.hpp"
#include "sim/spread/grid.hpp"
#include "sim/spread/wildfire.hpp"

#include <memory>

namespace spread {

constexpr double frameSeconds = 1.0 / 30.0;

template <class Parameters>
std::unique_ptr<simreel::sim::Simulation> make(const simreel::sim::SimulationKind& kind,
                                               const Parameters& parameters, int seed = 5) {
  testContext();
  simreel::scene::Object object;
  object.name = "field";
  object.kind = kind.kind.name;
  object.parameters = std::make_unique<Parameters>(parameters);
  static const std::vector<simreel::sim::ColliderShape> colliders;
  return kind.make(object, {false, seed, frameSeconds, &colliders});
}

inline simreel::sim::StrokeParameters dot(glm::vec3 at, float radius, double value = 1, double time = 0) {
  simreel::sim::StrokeParameters stroke;
  stroke.at = time;
  stroke.from = stroke.to = at;
  stroke.radius = radius;
  stroke.value = value;
  return stroke;
}

/// Returns the cells of the state without the padding of rows.
inline std::vector<std::uint8_t> cellsOf(const simreel::sim::Simulation& simulation, glm::ivec2 size) {
  const auto bytes = simulation.state()[0].buffer->readAll<std::uint8_t>();
  const auto width = static_cast<std::size_t>(size.x);
  const std::size_t rowBytes = (width + 15) / 16 * 16;
  std::vector<std::uint8_t> cells;
  for (std::size_t y = 0; y < static_cast<std::size_t>(size.y); ++y)
    cells.insert(cells.end(), bytes.begin() + static_cast<std::ptrdiff_t>(y * rowBytes),
                 bytes.begin() + static_cast<std::ptrdiff_t>(y * rowBytes + width));
  return cells;
}

inline std::vector<glm::uvec4> rowsOf(const simreel::sim::Simulation& simulation) {
  const auto table = simulation.counts();
  auto rows = table.steps->readAll<glm::uvec4>();
  rows.resize(static_cast<std::size_t>(table.rows));
  return rows;
}

}  // namespace spread

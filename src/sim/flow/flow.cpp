#include "sim/flow/flow.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "sim/core/kind.hpp"
#include "sim/flow/parameters.hpp"
#include "sim/flow/sheet.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/grid/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Returns the grid of velocities of an object. Error messages name the object.
FlowGrid gridOf(const scene::Object& object) {
  try {
    return parametersOf<FlowParameters>(object).grid();
  } catch (const UserError& error) {
    fail(error.code(), "flow \"{}\": {}", object.name, error.what());
  }
}

FluidPlane planeOf(const scene::Object& object, const FlowGrid& grid) {
  FluidPlane plane = parametersOf<FlowParameters>(object).plane;
  plane.cell = grid.cell;
  return plane;
}

/// Returns the flow at the left face and the top face of each cell in cells/s, and in z the speed in the
/// cell's middle, 0 in the ring of one cell around the grid (FluidWind). The flow at a face is the mean of
/// the cells on both sides of the face. Beyond the grid, velocities are extrapolated linearly, so the flow
/// between the faces equals a linear field exactly, up to the borders.
std::vector<glm::vec4> faces(const FlowGrid& grid) {
  const auto inside = [&](int x, int y) {
    return grid.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.size.x) +
                       static_cast<std::size_t>(x)];
  };
  const auto row = [&](int x, int y) {
    const int near = x < 0 ? 0 : grid.size.x - 1, next = x < 0 ? 1 : grid.size.x - 2;
    if (x >= 0 && x < grid.size.x) return inside(x, y);
    return inside(near, y) + static_cast<double>(std::abs(x - near)) * (inside(near, y) - inside(next, y));
  };
  const auto at = [&](int x, int y) {
    const int near = y < 0 ? 0 : grid.size.y - 1, next = y < 0 ? 1 : grid.size.y - 2;
    if (y >= 0 && y < grid.size.y) return row(x, y);
    return row(x, near) + static_cast<double>(std::abs(y - near)) * (row(x, near) - row(x, next));
  };
  std::vector<glm::vec4> cells;
  const double perCell = 1 / static_cast<double>(grid.cell);
  const auto speedOf = [&](int x, int y) {
    const bool ring = x < 0 || y < 0 || x >= grid.size.x || y >= grid.size.y;
    if (ring) return 0.0;
    const glm::dvec2 value = inside(x, y);
    return perCell * std::sqrt(value.x * value.x + value.y * value.y);
  };
  for (int y = -1; y <= grid.size.y; ++y)
    for (int x = -1; x <= grid.size.x; ++x)
      cells.emplace_back(0.5 * perCell * (at(x - 1, y).x + at(x, y).x),
                         0.5 * perCell * (at(x, y - 1).y + at(x, y).y), speedOf(x, y), 0);
  return cells;
}

/// Velocities that do not change. This object has no state.
class Flow : public Simulation {
 public:
  Flow(const scene::Object& object, const Setting& /*setting*/) : Flow(object, gridOf(object)) {}

  void connect(Outlets& outlets) override { outlets.provide(&wind_); }
  void step(double /*time*/, const StepWatch& /*watch*/) override {}

  void publish(double /*time*/, Drawables& drawables) const override {
    Field field;
    field.name = &name_;
    field.words = &speeds_.view();
    field.size = size_;
    field.rowWords = size_.x;
    field.range = range_;
    field.colors = &colors_;
    drawables.fields.push_back(field);
    if (sheet_) drawables.surfaces.push_back(sheet_->surface());
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    return sheet_ ? std::optional(sheet_->table()) : std::nullopt;
  }

 private:
  Flow(const scene::Object& object, const FlowGrid& grid)
      : name_(object.name),
        size_(grid.size),
        wind_(object.name, planeOf(object, grid), grid.size, faces(grid)) {
    const auto& parameters = parametersOf<FlowParameters>(object);
    std::vector<float> speeds;
    for (const glm::dvec2& value : grid.values)
      speeds.push_back(static_cast<float>(std::sqrt(value.x * value.x + value.y * value.y)));
    const float fastest = *std::max_element(speeds.begin(), speeds.end());
    range_ = {static_cast<float>(parameters.low),
              parameters.ownHigh ? static_cast<float>(parameters.high) : fastest};
    if (!(range_.y > range_.x)) range_.y = range_.x + 1;
    speeds.resize((speeds.size() + 3) / 4 * 4);
    speeds_ = gl::WordsArray(name_ + " speeds", static_cast<int>(speeds.size() / 4));
    speeds_.buffer().write(0, std::as_bytes(std::span(speeds)));
    colors_ = colorMapStops(parameters.map);
    if (parameters.show == FlowParameters::Show::speed)
      sheet_.emplace(name_, planeOf(object, grid), size_, object.material);
  }

  std::string name_;
  glm::ivec2 size_;
  FluidWind wind_;
  gl::WordsArray speeds_;
  glm::vec2 range_{0, 1};
  std::vector<glm::vec3> colors_;
  std::optional<FieldSheet> sheet_;
};

}  // namespace

SimulationKind flowKind() {
  return kindOf<FlowParameters>(
      "flow",
      "Velocities from a file or from formulas: wind for others, and the source of arrows and streamlines.",
      [](const scene::Object& object, const Setting& /*setting*/) { static_cast<void>(gridOf(object)); },
      makeSimulation<Flow>);
}

}  // namespace simreel::sim

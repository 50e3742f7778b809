#include "reference/water_twin.hpp"

#include <utility>

using namespace simreel;

namespace simreel::shader {
namespace {

#define FUNCTION
#define precise

/// What the kernels see: a state, and what they are told.
struct WaterKernel {
  const std::vector<glm::vec4>& cells;
  ivec2 size;
  WaterStep water;
  WaterLook look;

  [[nodiscard]] vec4 loadWater(int i) const { return cells[static_cast<std::size_t>(i)]; }
  [[nodiscard]] vec4 loadWaterAt(int x, int y) const { return loadWater(y * size.x + x); }
#include "glsl/water/look.glsl"
#include "glsl/water/step.glsl"
};

#undef precise
#undef FUNCTION

}  // namespace
}  // namespace simreel::shader

WaterTwin::WaterTwin(sim::WaterPlan plan, double start)
    : cells(plan.firstCells()), plan_(std::move(plan)), next_(cells) {
  fall(start, 0);
}

void WaterTwin::step(double time) {
  const shader::WaterStep water = plan_.stepAt(time);
  for (int i = 1; i <= plan_.substeps(); ++i) {
    advance(water);
    fall(time, i);
  }
}

void WaterTwin::advance(const shader::WaterStep& water) {
  const glm::ivec2 size = plan_.parameters().size;
  shader::WaterKernel kernel{cells, size, water, plan_.look()};
  std::size_t i = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) next_[i++] = kernel.waterStepped(x, y);
  std::swap(cells, next_);
}

void WaterTwin::fall(double time, int step) {
  const glm::ivec2 size = plan_.parameters().size;
  const sim::WaterFalls falls = plan_.fallsAt(time, step);
  const auto raise = [&](glm::ivec4 box, const auto& rise) {
    for (int y = box.y; y < box.y + box.w; ++y)
      for (int x = box.x; x < box.x + box.z; ++x) {
        glm::vec4& cell = cells[static_cast<std::size_t>(y * size.x + x)];
        cell = shader::waterRaised(cell, rise(glm::ivec2(x, y), cell));
      }
  };
  for (const shader::Stroke& stroke : falls.strokes)
    raise(sim::Strokes::box(stroke, size), [&](glm::ivec2 cell, const glm::vec4& /*texel*/) {
      return plan_.strokes().paints(stroke, cell) ? stroke.value : 0.0F;
    });
  for (const shader::WaterDrop& drop : falls.drops)
    raise(plan_.box(drop),
          [&](glm::ivec2 cell, const glm::vec4& texel) { return shader::waterDropAt(drop, cell, texel); });
}

void WaterTwin::look(std::vector<glm::vec4>& positions, std::vector<glm::vec4>& values) const {
  const glm::ivec2 size = plan_.parameters().size;
  shader::WaterKernel kernel{cells, size, plan_.stepAt(0), plan_.look()};
  positions.clear();
  values.clear();
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      values.push_back(kernel.waterValues(x, y));
      positions.push_back(kernel.waterVertex(x, y, values.back()));
    }
}

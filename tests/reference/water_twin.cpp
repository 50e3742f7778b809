#include "reference/water_twin.hpp"

#include <algorithm>
#include <utility>

using namespace simreel;

namespace simreel::shader {
namespace {

#define SEA 1
#define FUNCTION
#define precise

/// Provides the state and the parameters that the kernels read, and includes the model files.
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

/// Provides the heights that the kernel of the bed reads, and includes the model files.
struct BedKernel {
  const std::vector<glm::vec4>& heights;
  HeightGrid heightGrid;

  [[nodiscard]] vec4 loadHeights(int i) const { return heights[static_cast<std::size_t>(i)]; }
#include "glsl/mesh/height_model.glsl"
#include "glsl/water/bed.glsl"
};

/// Provides the inputs of the kernels of floats, and includes the model files.
struct FloatKernel {
  const std::vector<glm::vec4>& cells;
  const std::vector<glm::vec4>& bodies;
  const std::vector<glm::vec4>& floatInput;
  const std::vector<glm::vec4>& points;
  std::vector<glm::ivec4>& sums;
  ivec2 size;
  FloatStep floats;

  [[nodiscard]] vec4 loadWater(int i) const { return cells[static_cast<std::size_t>(i)]; }
  [[nodiscard]] vec4 loadFloat(int i) const { return bodies[static_cast<std::size_t>(i)]; }
  [[nodiscard]] vec4 loadParameters(int i) const { return floatInput[static_cast<std::size_t>(i)]; }
  [[nodiscard]] vec4 loadFloatPoint(int i) const { return points[static_cast<std::size_t>(i)]; }
  void addToSum(int cell, int which, int value) { sums[static_cast<std::size_t>(cell)][which] += value; }
#include "glsl/water/float_model.glsl"
  // These files need float_model.glsl.
#include "glsl/water/float_contact.glsl"
#include "glsl/water/float_motion.glsl"

  /// Adds the contact with another body to a body's sum of forces, as floats.comp does.
  [[nodiscard]] FloatSum withContact(const FloatSum& sum, int me, int other) {
    const bool isFirst = me < other;
    const FloatBody first = floatBody(std::min(me, other));
    const FloatParameters a = floatParameters(std::min(me, other)),
                          b = floatParameters(std::max(me, other));
    const FloatBody second = floatBeside(first, floatBody(std::max(me, other)));
    if (!floatNear(first, a, second, b)) return sum;
    std::vector<FloatMeet> lanes;
    for (int lane = 0; lane < floatLanes; ++lane) lanes.push_back(floatMeetLane(lane, first, a, second, b));
    for (std::size_t stride = lanes.size() / 2; stride > 0; stride /= 2)
      for (std::size_t lane = 0; lane < stride; ++lane)
        lanes[lane] = floatMet(lanes[lane], lanes[lane + stride]);
    return floatWithPush(sum, lanes[0], floatPushed(lanes[0], first, a, second, b), isFirst, first, second);
  }
};

#undef precise
#undef FUNCTION
#undef SEA

}  // namespace
}  // namespace simreel::shader

WaterTwin::WaterTwin(sim::WaterPlan plan, double start)
    : cells(plan.firstCells()), plan_(std::move(plan)), next_(cells) {
  fall(start, 0);
  if (plan_.floats().empty()) return;
  floats = plan_.floats().first();
  displaced.resize(cells.size());
  drift(start, -1);
}

void WaterTwin::step(double time) {
  for (int i = 1; i <= plan_.substeps(); ++i) {
    advance(plan_.stepAt(time, i - 1));
    fall(time, i);
    if (!floats.empty()) drift(time, i - 1);
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

void WaterTwin::follow(const std::vector<glm::vec4>& heights, const shader::HeightGrid& grid, bool fresh) {
  const glm::ivec2 size = plan_.parameters().size;
  const shader::WaterLook look = plan_.look();
  shader::BedKernel kernel{heights, grid};
  std::size_t i = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x, ++i)
      cells[i] = kernel.waterOnBed(cells[i], {x, y}, {{look.left, look.back}, look.cell, look.base}, fresh);
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

void WaterTwin::drift(double time, int index) {
  const glm::ivec2 size = plan_.parameters().size;
  const std::vector<glm::vec4> floatInput = plan_.floats().parametersAt(time);
  const std::vector<glm::vec4> before = floats;
  shader::FloatKernel kernel{cells,     before, floatInput,           plan_.floats().points(),
                             displaced, size,   plan_.floats().step()};
  for (int body = 0; body < kernel.floats.count; ++body) {
    const shader::FloatKernel::FloatBody now = kernel.floatBody(body);
    const shader::FloatParameters what = kernel.floatParameters(body);
    std::vector<shader::FloatKernel::FloatSum> lanes;
    for (int lane = 0; lane < shader::floatLanes; ++lane)
      lanes.push_back(kernel.floatLane(lane, now, what));
    for (std::size_t stride = lanes.size() / 2; stride > 0; stride /= 2)
      for (std::size_t lane = 0; lane < stride; ++lane)
        lanes[lane] = kernel.floatAdded(lanes[lane], lanes[lane + stride]);
    for (int i = 0; index >= 0 && i < kernel.floats.count; ++i)
      if (i != body) lanes[0] = kernel.withContact(lanes[0], body, i);
    shader::FloatKernel::FloatBody next = index < 0 ? now : kernel.floatMoved(index, now, what, lanes[0]);
    next.under = lanes[0].push.w;
    next.wet = lanes[0].rest.y;
    const auto first = static_cast<std::size_t>(body * shader::floatTexels);
    floats[first] = {next.at, next.level};
    floats[first + 1] = next.turn;
    floats[first + 2] = {next.velocity, next.under};
    floats[first + 3] = {next.spin, 0.0F};
    floats[first + 4] = {next.stages, next.around, next.wet};
  }
  for (int body = 0; body < kernel.floats.count; ++body) {
    const int side = plan_.floats().side();
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const int cell = kernel.floatOwned(body, {x, y});
        if (cell < 0) continue;
        glm::ivec4& sum = displaced[static_cast<std::size_t>(cell)];
        glm::vec4& texel = cells[static_cast<std::size_t>(cell)];
        const bool same = sum.x == sum.w && sum.y == 0 && sum.z == 0;
        const glm::vec4 old = texel;
        if (index >= 0 && !same) texel = kernel.floatPressed(old, sum);
        sum = {0, 0, 0, index < 0 ? sum.x : same ? sum.w : kernel.floatDisplaced(old, sum)};
      }
  }
}

std::vector<glm::vec4> WaterTwin::look() const {
  const glm::ivec2 size = plan_.parameters().size;
  shader::WaterKernel kernel{cells, size, plan_.stepAt(0), plan_.look()};
  std::vector<glm::vec4> shown;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) shown.push_back(kernel.waterShown(x, y));
  return shown;
}

#include "reference/tracers_twin.hpp"

#include "sim/core/shader_code.hpp"

#include <cmath>
#include <utility>

namespace {

using namespace simreel::shader;

#define FUNCTION [[nodiscard]] inline
#define precise
struct TracerModel {
  const TracerStep& tracerData;
  const WindGrid& windGrid;
  const std::vector<std::uint8_t>& solid;
  const WindTwin* wind = nullptr;

  [[nodiscard]] vec4 loadWindCell(int x, int y) const { return wind->cell(x, y); }
  [[nodiscard]] bool tracerInSolid(int x, int y) const {
    return solid.at(static_cast<std::size_t>(y * windGrid.size.x + x)) != 0;
  }
#include "glsl/fluid/wind_model.glsl"
// This file needs wind_model.glsl, which defines the wind.
#include "glsl/fluid/tracers/tracer_model.glsl"
};
#undef precise
#undef FUNCTION

}  // namespace

TracersTwin::TracersTwin(const simreel::sim::TracerParameters& parameters, glm::ivec2 size,
                         std::vector<std::uint8_t> solid, const simreel::shader::TracerStep& step,
                         double frameSeconds)
    : trail(static_cast<std::size_t>(size.x * size.y)),
      size_(size),
      solid_(std::move(solid)),
      step_(step),
      kept_(simreel::sim::trailKept(parameters, frameSeconds)) {
  WindGrid grid{};
  grid.size = size;
  TracerModel model{step_, grid, solid_};
  for (int i = 0; i < parameters.count; ++i) tracers.push_back(model.tracerFirst(i));
}

void TracersTwin::beginFrame() {
  for (std::uint32_t& level : trail)
    level = static_cast<std::uint32_t>(std::floor(static_cast<float>(static_cast<int>(level)) * kept_));
}

void TracersTwin::advance(const WindTwin& wind) {
  TracerModel model{step_, wind.grid, solid_, &wind};
  for (std::size_t i = 0; i < tracers.size(); ++i) {
    const auto move = model.tracerMoved(static_cast<int>(i), tracers[i]);
    tracers[i] = move.next;
    if (!move.draws) continue;
    const float length = model.tracerLength(move.from, move.to);
    const int points = model.tracerPoints(length);
    for (int k = 0; k < points; ++k)
      for (int corner = 0; corner < 4; ++corner) {
        const ivec3 mark = model.tracerMark(move.from, move.to, length, points, k, corner);
        if (mark.x >= 0 && mark.y >= 0 && mark.x < size_.x && mark.y < size_.y && mark.z > 0)
          trail[static_cast<std::size_t>(mark.y * size_.x + mark.x)] += static_cast<std::uint32_t>(mark.z);
      }
  }
}

#include "sim/mesh/height_field.hpp"

#include <cstddef>
#include <vector>

namespace simreel::sim {

struct HeightsKernel {
  static constexpr auto file = "mesh/heights.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"lift", float> lift;
  gl::Uniform<"component", int> component;
  gl::In<"positions"> positions;
  gl::InOut<"heights"> heights;
};

namespace {

std::size_t countOf(glm::ivec2 size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

}  // namespace

constinit const PortInfo HeightField::port = {
    .name = "surface of heights",
    .lacks = ", which is no surface of heights",
    .none = "the scene has no surface of heights",
    .single =
        "only one object of a scene can be the surface that others fall onto, and \"{}\" is it already",
};

HeightField::HeightField(const std::string& name, const HeightPlan& plan)
    : plan_(plan),
      heights_(name + " heights", std::vector<glm::vec4>(countOf(plan.size()), glm::vec4(0))),
      keep_(gl::kernelDefines(false)) {}

void HeightField::setHeights(const gl::Vec4Array& positions, int component) {
  const auto count = static_cast<int>(countOf(plan_.size()));
  keep_.dispatch(count, {.count = count,
                         .lift = plan_.lift(),
                         .component = component,
                         .positions = positions,
                         .heights = heights_});
}

HeightPart HeightField::part(int substep, int substeps, float margin, float bounce) const {
  const shader::HeightGrid grid = plan_.at(substep, substeps, margin, bounce);
  return {.corner = grid.corner,
          .perCell = grid.perCell,
          .size = grid.size,
          .progress = grid.progress,
          .perFrame = grid.perFrame,
          .kept = grid.kept,
          .bounce = grid.bounce,
          .margin = grid.margin,
          .heights = heights_};
}

}  // namespace simreel::sim

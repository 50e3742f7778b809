#include "sim/contour/walls.hpp"

#include "base/error.hpp"
#include "gl/context.hpp"
#include "sim/contour/wall_plan.hpp"

#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

constinit const PortInfo Walls::port = {
    .name = "walls",
    .lacks = ", which has no walls",
    .none = "the scene has no cave and no contour",
};

Walls::Walls(std::string name, const Solid& solid, const glm::vec3& position, float grip)
    : name_(std::move(name)), solid_(&solid), position_(position), grip_(grip) {}

void Walls::checkReach(const std::string& who, float margin) const {
  const float widest = static_cast<float>(maxWallSquares) * solid_->shape().spacing;
  if (margin > widest)
    fail(
        ExitCode::usage,
        "\"{}\" has a \"margin\" of {} m, but the squares of \"{}\" are {:.4g} m wide and a margin reaches "
        "over {} of them at most; make it {:.4g} m or less",
        who, margin, name_, solid_->shape().spacing, maxWallSquares, widest);
}

void Walls::bind() const {
  solid_->classes().bindInput(shader::wallClassesBinding);
  solid_->field().words->bind(shader::wallFieldUnit);
}

void Walls::tell(const gl::Program& kernel, double seconds, float margin, float bounce) const {
  const shader::WallGrid grid =
      wallGrid(solid_->shape(), solid_->heights(), position_, grip_, {margin, bounce, seconds});
  kernel.set("wallGrid.corner", grid.corner);
  kernel.set("wallGrid.spacing", grid.spacing);
  kernel.set("wallGrid.perSpacing", grid.perSpacing);
  kernel.set("wallGrid.bottom", grid.bottom);
  kernel.set("wallGrid.roof", grid.roof);
  kernel.set("wallGrid.reach", grid.reach);
  kernel.set("wallGrid.kept", grid.kept);
  kernel.set("wallGrid.bounce", grid.bounce);
  kernel.set("wallGrid.levelCount", grid.levelCount);
  kernel.set("wallGrid.ceiling", grid.ceiling);
  kernel.set("wallGrid.squares", grid.squares);
  kernel.set("wallGrid.samples", grid.samples);
  for (int k = 0; k <= grid.levelCount; ++k)
    kernel.set(fmt::format("wallGrid.heights[{}]", k).c_str(), grid.heights[k]);
  for (int k = 0; k < grid.levelCount; ++k)
    kernel.set(fmt::format("wallGrid.levels[{}]", k).c_str(), grid.levels[k]);
  const Field& field = solid_->field();
  kernel.set("fieldSize", field.size);
  kernel.set("rowWords", field.rowWords);
  kernel.set("firstWord", field.firstWord);
  kernel.set("cellWords", field.cellWords);
  kernel.set("rowElements", solid_->rowElements());
}

void addWallDefines(gl::Defines& defines, const Walls* walls) {
  defines.emplace_back("WALLS", walls != nullptr ? "1" : "0");
  if (walls == nullptr) return;
  const Field::Cells cells = walls->solid().field().cells;
  if (!gl::softwareDriver()) defines.emplace_back("BRANCHES", "1");
  defines.emplace_back("CELLS", std::to_string(static_cast<int>(cells)));
}

}  // namespace simreel::sim

#include "sim/contour/walls.hpp"

#include "base/error.hpp"
#include "gl/context.hpp"

#include <span>
#include <utility>

namespace simreel::sim {

constinit const PortInfo Walls::port = {
    .name = "walls",
    .lacks = ", which has no walls",
    .none = "the scene has no cave and no contour",
};

Walls::Walls(std::string name, const Solid& solid, const glm::vec3& position, float grip)
    : name_(std::move(name)), solid_(&solid), position_(position), grip_(grip) {}

void Walls::checkReach(const std::string& objectName, float margin) const {
  const float widest = static_cast<float>(maxWallSquares) * solid_->shape().spacing;
  if (margin > widest)
    fail(
        ExitCode::usage,
        "\"{}\" has a \"margin\" of {} m, but the squares of \"{}\" are {:.4g} m wide and a margin reaches "
        "over {} of them at most; make it {:.4g} m or less",
        objectName, margin, name_, solid_->shape().spacing, maxWallSquares, widest);
}

WallPart Walls::part(const WallContact& contact) const {
  const shader::WallGrid grid = wallGrid(solid_->shape(), solid_->heights(), position_, grip_, contact);
  return {.corner = grid.corner,
          .spacing = grid.spacing,
          .perSpacing = grid.perSpacing,
          .bottom = grid.bottom,
          .roof = grid.roof,
          .reach = grid.reach,
          .kept = grid.kept,
          .bounce = grid.bounce,
          .levelCount = grid.levelCount,
          .ceiling = grid.ceiling,
          .squares = grid.squares,
          .samples = grid.samples,
          .heights = std::span<const float>(grid.heights),
          .levels = std::span<const float>(grid.levels),
          .rowElements = solid_->rowElements(),
          .classes = solid_->classes(),
          .field = partOf(solid_->field())};
}

WallVariant Walls::variant() const {
  return {.walls = true, .branches = !gl::softwareDriver(), .cells = solid_->field().cells};
}

}  // namespace simreel::sim

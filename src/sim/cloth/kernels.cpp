#include "sim/cloth/kernels.hpp"

#include <algorithm>

namespace simreel::shader::cloth {
#include "glsl/cloth/relax_tile.glsl"
#include "glsl/cloth/segment_links.glsl"
}  // namespace simreel::shader::cloth

namespace simreel::sim {

struct ClothForces {
  gl::Switch<"AIR"> air;
  gl::Switch<"FABRIC"> fabric;
};

struct ClothStepKernel {
  static constexpr auto file = "cloth/step.comp";
  struct Variant {
    TouchVariant touch;
    gl::Switch<"KEEPS"> keeps;
    ClothForces forces;
    gl::Switch<"SPRINGS"> springs;
    gl::Switch<"CONTACT"> contact;
  };
  ClothPart cloth;
  gl::In<"positions"> positions;
  gl::Out<"nextPositions"> next;
  gl::InOut<"velocities"> velocities;
};

struct ClothSettleKernel {
  static constexpr auto file = "cloth/settle.comp";
  struct Variant {
    TouchVariant touch;
    gl::Switch<"KEEPS"> keeps;
  };
  ClothPart cloth;
  gl::In<"positions"> positions;
  gl::InOut<"nextPositions"> next;
  gl::InOut<"velocities"> velocities;
  gl::In<"left"> left;
};

/// Part of a kernel interface: arrays of the kernels that integrate particles and relax pairs.
struct ClothRelaxedArrays {
  gl::In<"positions"> positions;
  gl::InOut<"nextPositions"> next;
  gl::In<"velocities"> velocities;
  gl::In<"trends"> trends;
  gl::Out<"aims"> aims;
};

struct ClothRelaxKernel {
  static constexpr auto file = "cloth/relax.comp";
  struct Variant {
    ClothForces forces;
    gl::Flag<"WIND"> wind;
    gl::Switch<"DAMPED"> damped;
    gl::Flag<"BENDS"> bends;
  };
  ClothPart cloth;
  ClothRelaxedArrays arrays;
};

struct ClothLinesKernel {
  static constexpr auto file = "cloth/constrain_lines.comp";
  struct Variant {
    ClothForces forces;
    gl::Flag<"WIND"> wind;
    gl::Switch<"DAMPED"> damped;
    gl::Flag<"FIRST"> first;
  };
  ClothPart cloth;
  ClothRelaxedArrays arrays;
  gl::Uniform<"reach", glm::ivec2> reach;
  gl::Uniform<"kind", int> kind;
  gl::Uniform<"lines", int> lines;
};

/// Kernel that solves all links of a row or column together.
struct ClothSolveKernel {
  static constexpr auto file = "cloth/solve_lines.comp";
  static constexpr int groupSize = 1024;  // Every device supports this workgroup size.
  static constexpr int vector = 8;        // SIMD width of a software OpenGL driver
  struct Variant {
    TouchVariant touch;
    gl::Switch<"KEEPS"> keeps;
    gl::Switch<"DAMPED"> damped;
    gl::Switch<"FABRIC"> fabric;
    gl::Flag<"ROWS"> rows;
    gl::Flag<"LAST"> last;
    gl::Range<"LINES", 1, vector> lines;  // rows or columns of the cloth per workgroup
    gl::Range<"SEGMENTS", 1, groupSize> segments;
  };
  ClothPart cloth;
  gl::Uniform<"lines", int> lines;
  gl::In<"positions"> positions;
  gl::InOut<"nextPositions"> next;
  gl::InOut<"velocities"> velocities;
  gl::InOut<"trends"> trends;
};

struct ClothThinKernel {
  static constexpr auto file = "cloth/thin.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::InOut<"StatusBlock"> status;
  ThinPart thin;
};

namespace {

int segmentsOf(int particles) {
  return (particles - 1 + shader::cloth::segmentLinks - 1) / shader::cloth::segmentLinks;
}

}  // namespace

ClothKernels::ClothKernels(const std::string& name, const ClothPlan& plan, const TouchVariant& touch,
                           bool fast)
    : plan_(&plan),
      size_(plan.parameters().size),
      constrained_(plan.parameters().constrained()),
      keeps_(plan.parameters().keepsEnergy()),
      hold_(name, plan.skinPins(), gl::kernelDefines(fast)),
      thin_(name, plan.thinCount(), size_.x * size_.y, fast) {
  const int count = size_.x * size_.y;
  const auto positions = plan.firstPositions();
  positions_[0] = gl::Vec4Array(name + " positions", positions);
  positions_[1] = gl::Vec4Array(name + " next positions", positions);
  velocities_[0] = gl::Vec4Array(name + " velocities", plan.firstVelocities());
  if (hasTrends()) {
    velocities_[1] = gl::Vec4Array(name + " next velocities", count);
    trends_ = gl::Vec4Array(name + " trends", count);
    if (bends() && !inLines_) between_ = gl::Vec4Array(name + " between", count);
  }
  if (plan.parameters().contact) left_ = gl::Vec4Array(name + " left", count);
  makeKernels(touch, fast);
}

void ClothKernels::predict(int substep, const ClothPart& part) {
  hold_.hold(velocities_[0], substep, plan_->substeps());
  if (constrained_)
    constrain(part);
  else
    dispatchStep(part);
  predicted_ = true;
  pushThin(part);
  if (!plan_->parameters().contact) return;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  left_.copyFrom(positions_[1]);
}

void ClothKernels::settle(const ClothPart& part) const {
  settle_.dispatch(size_.x * size_.y, {.cloth = part,
                                       .positions = positions_[0],
                                       .next = positions_[1],
                                       .velocities = velocities(),
                                       .left = left_});
  pushThin(part);
}

void ClothKernels::finish() {
  std::swap(positions_[0], positions_[1]);
  if (hasTrends()) std::swap(velocities_[0], velocities_[1]);
  predicted_ = false;
}

void ClothKernels::makeKernels(const TouchVariant& touch, bool fast) {
  const ClothParameters& p = plan_->parameters();
  const gl::Defines defines = gl::kernelDefines(fast);
  const ClothForces forces = {.air = p.air.has_value(), .fabric = p.fabric.has_value()};
  if (constrained_) {
    rows_ = lineSolver(defines, touch, true);
    columns_ = lineSolver(defines, touch, false);
  }
  if (thin_.any()) findThin_ = gl::Kernel<ClothThinKernel>(defines);
  if (p.contact) settle_ = gl::Kernel<ClothSettleKernel>(defines, {.touch = touch, .keeps = keeps_});
  if (!hasTrends()) {
    step_ = gl::Kernel<ClothStepKernel>(
        defines,
        {.touch = touch, .keeps = keeps_, .forces = forces, .springs = !keeps_, .contact = !keeps_});
    return;
  }
  // The kernels that integrate particles and relax pairs do not handle collisions. Therefore, they use only
  // the wind switch of the variant.
  const gl::Flag<"WIND"> wind = touch.wind;
  for (std::size_t later = 0; later < (inLines_ || bends() ? 2 : 1); ++later)
    if (inLines_)
      lines_[later] = gl::Kernel<ClothLinesKernel>(
          defines, {.forces = forces, .wind = wind, .damped = p.damped(), .first = later == 0});
    else
      relax_[later] = gl::Kernel<ClothRelaxKernel>(
          defines, {.forces = forces, .wind = wind, .damped = p.damped(), .bends = later == 1});
}

// Returns the kernel that solves rows or columns. A workgroup solves as many lines as fit into it, but on
// all drivers no more than 8, the SIMD width of a software driver.
gl::Kernel<ClothSolveKernel> ClothKernels::lineSolver(const gl::Defines& defines, const TouchVariant& touch,
                                                      bool rows) const {
  const int segments = segmentsOf(rows ? size_.x : size_.y);
  return gl::Kernel<ClothSolveKernel>(
      defines, {.touch = touch,
                .keeps = keeps_,
                .damped = plan_->parameters().damped(),
                .fabric = plan_->parameters().fabric.has_value(),
                .rows = rows,
                .last = !rows,
                .lines = std::clamp(ClothSolveKernel::groupSize / segments, 1, ClothSolveKernel::vector),
                .segments = segments});
}

void ClothKernels::pushThin(const ClothPart& part) const {
  thin_.resolveThin(part.step, positions_[0], positions_[1], velocities(), [&](const ThinPart& thin) {
    findThin_.dispatch(size_, {.size = size_, .status = part.status, .thin = thin});
  });
}

void ClothKernels::dispatchStep(const ClothPart& part) const {
  step_.dispatch(
      size_,
      {.cloth = part, .positions = positions_[0], .next = positions_[1], .velocities = velocities_[0]});
}

// Integrates the particles and applies their constraints.
void ClothKernels::constrain(const ClothPart& part) const {
  if (keeps_)
    dispatchStep(part);
  else if (inLines_)
    relaxInLines(part);
  else
    relaxInTiles(part);
  solve(rows_, part, {size_.y, segmentsOf(size_.x)});
  solve(columns_, part, {size_.x, segmentsOf(size_.y)});
}

void ClothKernels::solve(const gl::Kernel<ClothSolveKernel>& kernel, const ClothPart& part,
                         glm::ivec2 items) const {
  kernel.dispatch(items, {.cloth = part,
                          .lines = items.x,
                          .positions = positions_[0],
                          .next = positions_[1],
                          .velocities = velocities_[hasTrends() ? 1 : 0],
                          .trends = trends_});
}

ClothRelaxedArrays ClothKernels::relaxed(const gl::Vec4Array& from, const gl::Vec4Array& to) const {
  return {.positions = from,
          .next = to,
          .velocities = velocities_[0],
          .trends = trends_,
          .aims = velocities_[1]};
}

void ClothKernels::relaxInLines(const ClothPart& part) const {
  const auto families = relaxedFamilies(plan_->parameters());
  for (const SpringFamily& family : families) {
    const int lines = lineCount(family.reach);
    lines_[&family == families.data() ? 0 : 1].dispatch(lines,
                                                        {.cloth = part,
                                                         .arrays = relaxed(positions_[0], positions_[1]),
                                                         .reach = family.reach,
                                                         .kind = family.kind,
                                                         .lines = lines});
  }
}

void ClothKernels::relaxInTiles(const ClothPart& part) const {
  using namespace shader::cloth;
  dispatchTiles(relax_[0], relaxDiagonalHalo,
                {part, relaxed(positions_[0], bends() ? between_ : positions_[1])});
  if (bends()) dispatchTiles(relax_[1], relaxBendHalo, {part, relaxed(between_, positions_[1])});
}

// Dispatches tiles that cover the sheet. A tile stores all its particles except a border of `halo`
// particles, because these depend on pairs outside the tile.
void ClothKernels::dispatchTiles(const gl::Kernel<ClothRelaxKernel>& kernel, int halo,
                                 const ClothRelaxKernel& given) const {
  using namespace shader::cloth;
  const glm::ivec2 tile(relaxTileX, relaxTileY);
  const glm::ivec2 tiles = (size_ + relaxBefore - halo - 1) / (tile - 2 * halo) + 1;
  kernel.dispatch({tiles.x * (tile.x / 2), tiles.y * tile.y}, given);
}

// Returns the number of chains of particles that a spring family forms. A chain starts at each particle
// that has no neighbour at the offset -reach.
int ClothKernels::lineCount(glm::ivec2 reach) const {
  if (reach.y == 0) return std::min(reach.x, size_.x) * size_.y;
  if (reach.x == 0) return std::min(reach.y, size_.y) * size_.x;
  return size_.x + size_.y - 1;
}

}  // namespace simreel::sim

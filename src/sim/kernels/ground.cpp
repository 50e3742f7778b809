#include "sim/kernels/ground.hpp"

#include "sim/grid/sheet_mesh.hpp"
#include "sim/mesh/parameters.hpp"

#include <algorithm>

namespace simreel::sim {

struct GroundKernel {
  static constexpr auto file = "kernels/run/ground.comp";
  gl::Uniform<"given", glm::ivec2> given;
  gl::Uniform<"finer", int> finer;
  gl::Uniform<"corner", glm::vec3> corner;
  gl::Uniform<"cell", float> cell;
  gl::Uniform<"scale", float> scale;
  gl::In<"heights"> heights;
  gl::Out<"vertices"> vertices;
};

namespace {

/// Returns the terrain as a plane for HeightPlan. The vertices are given in world space, so the plane is at
/// height 0.
MeshParameters planeOf(const KernelTerrain& given, glm::ivec2 size, float cell) {
  MeshParameters plane;
  const glm::vec2 cells(size - 1);
  plane.size = {cells.x * cell, 0, cells.y * cell};
  plane.resolution = size;
  plane.position = glm::vec3(given.position.x, 0, given.position.z);
  plane.grip = given.grip;
  return plane;
}

}  // namespace

KernelGround::KernelGround(const std::string& name, const KernelPlan& plan, const KernelWatch& watch,
                           double frameSeconds)
    : given_(*plan.drawn().terrain),
      heightsSize_(plan.sizeOf(given_.of)),
      finer_(given_.steps(heightsSize_)),
      size_((heightsSize_ - 1) * finer_ + 1),
      cell_(given_.cell(size_.x)),
      watch_(watch),
      kernel_(gl::kernelDefines(false)),
      heights_(name + " given heights", heightsSize_.x * heightsSize_.y),
      vertices_(name + " ground", size_.x * size_.y) {
  const std::vector<unsigned> indices = gridIndices(size_);
  indices_ = gl::Buffer::of(name + " ground indices", std::span<const unsigned>(indices));
  indexCount_ = static_cast<int>(indices.size());
  if (given_.collides) field_.emplace(name, HeightPlan(planeOf(given_, size_, cell_), frameSeconds));
}

KernelGround::~KernelGround() = default;

int KernelTerrain::steps(glm::ivec2 heights) const {
  if (finer > 0) return finer;
  constexpr int wanted = 256, maximum = 16;
  int steps = 1;
  while (steps < maximum && steps * (std::max(heights.x, heights.y) - 1) < wanted - 8) steps *= 2;
  return steps;
}

void KernelGround::update(const KernelStore& store) {
  gather_.run(numbersOf(store, given_.of, given_.height, 1),
              {.member = KernelNumbers::chosen, .watch = watch_}, heights_);
  gl::barrier();
  const glm::vec2 half = 0.5F * cell_ * glm::vec2(size_ - 1);
  kernel_.dispatch(size_.x * size_.y, {.given = heightsSize_,
                                       .finer = finer_,
                                       .corner = given_.position - glm::vec3(half.x, 0, half.y),
                                       .cell = cell_,
                                       .scale = given_.scale,
                                       .heights = heights_,
                                       .vertices = vertices_});
  gl::barrier();
}

void KernelGround::endFrame() {
  if (field_) field_->setHeights(vertices_);
}

void KernelGround::visitCheckpointData(CarryOver& carry) {
  if (field_) field_->visitCheckpointData(carry);
}

Surface KernelGround::surface() const {
  Surface surface;
  surface.positions = &vertices_.view();
  surface.grid = size_;
  surface.vertexCount = size_.x * size_.y;
  surface.indices = &indices_;
  surface.indexCount = indexCount_;
  surface.doubleSided = true;
  return surface;
}

}  // namespace simreel::sim

#pragma once
#include "sim/core/carry_over.hpp"
#include "sim/kernels/gather.hpp"
#include "sim/mesh/height_field.hpp"

#include <optional>
#include <string>

namespace simreel::sim {

struct GroundKernel;

/// Ground whose heights come from a texture or buffer of a user's kernels. Draws the ground, and lets other
/// objects fall onto it.
class KernelGround {
 public:
  KernelGround(const std::string& name, const KernelPlan& plan, const KernelWatch& watch,
               double frameSeconds);
  ~KernelGround();
  KernelGround(const KernelGround&) = delete;
  KernelGround& operator=(const KernelGround&) = delete;

  /// Copies the heights from memory. Call it after KernelStore::settle().
  void update(const KernelStore& store);
  /// Stores the current heights as the heights at the end of the frame, for colliding objects.
  void endFrame();
  void visitCheckpointData(CarryOver& carry);
  /// Returns the outlet of a terrain that collides; null if it does not collide.
  [[nodiscard]] HeightField* outlet() { return field_ ? &*field_ : nullptr; }
  /// Returns a surface whose material is not set.
  [[nodiscard]] Surface surface() const;
  /// Returns the number of vertices along x and z.
  [[nodiscard]] glm::ivec2 size() const { return size_; }
  [[nodiscard]] const gl::Vec4Array& vertices() const { return vertices_; }

 private:
  const KernelTerrain& given_;
  glm::ivec2 heightsSize_;
  int finer_;
  glm::ivec2 size_;  ///< number of vertices along x and z
  float cell_;
  KernelGather gather_;
  KernelWatch watch_;
  gl::Kernel<GroundKernel> kernel_;
  gl::Vec4Array heights_, vertices_;
  gl::Buffer indices_;
  int indexCount_ = 0;
  std::optional<HeightField> field_;
};

}  // namespace simreel::sim

#pragma once
#include "sim/kernels/gather.hpp"
#include "sim/volume/isosurface.hpp"

#include <string>

namespace simreel::sim {

struct PackKernel;

/// Isosurface of a volume computed by a user's kernels.
class KernelLevel {
 public:
  KernelLevel(const std::string& name, const KernelPlan& plan, const KernelWatch& watch);
  ~KernelLevel();
  KernelLevel(const KernelLevel&) = delete;
  KernelLevel& operator=(const KernelLevel&) = delete;

  /// Copies the values from memory and computes the surface at `time` (seconds). Call it after
  /// KernelStore::settle().
  void update(const KernelStore& store, double time);
  bool grow() { return surface_.grow(); }
  /// Returns a surface whose material is not set.
  [[nodiscard]] Surface surface() const { return surface_.surface(); }
  [[nodiscard]] MeshTable mesh() const { return surface_.mesh(); }

 private:
  const KernelVolume& given_;
  glm::ivec3 size_;
  int columns_;
  KernelGather gather_;
  KernelWatch watch_;
  gl::Kernel<PackKernel> pack_;
  gl::Vec4Array cells_;
  gl::WordsArray packed_;
  Isosurface surface_;
};

}  // namespace simreel::sim

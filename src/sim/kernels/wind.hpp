#pragma once
#include "sim/fluid/wind.hpp"
#include "sim/kernels/gather.hpp"

#include <memory>
#include <string>

namespace simreel::sim {

struct KernelWindKernel;

/// Wind for other objects, from a grid of velocities computed by a user's kernels.
class KernelWindSource {
 public:
  KernelWindSource(const std::string& name, const KernelPlan& plan, const KernelWatch& watch);
  ~KernelWindSource();
  KernelWindSource(const KernelWindSource&) = delete;
  KernelWindSource& operator=(const KernelWindSource&) = delete;

  /// Copies the velocities from memory. Call it after KernelStore::settle().
  void update(const KernelStore& store);
  [[nodiscard]] FluidWind* outlet() { return &wind_; }

 private:
  const KernelWind& given_;
  glm::ivec2 size_;
  KernelGather gather_;
  KernelWatch watch_;
  gl::Kernel<KernelWindKernel> kernel_;
  gl::Vec4Array cells_;
  gl::Buffer flow_;
  FluidArray flowViews_;
  FluidWind wind_;
};

}  // namespace simreel::sim

#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"

#include <glm/vec2.hpp>

namespace simreel::sim {

struct PairKernel;

/// Computes all-pairs gravity with Plummer softening, a_i = G sum_j m_j d_ij / (|d_ij|^2 + eps^2)^(3/2),
/// where d_ij is the vector from body i to body j and eps the softening length. The order of summation is
/// fixed, so both memory paths and every division of the work give identical bits.
class PairGravity {
 public:
  PairGravity() = default;
  explicit PairGravity(bool fast);

  /// Fills `accelerations` (xyz in m/s^2, w = 0) from `positions` (xyz in m, w the mass in kg). Bodies with
  /// zero mass attract nothing. `gravity` is G in m^3/(kg s^2); `softening` is eps in m, at least 1e-6.
  void accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                  float gravity, float softening) const;
  /// Computes only the accelerations of the bodies from targets.x to targets.y - 1.
  void accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                  float gravity, float softening, glm::ivec2 targets) const;
  /// Sets the number of bodies per dispatch, rounded up to whole chunks; it is limited because software
  /// drivers silently end loops after 65,535 iterations. The default depends on the driver. Used by tests.
  void splitAfter(int bodies);
  /// Sets the number of target bodies from which on an invocation on the storage path processes four of
  /// them. Used by tests.
  void useManyFrom(int targets);

 private:
  gl::Kernel<PairKernel> pairs_, manyPairs_;
  /// With this many target bodies, there is a workgroup for every multiprocessor of a large GPU even if an
  /// invocation processes four bodies.
  int manyFrom_ = 131072;
  int bodiesPerDispatch_ = 0;
};

}  // namespace simreel::sim

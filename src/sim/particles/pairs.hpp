#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"

#include <glm/vec2.hpp>

namespace simreel::sim {

struct PairKernel;

/// Computes all-pairs gravity with Plummer softening, a_i = G sum_j m_j d_ij / (|d_ij|^2 + eps^2)^(3/2).
/// The order of summation is fixed, so both memory paths and every way of splitting the work give identical
/// bits.
class PairGravity {
 public:
  PairGravity() = default;
  explicit PairGravity(bool fast);

  /// Fills `accelerations` (xyz m/s^2, w 0) from `positions` (xyz m, w kg). Bodies with zero mass attract
  /// nothing. `gravity` is in m^3/(kg s^2); `softening` is in m, at least 1e-6.
  void accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                  float gravity, float softening) const;
  /// Computes the accelerations of the bodies targets.x to targets.y - 1 only.
  void accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                  float gravity, float softening, glm::ivec2 targets) const;
  /// Sets the number of bodies per dispatch, rounded up to whole chunks. Software drivers silently end
  /// loops after 65,535 iterations. For tests; the default depends on the driver.
  void splitAfter(int bodies);
  /// Sets the number of targets from which an invocation on the storage path handles four of them. For
  /// tests.
  void useManyFrom(int targets);

 private:
  gl::Kernel<PairKernel> pairs_, manyPairs_;
  /// With this many targets, four per invocation still give every multiprocessor of a large GPU a
  /// workgroup.
  int manyFrom_ = 131072;
  int bodiesPerDispatch_ = 0;
};

}  // namespace simreel::sim

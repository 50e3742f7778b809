#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"

#include <glm/vec2.hpp>

namespace simreel::sim {

struct PairKernel;

/// All-pairs gravity with Plummer softening, a_i = G sum_j m_j d_ij / (|d_ij|^2 + eps^2)^(3/2), in a fixed
/// order of summation: the same bits on both memory paths and however the work is split.
class PairGravity {
 public:
  PairGravity() = default;
  explicit PairGravity(bool fast);

  /// Fills `accelerations` (xyz m/s^2, w 0) from `positions` (xyz m, w kg; bodies without mass do not
  /// attract). `gravity` m^3/(kg s^2), `softening` m, at least 1e-6.
  void accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                  float gravity, float softening) const;
  /// The same for targets first to last - 1 only.
  void accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                  float gravity, float softening, glm::ivec2 targets) const;
  /// Bodies a dispatch goes through, rounded up to whole chunks: software drivers end loops silently after
  /// 65,535 iterations. For tests; the driver's kind decides otherwise.
  void splitAfter(int bodies);
  /// Targets from which on an invocation of the storage path takes four. For tests.
  void useManyFrom(int targets);

 private:
  gl::Kernel<PairKernel> pairs_, manyPairs_;
  /// Four an invocation still give every multiprocessor of a large GPU a group then.
  int manyFrom_ = 131072;
  int bodiesPerDispatch_ = 0;
};

}  // namespace simreel::sim

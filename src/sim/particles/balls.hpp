#pragma once
#include "gl/sort/radix_sort.hpp"
#include "sim/particles/kernels.hpp"
#include "sim/particles/plan.hpp"

#include <string>

namespace simreel::sim {

struct BallKey;
struct BallGather;
struct BallNear;
struct BallSolve;
struct BallLeave;

/// Contact of particles with each other on the GPU (glsl/particles/contact): 180 bytes per particle, more
/// if their radii differ. Sums have a fixed order, so the result has the same bits on every device.
class BallContact {
 public:
  /// Throws UserError(device), naming the device's limit.
  BallContact(const std::string& name, const ParticlePlan& plan, const ParticleSolids& solids, bool fast);

  /// Resolves the contacts of a substep. `starts` holds the positions at the start of the substep.
  /// `positions` and `velocities` hold the prediction for its end, which this function corrects. `part`
  /// holds the other inputs of particle kernels.
  void solve(const ParticlePart& part, const gl::Vec4Array& starts, const gl::Vec4Array& positions,
             const gl::Vec4Array& velocities);

 private:
  int count_, keyBits_, stamp_ = 0;
  gl::RadixSort sort_;
  gl::WordsArray table_, lists_;
  gl::Vec4Array guesses_, begins_, speeds_, places_[2];
  gl::Kernel<BallKey> key_;
  gl::Kernel<BallGather> gather_;
  gl::Kernel<BallNear> near_;
  gl::Kernel<BallSolve> solve_;
  gl::Kernel<BallLeave> leave_;
};

}  // namespace simreel::sim

#pragma once
#include "gl/sort/radix_sort.hpp"
#include "sim/particles/kernels.hpp"
#include "sim/particles/plan.hpp"

#include <string>

namespace simreel::sim {

struct BallKey;
struct BallGather;
struct BallNear;
struct BallChoose;
struct BallStrike;
struct BallSolve;
struct BallLeave;

/// Contact of particles with each other on the GPU (glsl/particles/contact): 240 bytes per particle, 32
/// more for balls that turn, and more if their radii differ. Sums have a fixed order, so the result has the
/// same bits on every device.
class BallContact {
 public:
  /// Throws UserError(device), naming the device's limit.
  BallContact(const std::string& name, const ParticlePlan& plan, const ParticleSolids& solids, bool fast);

  /// Resolves the contacts of a substep. `starts` holds the positions at the start of the substep.
  /// `positions` and `velocities` hold the prediction for its end, which this function corrects. `part`
  /// holds the other inputs of particle kernels, with the angular velocities of balls that turn. `turns`
  /// holds their orientations.
  void solve(const ParticlePart& part, const gl::Vec4Array& starts, const gl::Vec4Array& positions,
             const gl::Vec4Array& velocities, const gl::Vec4Array& turns);

 private:
  /// Sorts the balls and lists neighbours.
  void search(const ParticlePart& part, const gl::Vec4Array& starts, const gl::Vec4Array& positions,
              const gl::Vec4Array& velocities);
  /// Lets balls collide; their paths are in `struck_` and `speeds_[0]`.
  void strike(const ParticlePart& part);

  float substepSeconds_;
  bool rolls_;  ///< true if the balls turn
  int count_, impacts_, keyBits_, stamp_ = 0;
  gl::RadixSort sort_;
  gl::WordsArray table_, lists_, choices_;
  gl::Vec4Array turning_[2];  ///< of balls that turn: angular velocities or angles times the radii
  gl::Vec4Array guesses_, begins_, speeds_[2], places_[2], struck_;
  gl::Kernel<BallKey> key_;
  gl::Kernel<BallGather> gather_;
  gl::Kernel<BallNear> near_;
  gl::Kernel<BallChoose> choose_;
  gl::Kernel<BallStrike> strike_;
  gl::Kernel<BallSolve> solve_;
  gl::Kernel<BallLeave> leave_;
};

}  // namespace simreel::sim

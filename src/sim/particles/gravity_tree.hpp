#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/radix_sort.hpp"
#include "sim/core/shader_code.hpp"

#include <string>

namespace simreel::shader {
#include "glsl/particles/tree/types.glsl"
}  // namespace simreel::shader

namespace simreel::sim {

struct TreeReduce;
struct TreeKey;
struct TreeGather;
struct TreeBuild;
struct TreeWalk;
struct TreeWalkList;

/// Gravity of many bodies in O(N log N) on the device, without readback. Bodies are sorted along a Hilbert
/// curve and cut into leaves of 8 under binary trees without pointers (glsl/particles/tree/types.glsl); a
/// node far from a group of 64 neighbours pulls by its mass and second moments. The same bits on every run,
/// in exact mode on every device and in the CPU twin.
///
/// Bodies with coordinates beyond 1e18 m (or not numbers) or a mass outside 1e-30..1e30 kg take no part:
/// they pull nothing and their acceleration is zero. The masses' sum has to stay below 1e30 kg.
class GravityTree {
 public:
  /// For up to `capacity` bodies; about 75 bytes each. `fast` allows built-in arithmetic. Throws
  /// UserError(device) naming the device's limit.
  GravityTree(const std::string& name, int capacity, bool fast);

  /// Writes a_i = G sum_j m_j d_ij / (|d_ij|^2 + eps^2)^(3/2), d_ij from i to j, of bodies 0..count-1.
  /// positions: xyz m, w mass (kg). accelerations: xyz m/s^2, w 0. gravity: G, m^3/(kg s^2). softening:
  /// eps, m (below 1e-10 m taken as that). opening: side over distance of nodes taken as a whole, up
  /// to 1.15; 0 opens all.
  void accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                  float gravity, float softening, float opening);

  /// The three phases of accelerate(), in order, for who measures them.
  void sort(const gl::Vec4Array& positions, int count);
  void build(const gl::Vec4Array& positions, int count, float opening);
  void walk(const gl::Vec4Array& accelerations, int count, float gravity, float softening);

  /// Where the tests look: two texels a node (mass and spread), one a node (centre of mass, opening
  /// radius^2); node 1 of each 8192 is a tree's root.
  [[nodiscard]] const gl::Vec4Array& moments() const { return moments_; }
  [[nodiscard]] const gl::Vec4Array& cells() const { return cells_; }

 private:
  void checkLimits() const;
  void findBox(const gl::Vec4Array& positions, int count);

  std::string name_;
  int capacity_;
  int box_ = 0;            ///< pair of corners around all bodies
  gl::Vec4Array corners_;  ///< pairs of corners, one reduction after the other
  gl::Vec4Array bodies_;   ///< sorted
  gl::Vec4Array boxes_;    ///< two a node
  gl::Vec4Array cells_;    ///< one a node
  gl::Vec4Array moments_;  ///< two a node
  gl::RadixSort sort_;
  gl::Kernel<TreeReduce> reduceBodies_, reduceBoxes_;
  gl::Kernel<TreeKey> key_;
  gl::Kernel<TreeGather> gather_;
  gl::Kernel<TreeBuild> leaves_, parents_;
  gl::Kernel<TreeWalk> walk_;  ///< of texels
  gl::Kernel<TreeWalkList> walkList_;
};

/// 1/opening as the kernels take it. Not below 0.87 (opening 1.15), where a node could stand for bodies of
/// its own: half the diagonal of a cube is 0.866 of its side.
[[nodiscard]] float perOpening(float opening);

/// eps^2 as the kernels take it, m^2: never zero, so that no body divides by its distance from itself.
[[nodiscard]] float softeningSquare(float softening);

}  // namespace simreel::sim

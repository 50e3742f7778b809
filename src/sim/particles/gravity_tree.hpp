#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/sort/radix_sort.hpp"
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

/// Computes the gravity of many bodies in O(N log N) on the GPU, without readback. Bodies are sorted along
/// a Hilbert curve and divided into leaves of 8 bodies below pointerless binary trees
/// (glsl/particles/tree/types.glsl). A node far from a group of 64 neighbouring bodies acts through its
/// mass and second moments. The result is bit-identical in every run and, in exact mode, on every device
/// and in the CPU reference.
///
/// Ignores bodies with coordinates beyond 1e18 m, with NaN, or with a mass outside 1e-30..1e30 kg: they
/// attract nothing and their acceleration is zero. The sum of the masses must be below 1e30 kg.
class GravityTree {
 public:
  /// Allocates buffers for up to `capacity` bodies, about 75 bytes per body. `fast` permits built-in
  /// arithmetic instead of bit-exact functions. Throws UserError(device), naming the device's limit.
  GravityTree(const std::string& name, int capacity, bool fast);

  /// Computes a_i = G sum_j m_j d_ij / (|d_ij|^2 + eps^2)^(3/2), d_ij from i to j, for the bodies
  /// 0..count-1.
  /// - positions: xyz in m, w the mass in kg
  /// - accelerations: output, xyz in m/s^2, w = 0
  /// - gravity: G in m^3/(kg s^2)
  /// - softening: eps in m, at least 1e-10
  /// - opening: maximum ratio of a node's side to its distance at which it acts as a whole, up to 1.15; 0
  ///   opens all nodes
  void accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                  float gravity, float softening, float opening);

  /// The three phases of accelerate(), in order; public for benchmarks.
  void sort(const gl::Vec4Array& positions, int count);
  void build(const gl::Vec4Array& positions, int count, float opening);
  void walk(const gl::Vec4Array& accelerations, int count, float gravity, float softening);

  /// Node data for tests: two texels per node (mass and second moments) and one texel per node (centre of
  /// mass, squared opening radius). In each block of 8192 nodes, node 1 is the root of a tree.
  [[nodiscard]] const gl::Vec4Array& moments() const { return moments_; }
  [[nodiscard]] const gl::Vec4Array& cells() const { return cells_; }

 private:
  void checkLimits() const;
  void findBox(const gl::Vec4Array& positions, int count);

  std::string name_;
  int capacity_;
  int box_ = 0;            ///< index of the pair of corners that bounds all bodies
  gl::Vec4Array corners_;  ///< corners (minimum, maximum) of the boxes of all reduction levels
  gl::Vec4Array bodies_;   ///< sorted bodies
  gl::Vec4Array boxes_;    ///< bounding boxes of nodes, two texels each
  gl::Vec4Array cells_;    ///< centres of mass and opening radii of nodes, one texel each
  gl::Vec4Array moments_;  ///< masses and second moments of nodes, two texels each
  gl::RadixSort sort_;
  gl::Kernel<TreeReduce> reduceBodies_, reduceBoxes_;
  gl::Kernel<TreeKey> key_;
  gl::Kernel<TreeGather> gather_;
  gl::Kernel<TreeBuild> leaves_, parents_;
  gl::Kernel<TreeWalk> walk_;  ///< used on the texel memory path
  gl::Kernel<TreeWalkList> walkList_;
};

/// Returns 1/opening, the distance in node sides beyond which a node replaces its bodies. It is at least
/// 0.87, which is more than half a cube's diagonal (0.866 sides); otherwise a group inside a node could be
/// attracted by its own bodies.
[[nodiscard]] float perOpening(float opening);

/// Returns eps^2 in m^2 for the kernels. It is never zero, so that the distance of a body to itself causes
/// no division by zero.
[[nodiscard]] float softeningSquare(float softening);

}  // namespace simreel::sim

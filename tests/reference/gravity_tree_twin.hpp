#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// CPU twin of the gravity tree. It runs the kernels' own model (glsl/particles/tree/model.glsl compiled as
/// C++) in plain loops. Equals the GPU bit for bit in exact mode.
class GravityTreeTwin {
 public:
  /// Work of a tree walk, summed over the groups of bodies.
  struct Work {
    std::int64_t visits = 0;  ///< number of visited nodes
    std::int64_t far = 0;     ///< number of nodes that were approximated by their multipoles
    std::int64_t leaves = 0;  ///< number of opened leaves
  };

  /// Sorts the bodies and builds the tree. xyz of a body is the position in metres, and w is the mass in
  /// kg. `threads`: number of threads; 0 to use all processors.
  GravityTreeTwin(std::span<const glm::vec4> bodies, float opening, int threads = 1);

  /// Returns the accelerations in m/s^2, in the order in which the bodies were given. w is 0.
  [[nodiscard]] std::vector<glm::vec4> accelerations(float gravity, float softening);

  std::vector<unsigned> order;     ///< indices of the bodies in order along the Hilbert curve
  std::vector<glm::vec4> sorted;   ///< bodies in order along the Hilbert curve, padded with zeros to whole
                                   ///< trees
  std::vector<glm::vec4> boxes;    ///< boxes of the nodes, two elements per node: the min and the max
                                   ///< corner
  std::vector<glm::vec4> cells;    ///< centres of mass of the nodes, one element per node; w: squared
                                   ///< opening radius
  std::vector<glm::vec4> moments;  ///< multipoles of the nodes, two elements per node: mass and second
                                   ///< moments
  Work work;                       ///< work of the last call of accelerations()

 private:
  void sort(std::span<const glm::vec4> bodies);
  void build(float opening);

  int threads_;
};

/// Distributions of bodies for gravity tests, with a total mass of 1 kg. They are the same in every run.
enum class Cloud { plummer, disk, twoClusters, onePoint, line, farClusters };
[[nodiscard]] std::vector<glm::vec4> bodiesOf(Cloud cloud, int count);

/// Returns the accelerations (m/s^2) of the bodies with indices `of`, as a sum over all pairs in double
/// precision.
[[nodiscard]] std::vector<glm::dvec3> allPairs(std::span<const glm::vec4> bodies, std::span<const int> of,
                                               double gravity, double softening);

/// Returns the sorted errors |a - b| / max(|b|, min) of the accelerations a relative to the exact values b.
/// `of`: body indices of the elements of `exact`.
[[nodiscard]] std::vector<double> relativeErrors(std::span<const glm::vec4> accelerations,
                                                 std::span<const glm::dvec3> exact, std::span<const int> of,
                                                 double min = 1e-30);

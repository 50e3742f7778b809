#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// The gravity tree on the CPU: the kernels' model (glsl/particles/tree/model.glsl compiled as C++) in
/// plain loops. Equals the GPU bit for bit in exact mode.
class GravityTreeTwin {
 public:
  /// Work of a walk, summed over groups of bodies.
  struct Work {
    std::int64_t visits = 0;  ///< number of visited nodes
    std::int64_t far = 0;     ///< number of nodes evaluated as multipoles
    std::int64_t leaves = 0;  ///< number of opened leaves
  };

  /// Sorts the bodies (xyz m, w kg) and builds the tree. `threads` 0: all processors.
  GravityTreeTwin(std::span<const glm::vec4> bodies, float opening, int threads = 1);

  /// Returns accelerations (xyz m/s^2, w 0) in the order of the given bodies.
  [[nodiscard]] std::vector<glm::vec4> accelerations(float gravity, float softening);

  std::vector<unsigned> order;     ///< indices of the bodies along the space-filling curve
  std::vector<glm::vec4> sorted;   ///< bodies in that order, padded with zeros to whole trees
  std::vector<glm::vec4> boxes;    ///< two per node: low and high corner of the node's box
  std::vector<glm::vec4> cells;    ///< one per node: centre of mass and squared opening radius
  std::vector<glm::vec4> moments;  ///< two per node: mass and spread of the node's bodies
  Work work;                       ///< work done by the last accelerations()

 private:
  void sort(std::span<const glm::vec4> bodies);
  void build(float opening);

  int threads_;
};

/// Sets of bodies for tests of gravity; total mass 1 kg, equal in every run.
enum class Cloud { plummer, disk, twoClusters, onePoint, line, farClusters };
[[nodiscard]] std::vector<glm::vec4> bodiesOf(Cloud cloud, int count);

/// Returns the sum over all pairs in double precision for the bodies with the indices `of`, m/s^2.
[[nodiscard]] std::vector<glm::dvec3> allPairs(std::span<const glm::vec4> bodies, std::span<const int> of,
                                               double gravity, double softening);

/// Returns the errors |a - b| / max(|b|, min), sorted; `of` holds the indices of the bodies in `exact`.
[[nodiscard]] std::vector<double> relativeErrors(std::span<const glm::vec4> accelerations,
                                                 std::span<const glm::dvec3> exact, std::span<const int> of,
                                                 double min = 1e-30);

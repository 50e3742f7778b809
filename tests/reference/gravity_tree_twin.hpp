#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// The gravity tree on the CPU: the kernels' own model (glsl/particles/tree/model.glsl compiled as C++) in
/// plain loops. Equals the GPU bit for bit in exact mode.
class GravityTreeTwin {
 public:
  /// What a walk did, summed over groups of bodies.
  struct Work {
    std::int64_t visits = 0;  ///< nodes looked at
    std::int64_t far = 0;     ///< nodes taken as multipoles
    std::int64_t leaves = 0;  ///< leaves opened
  };

  /// Sorts and builds. Bodies: xyz m, w kg. `threads` 0: all processors.
  GravityTreeTwin(std::span<const glm::vec4> bodies, float opening, int threads = 1);

  /// xyz m/s^2 in the order of the bodies given, w 0.
  [[nodiscard]] std::vector<glm::vec4> accelerations(float gravity, float softening);

  std::vector<unsigned> order;     ///< indices of the bodies along the curve
  std::vector<glm::vec4> sorted;   ///< bodies in that order, padded to whole trees with zeros
  std::vector<glm::vec4> boxes;    ///< two a node: low, high corner
  std::vector<glm::vec4> cells;    ///< one a node: centre of mass, opening radius squared
  std::vector<glm::vec4> moments;  ///< two a node: mass, spread
  Work work;                       ///< of the last accelerations()

 private:
  void sort(std::span<const glm::vec4> bodies);
  void build(float opening);

  int threads_;
};

/// Sets of bodies to try gravity on; total mass 1 kg, the same for every run.
enum class Cloud { plummer, disk, twoClusters, onePoint, line, farClusters };
[[nodiscard]] std::vector<glm::vec4> bodiesOf(Cloud cloud, int count);

/// The sum over all pairs in double precision for the bodies named by `of`, m/s^2.
[[nodiscard]] std::vector<glm::dvec3> allPairs(std::span<const glm::vec4> bodies, std::span<const int> of,
                                               double gravity, double softening);

/// Errors |a - b| / max(|b|, least), sorted; `of` names the bodies that `exact` is about.
[[nodiscard]] std::vector<double> relativeErrors(std::span<const glm::vec4> accelerations,
                                                 std::span<const glm::dvec3> exact, std::span<const int> of,
                                                 double min = 1e-30);

#pragma once
#include "reference/distance_twin.hpp"
#include "reference/walls_twin.hpp"
#include "reference/wind_twin.hpp"
#include "sim/mesh/height_plan.hpp"
#include "sim/particles/plan.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// Particles on the CPU: the kernels' own model (glsl/particles compiled as C++) in plain loops. Equals the
/// GPU bit for bit in exact mode with the methods "none" and "all-pairs".
class ParticlesTwin {
 public:
  explicit ParticlesTwin(simreel::sim::ParticlePlan plan);

  /// One frame starting at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  /// The parts of it, for particles in contact: of substep `index` of the frame begun, to where they would
  /// go; and after contact has changed `positions`, out of what they collide with.
  void beginFrame(double time, int threads = 1);
  void predict(int index, int threads = 1);
  void settle(int index);

  std::vector<glm::vec4> positions;      ///< xyz m, w kg
  std::vector<glm::vec4> velocities;     ///< xyz m/s, w age
  std::vector<glm::vec4> accelerations;  ///< xyz m/s^2
  std::vector<glm::vec4> starts;         ///< positions as predict() found them
  /// The mesh they fall onto; none without a plan.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4> heights;      ///< of the frame to step: x at its beginning, y at its end (m)
  std::optional<DistanceTwin> meshes;  ///< the rigid meshes they meet; none: no mesh
  std::optional<WallsTwin> walls;      ///< the solid they meet; none: no solid
  std::optional<WindTwin> wind;        ///< the fluid that is its wind; none: none blows
  [[nodiscard]] const simreel::sim::ParticlePlan& plan() const { return plan_; }
  /// Forgets the accelerations, after the state was changed from outside.
  void restart() { primed_ = false; }

 private:
  /// Stores particle `i` as what it collides with leaves it, from `start` on; null: from where it is.
  using Meet = std::function<void(std::size_t i, const glm::vec4& position, const glm::vec4& velocity,
                                  const glm::vec4* start)>;
  void meet(int index, const std::function<void(const Meet&)>& body);
  void attract(int threads);
  void kick(const simreel::shader::ParticleStep& data, int threads);

  simreel::sim::ParticlePlan plan_;
  std::vector<simreel::shader::ParticleStep> steps_;
  bool primed_ = false;
};

/// Acceleration of one target by `bodies` in the kernels' order of summation.
[[nodiscard]] glm::vec3 pairAcceleration(const std::vector<glm::vec4>& bodies, glm::vec3 here,
                                         float gravity, float softening);

/// Curl noise at p as the kernels have it, for tests.
[[nodiscard]] glm::vec3 curlNoiseAt(glm::vec3 p, int seed);

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

/// Particles on the CPU: the kernels' model (glsl/particles compiled as C++) in plain loops. Equals the GPU
/// bit for bit in exact mode with the methods "none" and "all-pairs".
class ParticlesTwin {
 public:
  explicit ParticlesTwin(simreel::sim::ParticlePlan plan);

  /// Simulates a frame that starts at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  /// The stages of step(), for particles in contact: predict() computes the positions after substep
  /// `index`; settle() resolves collisions after contact has changed `positions`.
  void beginFrame(double time, int threads = 1);
  void predict(int index, int threads = 1);
  void settle(int index);

  std::vector<glm::vec4> positions;      ///< position (xyz, m) and mass (w, kg) of each particle
  std::vector<glm::vec4> velocities;     ///< velocity (xyz, m/s) and age (w) of each particle
  std::vector<glm::vec4> accelerations;  ///< acceleration of each particle (xyz, m/s^2)
  std::vector<glm::vec4> starts;         ///< positions before the last predict()
  /// The height map that the particles fall onto; empty without one.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4>
      heights;  ///< heights of the mesh (m) for the current frame: x at its start, y at its end
  std::optional<DistanceTwin> meshes;  ///< rigid meshes that collide with the particles; empty without any
  std::optional<WallsTwin> walls;      ///< solid that collides with the particles; empty without one
  std::optional<WindTwin> wind;        ///< fluid that blows on the particles; empty without one
  [[nodiscard]] const simreel::sim::ParticlePlan& plan() const { return plan_; }
  /// Discards the accelerations; needed after a change of the state from outside.
  void restart() { primed_ = false; }

 private:
  /// Stores particle `i` after its collisions along the path from `start`; null: collisions at its position
  /// only.
  using Meet = std::function<void(std::size_t i, const glm::vec4& position, const glm::vec4& velocity,
                                  const glm::vec4* start)>;
  void meet(int index, const std::function<void(const Meet&)>& body);
  void attract(int threads);
  void kick(const simreel::shader::ParticleStep& data, int threads);

  simreel::sim::ParticlePlan plan_;
  std::vector<simreel::shader::ParticleStep> steps_;
  bool primed_ = false;
};

/// Returns the acceleration of a target by `bodies`, summed in the kernels' order.
[[nodiscard]] glm::vec3 pairAcceleration(const std::vector<glm::vec4>& bodies, glm::vec3 here,
                                         float gravity, float softening);

/// Returns the kernels' curl noise at p, for tests.
[[nodiscard]] glm::vec3 curlNoiseAt(glm::vec3 p, int seed);

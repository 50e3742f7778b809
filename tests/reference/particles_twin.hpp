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

/// CPU twin of particles: the kernels' own model (glsl/particles compiled as C++) in plain loops. Equals
/// the GPU bit for bit in exact mode with the methods "none" and "all-pairs".
class ParticlesTwin {
 public:
  explicit ParticlesTwin(simreel::sim::ParticlePlan plan);

  /// Steps one frame that starts at `time` (seconds). `threads`: 0 uses all processors.
  void step(double time, int threads = 1);
  /// Parts of step() for particles in contact: beginFrame() starts a frame, predict() computes the
  /// positions after substep `index`, and settle() resolves collisions after contact has changed
  /// `positions`.
  void beginFrame(double time, int threads = 1);
  void predict(int index, int threads = 1);
  void settle(int index);

  std::vector<glm::vec4> positions;      ///< xyz in metres, w in kg
  std::vector<glm::vec4> velocities;     ///< xyz in m/s, w age
  std::vector<glm::vec4> accelerations;  ///< xyz in m/s^2
  std::vector<glm::vec4> starts;         ///< positions before predict()
  /// The deformed mesh that the particles may touch, if any.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4> heights;      ///< mesh heights in metres: x frame start, y frame end
  std::optional<DistanceTwin> meshes;  ///< the rigid meshes that particles may touch, if any
  std::optional<WallsTwin> walls;      ///< the solid that the particles may touch, if any
  std::optional<WindTwin> wind;        ///< the fluid whose wind acts on them, if any
  [[nodiscard]] const simreel::sim::ParticlePlan& plan() const { return plan_; }
  /// Discards the accelerations; needed after the state was changed from outside.
  void restart() { primed_ = false; }

 private:
  /// Resolves the collisions of particle `i` on its way from `start` and stores the result; a null `start`
  /// is the current position.
  using Meet = std::function<void(std::size_t i, const glm::vec4& position, const glm::vec4& velocity,
                                  const glm::vec4* start)>;
  void meet(int index, const std::function<void(const Meet&)>& body);
  void touchBalls(int index);
  void attract(int threads);
  void kick(const simreel::shader::ParticleStep& data, int threads);

  simreel::sim::ParticlePlan plan_;
  std::vector<simreel::shader::ParticleStep> steps_;
  bool primed_ = false;
};

/// Returns the acceleration of one target by `bodies`, in the kernels' order of summation.
[[nodiscard]] glm::vec3 pairAcceleration(const std::vector<glm::vec4>& bodies, glm::vec3 here,
                                         float gravity, float softening);

/// Returns the kernels' curl noise at p, for tests.
[[nodiscard]] glm::vec3 curlNoiseAt(glm::vec3 p, int seed);

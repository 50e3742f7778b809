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

/// CPU twin of particles. It runs the kernels' own model (glsl/particles compiled as C++) in plain loops.
/// Equals the GPU bit for bit in exact mode with the methods "none" and "all-pairs".
class ParticlesTwin {
 public:
  explicit ParticlesTwin(simreel::sim::ParticlePlan plan);

  /// Steps one frame that starts at `time` (seconds). `threads`: number of threads; 0 to use all
  /// processors.
  void step(double time, int threads = 1);
  /// These functions are parts of step() for particles in contact. beginFrame() starts a frame, predict()
  /// computes the positions after substep `index`, and settle() resolves collisions after contact has
  /// changed `positions`.
  void beginFrame(double time, int threads = 1);
  void predict(int index, int threads = 1);
  void settle(int index);

  std::vector<glm::vec4> positions;      ///< positions (xyz, metres); w: mass in kg
  std::vector<glm::vec4> velocities;     ///< velocities (xyz, m/s); w: age in seconds
  std::vector<glm::vec4> accelerations;  ///< accelerations (xyz, m/s^2)
  std::vector<glm::vec4> spins;          ///< angular velocities (xyz, rad/s) of balls that turn
  std::vector<glm::vec4> turns;          ///< orientations of balls that turn (unit quaternions x, y, z, w)
  std::vector<glm::vec4> starts;         ///< positions before predict()
  /// Deformed mesh that the particles may touch.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4> heights;      ///< heights of the mesh in metres: x at the frame's start, y at the
                                       ///< frame's end
  std::optional<DistanceTwin> meshes;  ///< rigid meshes that the particles may touch
  std::optional<WallsTwin> walls;      ///< solid that the particles may touch
  std::optional<WindTwin> wind;        ///< fluid whose wind acts on the particles
  [[nodiscard]] const simreel::sim::ParticlePlan& plan() const { return plan_; }
  /// Discards the accelerations. Must be called after the state was changed from outside.
  void restart() { primed_ = false; }
  struct Balls;

 private:
  /// Angular velocity (m/s) and angle of the substep (m) of a ball that turns, times its radius.
  struct Rolling {
    glm::vec3 spin{0}, roll{0};
  };
  /// Function that resolves the collisions of particle `i` on its path from `start` and stores the result.
  /// A null `start` stands for the current position. Returns the rotation after the collisions.
  using Meet = std::function<Rolling(std::size_t i, const glm::vec4& position, const glm::vec4& velocity,
                                     const glm::vec4* start, const Rolling& rolling)>;
  void meet(int index, const std::function<void(const Meet&)>& body);
  void touchBalls(int index);
  void strikeBalls(int index, Balls& balls);
  void correctBalls(int index, Balls& balls);
  void attract(int threads);
  void kick(const simreel::shader::ParticleStep& data, int threads);

  simreel::sim::ParticlePlan plan_;
  std::vector<simreel::shader::ParticleStep> steps_;
  bool primed_ = false;
};

/// Returns the acceleration that `bodies` cause at one point, in the kernels' order of summation.
[[nodiscard]] glm::vec3 pairAcceleration(const std::vector<glm::vec4>& bodies, glm::vec3 here,
                                         float gravity, float softening);

/// Returns the kernels' curl noise at point p.
[[nodiscard]] glm::vec3 curlNoiseAt(glm::vec3 p, int seed);

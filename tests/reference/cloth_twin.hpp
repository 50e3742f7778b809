#pragma once
#include "reference/distance_twin.hpp"
#include "reference/walls_twin.hpp"
#include "reference/wind_twin.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/mesh/height_plan.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of the cloth. It runs the kernels' own model (glsl/cloth/model.glsl compiled as C++) in plain
/// loops. Equals the GPU bit for bit in exact mode.
class ClothTwin {
 public:
  explicit ClothTwin(simreel::sim::ClothPlan plan);

  /// Steps one frame that starts at `time` (seconds). `threads`: number of threads; 0 to use all
  /// processors.
  void step(double time, int threads = 1);
  /// Steps one substep with the given data. `index`: index of the substep in the frame.
  void substep(const simreel::shader::ClothStep& data, int threads = 1, int index = 0);
  /// predict() and finish() are the two halves of a substep. Between them, contact may change `next`;
  /// settle() then resolves collisions.
  void predict(const simreel::shader::ClothStep& data, int threads = 1, int index = 0);
  void settle(const simreel::shader::ClothStep& data, int index = 0, bool again = true);
  void finish();

  std::vector<glm::vec4> positions;   ///< positions (xyz, metres); w: inverse mass
  std::vector<glm::vec4> velocities;  ///< velocities (xyz, m/s); w: pin group
  std::vector<glm::vec4> trends;      ///< velocity changes (glsl/cloth/motion.glsl), xyz in m/s
  std::vector<glm::vec4> next;        ///< positions after the substep; valid between predict() and finish()
  /// Deformed mesh that the cloth may touch.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4> heights;      ///< heights of the mesh in metres: x at the frame's start, y at the
                                       ///< frame's end
  std::optional<DistanceTwin> meshes;  ///< rigid meshes that the cloth may touch
  std::optional<WallsTwin> walls;      ///< solid that the cloth may touch
  std::optional<WindTwin> wind;        ///< fluid whose wind acts on the cloth
  [[nodiscard]] simreel::sim::ClothPlan& plan() { return plan_; }

 private:
  void constrain(const simreel::shader::ClothStep& data);
  void resolveThin(const simreel::shader::ClothStep& data);

  simreel::sim::ClothPlan plan_;
  std::vector<glm::vec4> predicted_;  ///< positions after predict()
  std::vector<glm::vec4>
      pinDisplacements_;  ///< displacement during the frame of each pin that follows a skin
};

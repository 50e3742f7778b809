#pragma once
#include "reference/distance_twin.hpp"
#include "reference/walls_twin.hpp"
#include "reference/wind_twin.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/mesh/height_plan.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// Cloth on the CPU: the kernels' model (glsl/cloth/model.glsl compiled as C++) in plain loops. Equals the
/// GPU bit for bit in exact mode.
class ClothTwin {
 public:
  explicit ClothTwin(simreel::sim::ClothPlan plan);

  /// Simulates a frame that starts at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  /// Simulates a substep with the given data; `index` is its number within the frame.
  void substep(const simreel::shader::ClothStep& data, int threads = 1, int index = 0);
  /// Simulates a substep in two halves; contact may change `next` in between.
  void predict(const simreel::shader::ClothStep& data, int threads = 1, int index = 0);
  void settle(const simreel::shader::ClothStep& data, int index = 0, bool again = true);
  void finish();

  std::vector<glm::vec4> positions;   ///< position (xyz, m) and inverse mass (w) of each particle
  std::vector<glm::vec4> velocities;  ///< velocity (xyz, m/s) and pin group (w) of each particle
  /// velocity change by constraints in the last substep (xyz, m/s; glsl/cloth/motion.glsl)
  std::vector<glm::vec4> trends;
  std::vector<glm::vec4> next;  ///< predicted positions between predict() and finish()
  /// The height map that the cloth falls onto; empty without one.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4>
      heights;  ///< heights of the mesh (m) for the current frame: x at its start, y at its end
  std::optional<DistanceTwin> meshes;  ///< rigid meshes that collide with the cloth; empty without any
  std::optional<WallsTwin> walls;      ///< solid that collides with the cloth; empty without one
  std::optional<WindTwin> wind;        ///< fluid that blows on the cloth; empty without one
  [[nodiscard]] simreel::sim::ClothPlan& plan() { return plan_; }

 private:
  void constrain(const simreel::shader::ClothStep& data);
  void fend(const simreel::shader::ClothStep& data);

  simreel::sim::ClothPlan plan_;
  std::vector<glm::vec4> left_;  ///< positions at the end of predict()
  std::vector<glm::vec4> ways_;  ///< motion of skin-bound pins during the frame
};

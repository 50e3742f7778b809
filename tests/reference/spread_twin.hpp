#pragma once
#include "reference/wind_twin.hpp"
#include "sim/spread/epidemic_plan.hpp"
#include "sim/spread/wildfire_plan.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of the epidemic, with one byte per cell and separate reads of all neighbours. Decisions use the
/// kernels' own model (glsl/spread/epidemic/model.glsl compiled as C++). Equals the GPU bit for bit.
class EpidemicTwin {
 public:
  /// `start`: time of the first state in seconds.
  explicit EpidemicTwin(simreel::sim::EpidemicPlan plan, double start = 0);
  /// Steps one frame that starts at `time` (seconds). `threads`: number of threads; 0 to use all
  /// processors.
  void step(double time, int threads = 1);
  void oneStep(const simreel::sim::EpidemicPlan::Step& step, int threads = 1);

  std::vector<std::uint8_t> cells;
  std::vector<glm::uvec4> counts;  ///< counts of the first state and of the state after every step
  [[nodiscard]] simreel::sim::EpidemicPlan& plan() { return plan_; }

 private:
  void paint(const simreel::sim::EpidemicPlan::Step& step);

  simreel::sim::EpidemicPlan plan_;
  std::vector<std::uint8_t> next_;
};

/// CPU twin of a wildfire. It works like EpidemicTwin.
class WildfireTwin {
 public:
  /// `start`: time of the first state in seconds.
  explicit WildfireTwin(simreel::sim::WildfirePlan plan, double start = 0);
  void step(double time, int threads = 1);
  void oneStep(const simreel::sim::WildfirePlan::Step& step, int threads = 1);

  std::vector<std::uint8_t> cells;
  std::vector<glm::uvec4> counts;
  [[nodiscard]] simreel::sim::WildfirePlan& plan() { return plan_; }
  std::optional<WindTwin> wind;  ///< fluid whose wind acts on the fire
  /// Sets the fire's wind from the fluid, before the steps of the frame at `time` (seconds). `speed`: the
  /// fluid's parameter "speed".
  void blow(double time, float speed);

 private:
  void paint(const simreel::sim::WildfirePlan::Step& step);

  simreel::sim::WildfirePlan plan_;
  std::vector<std::uint8_t> next_;
  std::vector<glm::vec4> climbs_;
  std::vector<std::uint32_t> gales_;
};

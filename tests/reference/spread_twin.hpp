#pragma once
#include "reference/wind_twin.hpp"
#include "sim/spread/epidemic_plan.hpp"
#include "sim/spread/wildfire_plan.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// The epidemic on the CPU with one byte per cell and a plain loop over neighbours; decisions use the
/// kernels' model (glsl/spread/epidemic/model.glsl compiled as C++). Equals the GPU bit for bit.
class EpidemicTwin {
 public:
  /// `start` is the time (s) of the first state.
  explicit EpidemicTwin(simreel::sim::EpidemicPlan plan, double start = 0);
  /// Simulates a frame that starts at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  void oneStep(const simreel::sim::EpidemicPlan::Step& step, int threads = 1);

  std::vector<std::uint8_t> cells;
  std::vector<glm::uvec4> counts;  ///< counts of the start and of every step so far
  [[nodiscard]] simreel::sim::EpidemicPlan& plan() { return plan_; }

 private:
  void paint(const simreel::sim::EpidemicPlan::Step& step);

  simreel::sim::EpidemicPlan plan_;
  std::vector<std::uint8_t> next_;
};

/// The wildfire on the CPU, like EpidemicTwin.
class WildfireTwin {
 public:
  /// `start` is the time (s) of the first state.
  explicit WildfireTwin(simreel::sim::WildfirePlan plan, double start = 0);
  void step(double time, int threads = 1);
  void oneStep(const simreel::sim::WildfirePlan::Step& step, int threads = 1);

  std::vector<std::uint8_t> cells;
  std::vector<glm::uvec4> counts;
  [[nodiscard]] simreel::sim::WildfirePlan& plan() { return plan_; }
  std::optional<WindTwin> wind;  ///< fluid whose flow is the wind; empty: no fluid
  /// Updates the wind; call before the steps of the frame at `time` (s) if a fluid blows. `speed` is the
  /// scene's "speed".
  void blow(double time, float speed);

 private:
  void paint(const simreel::sim::WildfirePlan::Step& step);

  simreel::sim::WildfirePlan plan_;
  std::vector<std::uint8_t> next_;
  std::vector<glm::vec4> climbs_;
  std::vector<std::uint32_t> gales_;
};

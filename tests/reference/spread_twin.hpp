#pragma once
#include "reference/wind_twin.hpp"
#include "sim/spread/epidemic_plan.hpp"
#include "sim/spread/wildfire_plan.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// The epidemic on the CPU, a byte a cell and neighbours looked up one by one; decisions by the kernels'
/// own model (glsl/spread/epidemic/model.glsl compiled as C++). Equals the GPU bit for bit.
class EpidemicTwin {
 public:
  /// `start`: time (s) of the first state.
  explicit EpidemicTwin(simreel::sim::EpidemicPlan plan, double start = 0);
  /// One frame starting at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  void oneStep(const simreel::sim::EpidemicPlan::Step& step, int threads = 1);

  std::vector<std::uint8_t> cells;
  std::vector<glm::uvec4> counts;  ///< of the start and of every step so far
  [[nodiscard]] simreel::sim::EpidemicPlan& plan() { return plan_; }

 private:
  void paint(const simreel::sim::EpidemicPlan::Step& step);

  simreel::sim::EpidemicPlan plan_;
  std::vector<std::uint8_t> next_;
};

/// The same for a wildfire.
class WildfireTwin {
 public:
  /// `start`: time (s) of the first state.
  explicit WildfireTwin(simreel::sim::WildfirePlan plan, double start = 0);
  void step(double time, int threads = 1);
  void oneStep(const simreel::sim::WildfirePlan::Step& step, int threads = 1);

  std::vector<std::uint8_t> cells;
  std::vector<glm::uvec4> counts;
  [[nodiscard]] simreel::sim::WildfirePlan& plan() { return plan_; }
  std::optional<WindTwin> wind;  ///< the fluid that blows
  /// Before the steps of the frame at `time` (s) where a fluid of that "speed" blows.
  void blow(double time, float speed);

 private:
  void paint(const simreel::sim::WildfirePlan::Step& step);

  simreel::sim::WildfirePlan plan_;
  std::vector<std::uint8_t> next_;
  std::vector<glm::vec4> climbs_;
  std::vector<std::uint32_t> gales_;
};

#pragma once
#include "sim/core/carry_over.hpp"
#include "sim/core/kind.hpp"
#include "sim/spread/plan.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::shader {
#include "glsl/spread/epidemic/types.glsl"
static_assert(sizeof(EpidemicStep) == 80);
}  // namespace simreel::shader

namespace simreel::sim {

/// Susceptible, infected and recovered people on a grid (Kermack and McKendrick, 1927, as an automaton).
struct EpidemicParameters final : ObjectParameters, SpreadParameters {
  enum class Mixing { local, global };
  scene::Animated<float> beta = 0.06F;   ///< probability that one infected neighbour infects in a step
  scene::Animated<float> gamma = 0.08F;  ///< probability to recover in a step
  scene::Animated<float> waning = 0.0F;  ///< probability to become susceptible again in a step
  Mixing mixing = Mixing::local;
  double infected = 0.0;             ///< fraction of the people at the start, by hash
  double immune = 0.0;               ///< fraction of the people at the start, by hash
  std::filesystem::path population;  ///< level 0 to 255: fraction of inhabited cells there
  int trail = 63;  ///< steps over which colours follow the age of an infection or immunity
  // Blue, orange, grey: apart in hue and in lightness, also for those who see fewer colours.
  glm::vec3 susceptible{0.010F, 0.075F, 0.210F};
  glm::vec3 infection{1.0F, 0.62F, 0.10F};  ///< caught just now
  glm::vec3 infectious{0.88F, 0.18F, 0.02F};
  glm::vec3 recovering{0.46F, 0.42F, 0.37F};
  glm::vec3 recovered{0.22F, 0.22F, 0.21F};
  glm::vec3 nobody{0.004F, 0.007F, 0.013F};

  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override { return "its \"colors\""; }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t leastBlockBytes() const override { return std::int64_t{size.x} * size.y; }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
};

/// Everything of an epidemic that is decided on the CPU; shared by the GPU simulation and its CPU twin.
class EpidemicPlan {
 public:
  /// Loads maps. Throws UserError: what loadPicture says.
  EpidemicPlan(const EpidemicParameters& parameters, const std::string& object, int seed,
               double frameSeconds);

  /// One byte a cell (glsl/spread/cells.glsl), size.x * size.y, x fastest. Throws UserError(usage) when
  /// nobody lives on the map.
  [[nodiscard]] std::vector<std::uint8_t> firstCells() const;

  struct Step {
    shader::EpidemicStep data;
    std::vector<shader::Stroke> strokes;
  };
  /// The steps of the frame that starts at `time` (s). Call in order: each continues the numbers of the
  /// last.
  [[nodiscard]] std::vector<Step> frame(double time);
  /// Strokes that paint into the first state, when a run starts at `time` (s).
  [[nodiscard]] std::vector<shader::Stroke> firstStrokes(double time) const;
  void carryOver(CarryOver& carry) { carry.number("steps begun", done_); }
  /// `people`: how many cells are inhabited, for mixing.
  void setPeople(unsigned people) { people_ = people; }

  [[nodiscard]] const EpidemicParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  [[nodiscard]] int stepsPerFrame() const { return pace_.stepsPerFrame(); }
  /// Colours of the 256 values of a cell, linear RGB.
  [[nodiscard]] std::vector<glm::vec3> palette() const;

 private:
  EpidemicParameters parameters_;
  unsigned seed_;
  Pace pace_;
  Strokes strokes_;
  unsigned people_ = 1;
  unsigned done_ = 0;  ///< steps so far
};

}  // namespace simreel::sim

#pragma once
#include "scene/fitted.hpp"
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

/// Parameters of an epidemic of susceptible, infected and recovered people on a grid (Kermack and
/// McKendrick, 1927, as a cellular automaton).
struct EpidemicParameters final : ObjectParameters, SpreadParameters, scene::Fitted {
  enum class Mixing { local, global };
  scene::Animated<float> beta = 0.06F;   ///< probability per step that an infected neighbour infects a
                                         ///< susceptible person
  scene::Animated<float> gamma = 0.08F;  ///< probability per step that an infected person recovers
  scene::Animated<float> waning = 0.0F;  ///< probability per step that a recovered person becomes
                                         ///< susceptible again
  Mixing mixing = Mixing::local;
  double infected = 0.0;             ///< initial fraction of infected people, chosen by a hash
  double immune = 0.0;               ///< initial fraction of immune people, chosen by a hash
  std::filesystem::path population;  ///< image whose brightness is the fraction of inhabited cells
  int trail = 63;  ///< number of steps over which colours show the age of an infection or immunity
  // The default colours blue, orange and grey differ in hue and in lightness, also for colour-blind
  // viewers.
  glm::vec3 susceptible{0.010F, 0.075F, 0.210F};
  glm::vec3 infection{1.0F, 0.62F, 0.10F};  ///< colour of newly infected people
  glm::vec3 infectious{0.88F, 0.18F, 0.02F};
  glm::vec3 recovering{0.46F, 0.42F, 0.37F};
  glm::vec3 recovered{0.22F, 0.22F, 0.21F};
  glm::vec3 nobody{0.004F, 0.007F, 0.013F};

  void describe(scene::Fields& fields) override;
  void fitPicture(glm::ivec2 picture) override { size = display.fittedGrid(size, picture); }
  [[nodiscard]] const char* drawnWith() const override { return "its \"colors\""; }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    return std::int64_t{size.x} * size.y;
  }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
};

/// The part of an epidemic that the CPU computes. The GPU simulation and its CPU reference both use it.
class EpidemicPlan {
 public:
  /// Loads the images. Throws the UserError of loadPicture().
  EpidemicPlan(const EpidemicParameters& parameters, const std::string& object, int seed,
               double frameSeconds);

  /// Returns the initial state with one byte per cell (glsl/spread/cells.glsl), size.x * size.y cells, x
  /// fastest. Throws UserError(usage) if no cell is inhabited.
  [[nodiscard]] std::vector<std::uint8_t> firstCells() const;

  struct Step {
    shader::EpidemicStep data;
    std::vector<shader::Stroke> strokes;
  };
  /// Returns the steps of the frame that starts at `time` (seconds). Frames must be requested in order,
  /// because step numbers continue.
  [[nodiscard]] std::vector<Step> frame(double time);
  /// Returns the strokes that paint into the initial state of a run that starts at `time` (seconds).
  [[nodiscard]] std::vector<shader::Stroke> firstStrokes(double time) const;
  void visitCheckpointData(CarryOver& carry) { carry.number("steps begun", done_); }
  /// Sets the number of inhabited cells, used by global mixing.
  void setPeople(unsigned people) { people_ = people; }

  [[nodiscard]] const EpidemicParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  [[nodiscard]] int stepsPerFrame() const { return pace_.stepsPerFrame(); }
  /// Returns the linear RGB colours of the 256 cell values.
  [[nodiscard]] std::vector<glm::vec3> palette() const;

 private:
  EpidemicParameters parameters_;
  unsigned seed_;
  Pace pace_;
  Strokes strokes_;
  unsigned people_ = 1;
  unsigned done_ = 0;  ///< number of steps so far
};

}  // namespace simreel::sim

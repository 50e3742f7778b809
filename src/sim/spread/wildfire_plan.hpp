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
#include "glsl/spread/wildfire/types.glsl"
static_assert(sizeof(WildfireStep) == 96);
}  // namespace simreel::shader

namespace simreel::sim {

/// Sparks that the wind carries ahead of a fire.
struct Embers {
  double chance = 0.001;  ///< mean number of embers that a burning cell throws per step (a probability)
  double distance = 60;   ///< maximum flight distance along the wind in cells
  double spread = 0.3;    ///< lateral spread as a fraction of the flight distance
};

/// Parameters of a fire that spreads from cell to cell on a map of fuel.
struct WildfireParameters final : ObjectParameters,
                                  SpreadParameters,
                                  scene::Fitted,
                                  shader::WildfireConstants {
  std::filesystem::path fuel, obstacles, moistureMap, terrain;
  double fuelLevel = 1;  ///< factor on the fuel, 0 to 1
  double patchiness = 0.5;
  double patchSize = 40;  ///< size of the largest patches in cells
  double relief = 60;     ///< height difference in cells between white and black pixels of the terrain
                          ///< image
  double slope = 0;       ///< natural logarithm of the factor on the spread rate up a slope of 45 degrees
  scene::Animated<float> moisture = 0.0F;
  scene::Animated<float> spread = 0.12F;
  scene::Animated<float> windDirection = 0.0F;  ///< direction in degrees: 0 to the right, 90 up
  scene::Animated<float> windStrength = 0.0F;   ///< natural logarithm of the factor on the spread rate in
                                                ///< the wind's direction
  std::string windFluid;                        ///< name of the fluid that provides the wind; empty if none
  bool litInMiddle = false;  ///< true if the scene gives no strokes, so that a fire starts in the middle
  int coolSteps = 240;
  std::optional<Embers> embers;
  glm::vec3 forest{0.012F, 0.055F, 0.018F};
  glm::vec3 grass{0.150F, 0.190F, 0.050F};
  glm::vec3 rock{0.200F, 0.150F, 0.085F};
  glm::vec3 water{0.012F, 0.050F, 0.095F};
  glm::vec3 ash{0.052F, 0.047F, 0.043F};

  void describe(scene::Fields& fields) override;
  void fitPicture(glm::ivec2 picture) override {
    size = display.fittedGrid(size, picture);
    if (litInMiddle) strokes.front().from = strokes.front().to = glm::vec3(glm::vec2(size) * 0.5F, 0);
  }
  [[nodiscard]] const char* drawnWith() const override { return "its \"colors\""; }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    return std::int64_t{size.x} * size.y;
  }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
};

/// The part of a wildfire that the CPU computes. The GPU simulation and its CPU reference both use it.
class WildfirePlan {
 public:
  /// Loads the images. Throws the UserError of loadPicture(), and UserError(usage) if nothing on the map
  /// can burn.
  WildfirePlan(const WildfireParameters& parameters, const std::string& object, int seed,
               double frameSeconds);

  /// Returns the initial state with one byte per cell (glsl/spread/cells.glsl), size.x * size.y cells, x
  /// fastest. In a fuel cell, two bits of fuel amount are above four bits of ground shade. In a bare cell,
  /// the value 0, or 1 for obstacles, is above the shade.
  [[nodiscard]] const std::vector<std::uint8_t>& firstCells() const { return cells_; }
  /// Returns the flammability of each cell, 0 to 255.
  [[nodiscard]] const std::vector<std::uint8_t>& fuels() const { return fuels_; }
  /// Returns for each cell the ground shade (0 to 15) plus 16 times the phase in which the cell cools.
  [[nodiscard]] const std::vector<std::uint8_t>& ground() const { return ground_; }
  /// Returns the slope of the ground at each cell in the format of climbed() in
  /// glsl/spread/wildfire/model.glsl; empty if the slope has no effect.
  [[nodiscard]] const std::vector<std::uint16_t>& inclines() const { return inclines_; }
  /// Returns the 512 factors of climbFactor() in glsl/spread/wildfire/model.glsl, with four factors per
  /// element.
  [[nodiscard]] std::vector<glm::vec4> climbFactors() const;

  struct Step {
    shader::WildfireStep data;
    std::vector<shader::Stroke> strokes;
  };
  /// Returns the steps of the frame that starts at `time` (seconds). Frames must be requested in order,
  /// because step numbers continue.
  [[nodiscard]] std::vector<Step> frame(double time);
  /// Returns the strokes that paint into the initial state of a run that starts at `time` (seconds).
  [[nodiscard]] std::vector<shader::Stroke> firstStrokes(double time) const;
  void visitCheckpointData(CarryOver& carry) { carry.number("steps begun", done_); }

  [[nodiscard]] const WildfireParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  /// Returns the scale for galeOf() in glsl/spread/wildfire/gale.glsl in the frame that starts at `time`
  /// (seconds). `speed` is the parameter "speed" of the fluid in cells/s.
  [[nodiscard]] float galeScale(double time, float speed) const {
    return static_cast<float>(static_cast<double>(parameters_.windStrength.at(time)) / speed);
  }
  [[nodiscard]] int stepsPerFrame() const { return pace_.stepsPerFrame(); }
  /// Returns the linear RGB colours of the 256 cell values.
  [[nodiscard]] std::vector<glm::vec3> palette() const;

 private:
  void makeGround();
  void makeFuel();
  [[nodiscard]] shader::WildfireStep stepAt(double time) const;

  WildfireParameters parameters_;
  unsigned seed_;
  Pace pace_;
  Strokes strokes_;
  std::vector<std::uint8_t> cells_, fuels_, ground_;
  std::vector<std::uint16_t> inclines_;
  unsigned done_ = 0;  ///< number of steps so far
};

}  // namespace simreel::sim

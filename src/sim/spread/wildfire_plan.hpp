#pragma once
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
  double chance = 0.001;  ///< embers that a burning cell throws in a step
  double distance = 60;   ///< cells that the longest flight goes along the wind
  double spread = 0.3;    ///< how far to its side, as a fraction of the flight
};

/// Fire on a map of fuel, carried from cell to neighbouring cell.
struct WildfireParameters final : ObjectParameters, SpreadParameters, shader::WildfireConstants {
  std::filesystem::path fuel, obstacles, moistureMap, terrain;
  double fuelLevel = 1;  ///< of full fuel, 0 to 1
  double patchiness = 0.5;
  double patchSize = 40;  ///< cells
  double relief = 60;     ///< cells: height of the terrain's white above its black
  double slope = 0;       ///< logarithm of how much faster it spreads up a slope of 45 degrees
  scene::Animated<float> moisture = 0.0F;
  scene::Animated<float> spread = 0.12F;
  scene::Animated<float> windDirection = 0.0F;  ///< degrees: 0 to the right, 90 up
  scene::Animated<float> windStrength = 0.0F;   ///< logarithm of how much faster it spreads with the wind
  std::string windFluid;                        ///< name of the fluid that blows instead; empty: none
  int coolSteps = 240;
  std::optional<Embers> embers;
  glm::vec3 forest{0.012F, 0.055F, 0.018F};
  glm::vec3 grass{0.150F, 0.190F, 0.050F};
  glm::vec3 rock{0.200F, 0.150F, 0.085F};
  glm::vec3 water{0.012F, 0.050F, 0.095F};
  glm::vec3 ash{0.052F, 0.047F, 0.043F};

  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override { return "its \"colors\""; }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t leastBlockBytes() const override { return std::int64_t{size.x} * size.y; }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
};

/// Everything of a wildfire that is decided on the CPU; shared by the GPU simulation and its CPU twin.
class WildfirePlan {
 public:
  /// Loads maps. Throws UserError: what loadPicture says; usage when nothing on the map burns.
  WildfirePlan(const WildfireParameters& parameters, const std::string& object, int seed,
               double frameSeconds);

  /// One byte a cell (glsl/spread/cells.glsl), size.x * size.y, x fastest: of fuel two bits of its amount
  /// above four of the ground's shade, of bare ground 0 or (obstacles) 1 above the shade.
  [[nodiscard]] const std::vector<std::uint8_t>& firstCells() const { return cells_; }
  /// How readily each cell burns, 0 to 255.
  [[nodiscard]] const std::vector<std::uint8_t>& fuels() const { return fuels_; }
  /// The ground's shade, 0 to 15, and 16 times the phase in which it cools.
  [[nodiscard]] const std::vector<std::uint8_t>& ground() const { return ground_; }
  /// The ground's rise at each cell, as climbed() of glsl/spread/wildfire/model.glsl wants it; empty where
  /// the fire asks for none.
  [[nodiscard]] const std::vector<std::uint16_t>& inclines() const { return inclines_; }
  /// The 512 factors of climbFactor() there, four an element.
  [[nodiscard]] std::vector<glm::vec4> climbFactors() const;

  struct Step {
    shader::WildfireStep data;
    std::vector<shader::Stroke> strokes;
  };
  /// The steps of the frame that starts at `time` (s). Call in order: each continues the numbers of the
  /// last.
  [[nodiscard]] std::vector<Step> frame(double time);
  /// Strokes that paint into the first state, when a run starts at `time` (s).
  [[nodiscard]] std::vector<shader::Stroke> firstStrokes(double time) const;
  void carryOver(CarryOver& carry) { carry.number("steps begun", done_); }

  [[nodiscard]] const WildfireParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  /// Of galeOf() of glsl/spread/wildfire/gale.glsl in the frame that starts at `time` (s), for a fluid of
  /// that "speed" (cells/s).
  [[nodiscard]] float galeScale(double time, float speed) const {
    return static_cast<float>(static_cast<double>(parameters_.windStrength.at(time)) / speed);
  }
  [[nodiscard]] int stepsPerFrame() const { return pace_.stepsPerFrame(); }
  /// Colours of the 256 values of a cell, linear RGB.
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
  unsigned done_ = 0;  ///< steps so far
};

}  // namespace simreel::sim

#pragma once
#include "sim/contour/solid.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"

#include <cstdint>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// A cave by a cellular automaton as a scene says it.
struct CaveParameters final : ObjectParameters {
  glm::ivec2 size{96, 60};  ///< cells
  double fill = 0.45;       ///< probability that a cell is rock at first
  int smoothing = 5;        ///< steps
  int smallestRoom = 24;    ///< cells; smaller ones become rock
  int smallestRock = 12;    ///< cells; smaller ones become open
  bool connect = true;
  int corridor = 3;                 ///< cells across
  double stepSeconds = 0;           ///< s from a step to the next; 0: all is done before the first frame
  glm::vec3 position{0, -1.3F, 0};  ///< m: the floor's middle
  float cell = 0.05F;               ///< m
  scene::Animated<float> height = 0.2F;  ///< m: of the walls
  float base = 0.12F;                    ///< m of rock below the floor
  bool ceiling = false;
  float roof = 0.2F;  ///< m of rock above a ceiling
  glm::vec3 floor{0.50F, 0.36F, 0.22F};
  glm::vec3 wall{0.42F, 0.27F, 0.17F};
  glm::vec3 rock{0.16F, 0.145F, 0.15F};
  float grip = 25.3F;  ///< 1/s at which what touches it loses tangential velocity
  bool visible = true;
  enum class Show { cells, distances };
  Show show = Show::cells;  ///< what the display has
  FieldDisplay display;

  CaveParameters();
  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;

  /// Of the automaton: 0 is noise, then a smoothing each, then regions are removed, then all is done.
  [[nodiscard]] int lastStage() const { return smoothing + 2; }
  /// The stage that is there at `time` (s).
  [[nodiscard]] int stageAt(double time) const;
  /// 2^32 times the probability of rock; at most 2^32 - 1.
  [[nodiscard]] std::uint32_t threshold() const;
  /// Of the solid, with the heights of `time`.
  [[nodiscard]] SolidShape shape(double time) const;
  [[nodiscard]] std::vector<float> heightsAt(double time) const { return {0.0F, height.at(time)}; }
};

}  // namespace simreel::sim

#pragma once
#include "scene/framed_in_part.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/water/floats.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Boundary condition at a side of the grid, numbered as in glsl/water/types.glsl.
enum class WaterBorder { wall, open, periodic, sea };

/// Hill of the bed with an elliptical outline. Its profile is height (1 - r^2)^2, where r is the distance
/// from the centre relative to `radii`. A negative height gives a hollow.
struct WaterHill {
  glm::vec3 center{0};       ///< Centre in metres relative to the grid's centre (y unused).
  glm::vec3 radii{1, 0, 1};  ///< Radii in metres along x and z (y unused).
  float height = 1;          ///< Height of the hill in metres; a negative value gives a hollow.
};

/// Rectangle of the grid with a separate initial water level.
struct WaterPool {
  glm::vec3 from{0}, to{0};  ///< Two opposite corners in metres relative to the grid's centre (y unused).
  float level = 1;           ///< Initial water level in the rectangle, in metres.
};

/// Drop of water that falls onto the water at a given time.
struct WaterDropParameters {
  double at = 0;        ///< Time in seconds at which the drop falls.
  glm::vec3 center{0};  ///< Position in metres relative to the grid's centre (y unused).
  float radius = 0.2F;  ///< Radius of the drop in metres.
  float height = 0.1F;  ///< Rise of the level at the drop's centre in metres; a negative value gives a
                        ///< dent.
};

/// Drain that removes water.
struct WaterDrain {
  glm::vec3 center{0};                  ///< Position in metres relative to the grid's centre (y unused).
  float radius = 0.5F;                  ///< Radius of the drain in metres.
  scene::Animated<float> speed = 0.5F;  ///< Rate in m/s at which the level falls at the drain's centre.
  double from = 0, until = 1e9;         ///< Start and end of the drain's activity in seconds.
};

/// Rain: drops at random positions.
struct WaterRain {
  double rate = 10;      ///< Number of drops per second on the whole grid.
  float radius = 0.22F;  ///< Drop radius in metres.
  float height = 0.1F;   ///< Rise of the level at a drop's centre in metres.
  double duration = 0;   ///< Time in seconds over which a drop's water is added; 0: in one step.
  double variation = 0;  ///< Part by which times and heights of drops vary at random, from 0 to 1.
  double from = 0;       ///< Start of the rain in seconds.
  double until = 1e9;    ///< End of the rain in seconds.
};

/// Swell: waves that enter through a side with the boundary condition `sea`.
struct WaterSwell {
  int side = 3;  ///< Index of the side through which the waves enter: west, east, north, south.
  scene::Animated<float> height = 0.3F;  ///< Wave height in metres, from trough to crest.
  double period = 4;                     ///< Wave period in seconds.
  double phase = 0;                      ///< Initial phase as a fraction of a period.
};

/// Scene parameters of shallow water over a terrain.
struct WaterParameters : ObjectParameters,
                         HasColorRange,
                         ShowsQuantity,
                         NamesParts,
                         scene::Covering,
                         scene::FramedInPart {
  glm::ivec2 size{193, 193};  ///< Grid size in cells along x and z.
  float cell = 0.035F;        ///< Cell width in metres.
  glm::vec3 position{0};      ///< Position of the grid's centre at level 0, in metres.
  float level = 0;            ///< Initial water level in metres.
  std::vector<WaterPool> pools;
  float bed = -1;            ///< Height of the flat bed in metres.
  std::string groundObject;  ///< Object whose heights are the bed; empty if the bed does not move.
  bool ownTerrain = false, ownGround = false;  ///< true if the scene gives the ground's shape, its colour
  std::filesystem::path terrain;
  float terrainLow = -1,
        terrainHigh = 0.5F;  ///< Heights in metres of black and white pixels in the terrain image.
  int terrainSmooth = 2;
  std::vector<WaterHill> hills;
  std::array<WaterBorder, 4>
      sides{};  ///< Boundary conditions of the sides, in the order west, east, north, south.
  std::vector<WaterSwell> swell;
  float gravity = 9.81F;
  scene::Animated<float> drag = 0.0F;      ///< Linear drag coefficient of the flow in 1/s.
  float manning = 0;                       ///< Manning's roughness coefficient in s/m^(1/3).
  scene::Animated<float> rainfall = 0.0F;  ///< Uniform rainfall in mm/h.
  std::optional<int> substeps;  ///< Substeps per frame; if empty, they are chosen from the maximum depth
                                ///< and speed.
  std::optional<double> greatestDepth;  ///< Expected maximum depth in metres.
  std::optional<double> greatestSpeed;  ///< Expected maximum speed in m/s.
  std::vector<WaterDropParameters> drops;
  std::vector<WaterDrain> drains;
  std::optional<WaterRain> rain;
  bool isPond = false;  ///< True if the scene gives no parameters of the water, so that the default pond is
                        ///< used.
  bool restsOnGround = false;  ///< true since version 2: a ground without a height is below the terrain,
                               ///< whose sides are closed
  std::vector<StrokeParameters> strokes;
  std::vector<WaterFloat> floats;
  bool collides = false;
  float grip = 2;  ///< Rate in 1/s at which colliding objects lose tangential velocity.
  bool visible = true;
  bool ownDeep = false, ownRoughness = false;  ///< true if the scene gives the value in "look"
  glm::vec3 deep{0.003F, 0.022F, 0.024F};      ///< Colour of deep water, linear RGB.
  float roughness = 0.04F;
  glm::vec3 shallow{0.1F, 0.105F, 0.05F};  ///< Colour of shallow water, linear RGB.
  float clarity = 0.15F;                   ///< Depth in metres over which light fades to 1/e.
  float foam = 0;
  glm::vec3 ground{0.35F, 0.3F, 0.22F};  ///< Colour of the ground, linear RGB.
  float groundRoughness = 0.9F;
  std::filesystem::path groundTexture;
  float groundRepeat = 1;  ///< Number of repetitions of the ground texture along x.
  FieldDisplay display;

  WaterParameters();
  void describe(scene::Fields& fields) override;
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override { return display.measuredRanges(); }
  [[nodiscard]] ShownQuantity shownQuantity() const override { return {"depth", "m"}; }
  [[nodiscard]] ShownQuantity quantityOf(std::string_view part) const override {
    return part == "speed" ? ShownQuantity{"speed", "m/s"} : ShownQuantity{"level", "m"};
  }
  void leaveRoom(glm::vec2 room) override { display.room = room; }
  [[nodiscard]] Extent covering() const override { return display.covering(); }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    return std::int64_t{16} * size.x * size.y;
  }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] std::optional<scene::Box> framedWhole() const override;
  [[nodiscard]] std::optional<float> supportHeight() const override;
  [[nodiscard]] Looks looks() const override { return Looks::landscape; }
  [[nodiscard]] bool isTorus() const;

 private:
  /// Sets the defaults for a scene that gives no parameters of the water.
  void rainOnPond(scene::Fields& fields);
  /// Returns a height in metres above `position` that no part of the terrain is below.
  [[nodiscard]] float lowestGround() const;
  /// True if no key of the scene replaces the default pond by other water.
  [[nodiscard]] bool staysPond(const scene::Fields& fields) const;
  /// Returns the rain of a pond for a scene of this version.
  [[nodiscard]] WaterRain pondRain(int version) const;
  void pondTerrain(glm::vec2 extent, float smaller);
  void describeStart(scene::Fields& fields);
  void describeFlow(scene::Fields& fields);
  void describeLook(scene::Fields& fields);
};

}  // namespace simreel::sim

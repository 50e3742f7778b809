#pragma once
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"
#include "sim/water/floats.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// What lies beyond a side of the grid; in the order of glsl/water/types.glsl.
enum class WaterBorder { wall, open, periodic, sea };

/// A round rise of the bed, `height` (1 - r^2 / radius^2)^2; a hollow where the height is negative.
struct WaterHill {
  glm::vec3 center{0};       ///< m from the grid's middle along x and z (y unused)
  glm::vec3 radii{1, 0, 1};  ///< m along x and z (y unused)
  float height = 1;          ///< m
};

/// A part of the grid with a level of its own at the start.
struct WaterPool {
  glm::vec3 from{0}, to{0};  ///< m from the grid's middle: two corners (y unused)
  float level = 1;           ///< m
};

/// Water that falls into the grid at a moment.
struct WaterDropParameters {
  double at = 0;        ///< s
  glm::vec3 center{0};  ///< m from the grid's middle (y unused)
  float radius = 0.2F;  ///< m
  float height = 0.1F;  ///< m, that the level rises by in its middle; negative: a dent
};

/// Where water leaves.
struct WaterDrain {
  glm::vec3 center{0};                  ///< m from the grid's middle (y unused)
  float radius = 0.5F;                  ///< m
  scene::Animated<float> speed = 0.5F;  ///< m/s at which the level falls in its middle
  double from = 0, until = 1e9;         ///< s
};

/// Drops at random places.
struct WaterRain {
  double rate = 10;      ///< 1/s, on the whole grid
  float radius = 0.22F;  ///< m
  float height = 0.1F;   ///< m
  double from = 0;       ///< s
  double until = 1e9;    ///< s
};

/// Waves that come in from the sea.
struct WaterSwell {
  int side = 3;                          ///< west, east, north, south
  scene::Animated<float> height = 0.3F;  ///< m, from trough to crest
  double period = 4;                     ///< s
  double phase = 0;                      ///< of a period
};

/// Shallow water over a terrain as a scene says it.
struct WaterParameters : ObjectParameters {
  glm::ivec2 size{193, 193};  ///< cells along x and z
  float cell = 0.035F;        ///< m
  glm::vec3 position{0};      ///< m, the grid's middle at level 0
  float level = 0;            ///< m
  std::vector<WaterPool> pools;
  float bed = -1;  ///< m
  std::filesystem::path terrain;
  float terrainLow = -1, terrainHigh = 0.5F;  ///< m
  int terrainSmooth = 2;
  std::vector<WaterHill> hills;
  std::array<WaterBorder, 4> sides{};  ///< west, east, north, south
  std::vector<WaterSwell> swell;
  float gravity = 9.81F;
  scene::Animated<float> drag = 0.0F;      ///< 1/s
  float manning = 0;                       ///< s/m^(1/3)
  scene::Animated<float> rainfall = 0.0F;  ///< mm/h
  std::optional<int> substeps;             ///< empty: as the greatest depth and speed ask
  std::optional<double> greatestDepth;     ///< m
  std::optional<double> greatestSpeed;     ///< m/s
  std::vector<WaterDropParameters> drops;
  std::vector<WaterDrain> drains;
  std::optional<WaterRain> rain;
  bool isPond = false;  ///< nothing was said of the water
  std::vector<StrokeParameters> strokes;
  std::vector<WaterFloat> floats;
  bool collides = false;
  float grip = 2;  ///< 1/s
  bool visible = true;
  glm::vec3 deep{0.003F, 0.022F, 0.024F};  ///< linear RGB
  float roughness = 0.04F;
  glm::vec3 shallow{0.1F, 0.105F, 0.05F};  ///< linear RGB
  float clarity = 0.15F;                   ///< m
  float foam = 0;
  glm::vec3 ground{0.35F, 0.3F, 0.22F};  ///< linear RGB
  float groundRoughness = 0.9F;
  std::filesystem::path groundTexture;
  float groundRepeat = 1;  ///< of the texture along x
  FieldDisplay display;

  WaterParameters();
  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t leastBlockBytes() const override { return std::int64_t{16} * size.x * size.y; }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] Looks looks() const override { return Looks::landscape; }
  [[nodiscard]] bool isTorus() const;

 private:
  /// What a scene that says nothing of the water gets.
  void rainOnPond(scene::Fields& fields);
  void pondTerrain(glm::vec2 extent, float smaller);
  void describeStart(scene::Fields& fields);
  void describeFlow(scene::Fields& fields);
  void describeLook(scene::Fields& fields);
};

}  // namespace simreel::sim

#pragma once
#include "scene/scene.hpp"
#include "scene/value/fields.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include <glm/vec3.hpp>

namespace simreel::sim {

enum class WaterFloatShape { ball, box, file };

/// A line that pulls a float along.
struct FloatTow {
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< m from the grid's middle (y unused)
  bool turns = true;                                   ///< the float's z along its way
  float pull = 2;                                      ///< 1/s
};

/// A body that floats on the water and pushes it, as a scene says it.
struct WaterFloat {
  WaterFloatShape shape = WaterFloatShape::ball;
  float radius = 0.3F;          ///< m, of a ball
  glm::vec3 size{1, 0.4F, 2};   ///< m, of a box
  std::filesystem::path file;   ///< of a closed mesh
  float scale = 1;              ///< factor on the coordinates of files
  std::filesystem::path drawn;  ///< mesh that is drawn in place of the shape; may be open
  float density = 500;          ///< kg/m^3
  std::optional<double> mass;   ///< kg, instead
  glm::vec3 ballast{0};         ///< m from the volume's middle to that of the mass
  glm::vec3 position{0};        ///< m from the grid's middle, y over level 0: of the shape's origin
  glm::vec3 rotation{0};        ///< degrees
  glm::vec3 velocity{0};        ///< m/s
  glm::vec3 spin{0};            ///< degrees/s about x, y, z
  float drag = 0.2F;            ///< 1/s of a body as dense as the water
  float resistance = 0.5F;      ///< coefficient of the quadratic drag
  float keel = 1;               ///< factor on both sideways
  float air = 0;                ///< 1/s at which it loses speed in the air
  float friction = 0.4F;        ///< Coulomb's coefficient on the ground and on others
  std::optional<double> apart;  ///< m: radius of the sphere that others touch in its place
  scene::Animated<float> thrust = 0.0F;    ///< N along its z
  scene::Animated<float> steering = 0.0F;  ///< N m about its y
  std::optional<FloatTow> tow;
  scene::Material material;                         ///< colour, roughness, metal and texture of it
  std::set<std::string, std::less<>> materialKeys;  ///< keys of the material that the scene gives

  WaterFloat();
  void describe(scene::Fields& fields);
  /// Of the mesh that is drawn; empty: it is made.
  [[nodiscard]] const std::filesystem::path& drawnFile() const { return drawn.empty() ? file : drawn; }
  /// As an object of its own, for what it looks like.
  [[nodiscard]] scene::Object shownAs(const std::string& name) const;
};

}  // namespace simreel::sim

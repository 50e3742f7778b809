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

/// Tow line that pulls a floating body along a path.
struct FloatTow {
  scene::Animated<glm::vec3> position =
      glm::vec3(0);   ///< Position in metres relative to the grid's centre (y unused).
  bool turns = true;  ///< True if the body's z axis is turned to the direction of the path.
  float pull = 2;     ///< Rate in 1/s at which the body approaches the position of the tow line.
};

/// Scene parameters of a body that floats on the water and pushes it.
struct WaterFloat {
  WaterFloatShape shape = WaterFloatShape::ball;
  float radius = 0.3F;          ///< Radius of a ball in metres.
  glm::vec3 size{1, 0.4F, 2};   ///< Size of a box in metres.
  std::filesystem::path file;   ///< File of a closed mesh.
  float scale = 1;              ///< Factor on the coordinates of mesh files.
  std::filesystem::path drawn;  ///< File of a mesh that is drawn instead of the shape; it may be open.
  float density = 500;          ///< Density of the body in kg/m^3.
  std::optional<double> mass;   ///< Mass of the body in kg; if set, replaces `density`.
  glm::vec3 ballast{0};         ///< Offset in metres from the centre of volume to the centre of mass.
  glm::vec3 position{0};  ///< Position of the shape's origin in metres, relative to the grid's centre; y is
                          ///< relative to level 0.
  glm::vec3 rotation{0};  ///< Initial rotation in degrees.
  glm::vec3 velocity{0};  ///< Initial velocity in m/s.
  glm::vec3 spin{0};      ///< Initial angular velocity about x, y, z in degrees/s.
  float drag = 0.2F;      ///< Linear drag in 1/s, for a body with the density of water.
  float resistance = 0.5F;  ///< Coefficient of the quadratic drag.
  float keel = 1;           ///< Factor on linear and quadratic drag sideways (along local x).
  float air = 0;            ///< Rate in 1/s at which the body loses speed in air.
  float friction = 0.4F;    ///< Coulomb friction coefficient on the ground and against other bodies.
  std::optional<double>
      apart;  ///< Radius in metres of a sphere that replaces the body's shape in contact with other bodies.
  scene::Animated<float> thrust = 0.0F;    ///< Thrust in N along local z.
  scene::Animated<float> steering = 0.0F;  ///< Torque in N m about local y.
  std::optional<FloatTow> tow;
  scene::Material material;  ///< Colour, roughness, metalness and texture of the body.
  std::set<std::string, std::less<>> materialKeys;  ///< Material keys that the scene sets explicitly.

  WaterFloat();
  void describe(scene::Fields& fields);
  /// Returns the file of the mesh to draw; empty if the mesh is generated.
  [[nodiscard]] const std::filesystem::path& drawnFile() const { return drawn.empty() ? file : drawn; }
  /// Returns the body as a separate scene object, from which its appearance is determined.
  [[nodiscard]] scene::Object shownAs(const std::string& name) const;
};

}  // namespace simreel::sim

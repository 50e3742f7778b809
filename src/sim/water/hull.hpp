#pragma once
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/water/float_shape.hpp"
#include "sim/water/floats.hpp"

#include <array>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Geometry of a floating body: the drawn mesh, and cuboids that represent its volume. Computed in double
/// arithmetic in a fixed order, without libm.
struct Hull {
  /// Builds the hull; reads the body's file if it has one. `name` is used in messages. Throws the errors of
  /// loadMesh(), and UserError(usage) for a mesh that is not closed.
  Hull(const WaterFloat& body, const std::string& name);

  Mesh mesh;                       ///< Drawn mesh in metres; its origin is the centre of mass.
  std::vector<glm::vec3> corners;  ///< Vertices of the floating shape, in metres relative to the centre of
                                   ///< mass.
  std::vector<glm::vec4> points;   ///< One element per cuboid: xyz is the centre of the cuboid's part
                                   ///< inside the body (metres, relative to the centre of mass), w the
                                   ///< volume of that part (m^3).
  glm::dvec3 grain{0};             ///< Size of a cuboid in metres.
  glm::dvec3 middle{0};            ///< Centre of mass in metres, relative to the shape's origin.
  double volume = 0;               ///< Volume of the body in m^3.
  double area = 0;                 ///< Surface area in m^2.
  double outline = 0;              ///< Area of the outline seen from above, in m^2.
  double mass = 0;                 ///< Mass of the body in kg.
  double height = 0;               ///< Height of the bounding box in metres.
  double reach = 0;                ///< Distance in metres from the centre of mass to the farthest vertex.
  double aside2 =
      0;  ///< Mean squared distance (m^2) of the volume from the y axis through the centre of mass.
  FloatShape touched;  ///< Shape for contact with other bodies.
  /// Inertia tensor about the centre of mass in kg m^2: xx, yy, zz, xy, xz, yz.
  std::array<double, 6> inertia{};
  /// Returns the inverse inertia tensor in 1/(kg m^2), in the same order as `inertia`.
  [[nodiscard]] std::array<double, 6> inverseInertia() const;
};

}  // namespace simreel::sim

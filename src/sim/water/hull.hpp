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

/// A body that floats: what is drawn, and the cuboids that stand for its volume. All of it made in double
/// arithmetic in a fixed order, without libm.
struct Hull {
  /// Reads a file. `name` is of messages. Throws UserError: what loadMesh throws, and usage for a mesh that
  /// is not closed.
  Hull(const WaterFloat& body, const std::string& name);

  Mesh mesh;                       ///< m, what is drawn, its origin the middle of mass
  std::vector<glm::vec3> corners;  ///< m, vertices of the shape
  std::vector<glm::vec4>
      points;            ///< middle of a cuboid's part within (m from the middle of mass), m^3 of it
  glm::dvec3 grain{0};   ///< m: sides of a cuboid
  glm::dvec3 middle{0};  ///< m: of the mass, from the shape's origin
  double volume = 0;     ///< m^3
  double area = 0;       ///< m^2, of its surface
  double outline = 0;    ///< m^2, seen from above
  double mass = 0;       ///< kg
  double height = 0;     ///< m, of the box around it
  double reach = 0;      ///< m: farthest vertex from the middle of mass
  double aside2 = 0;     ///< m^2: mean square of its volume's way off the y axis through that
  FloatShape touched;    ///< what others touch of it
  /// kg m^2: xx, yy, zz, xy, xz, yz of the inertia tensor about the middle of mass.
  std::array<double, 6> inertia{};
  /// 1/(kg m^2): its inverse, in the same order.
  [[nodiscard]] std::array<double, 6> inverseInertia() const;
};

}  // namespace simreel::sim

#include "sim/cloth/fabric.hpp"

#include <algorithm>
#include <cstddef>

namespace simreel::sim {

shader::FabricConstants fabricOf(FabricMaterial material) {
  // Columns: density (kg/m^2), weft and warp stiffness (N/m), shear stiffness (N/m), bending stiffness (N
  // m), thickness (m).
  constexpr shader::FabricConstants table[] = {
      {0.115F, 10000, 15000, 50, 6e-6F, 2.5e-4F},   // cotton: shirt poplin
      {0.065F, 9000, 16000, 17, 3e-6F, 1.5e-4F},    // silk: habotai, 15 momme
      {0.40F, 12000, 25000, 250, 8e-5F, 8e-4F},     // denim: 12 ounces per square yard
      {0.11F, 15000, 20000, 60, 1.2e-5F, 2.2e-4F},  // nylon: flag cloth, 200 denier
      {0.34F, 20000, 30000, 400, 2e-4F, 6e-4F},     // canvas: 10-ounce cotton duck
      {0.47F, 750, 750, 250, 2.083e-5F, 5e-4F},     // rubber: latex
  };
  return table[static_cast<std::size_t>(material)];
}

void Fabric::describe(scene::Fields& f) {
  f.choice("material", material, {"cotton", "silk", "denim", "nylon", "canvas", "rubber"},
           "Material that supplies every property that is not given.");
  const auto property = [&](const char* name, std::optional<double>& value, scene::Range range,
                            const char* unit, const char* doc) {
    f.optionalNumber(name, value, range, unit, doc);
    f.leftOut(name, "the material's");
  };
  property("density", density, {1e-3, 1e3}, "kg/m^2",
           "Mass of an area; particles at borders have half of it.");
  property("weft", weft, {0.1, 1e7}, "N/m", "Stiffness against stretching along rows, of a mesh along u.");
  property("warp", warp, {0.1, 1e7}, "N/m",
           "Stiffness against stretching along columns, of a mesh across u.");
  property("shear", shear, {1e-3, 1e7}, "N/m",
           "Force along a side of unit length that shears by an angle of 1.");
  property("bending", bending, {0, 1e3}, "N m", "Moment on a side of unit length for a curvature of 1/m.");
  f.number("stretchDamping", stretchDamping, {0, 10}, "s",
           "Damping of stretch and shear. Their rate of change, multiplied by this time, is resisted as "
           "they are themselves; a vibration in the plane of the cloth with angular frequency w (rad/s) "
           "decays at the rate w^2/2 times this.");
  property("thickness", thickness, {0, 1}, "m",
           "Thickness of the fabric; half of it is kept from colliders in addition to \"margin\".");
}

shader::FabricConstants Fabric::constants() const {
  shader::FabricConstants c = fabricOf(material);
  const auto set = [](float& to, const std::optional<double>& from) {
    if (from) to = static_cast<float>(*from);
  };
  set(c.density, density);
  set(c.weft, weft);
  set(c.warp, warp);
  set(c.shear, shear);
  set(c.bending, bending);
  set(c.thickness, thickness);
  return c;
}

// If the diagonals in every cell have the stiffness d, they store the energy d ((ex + ey)^2 + g^2) / 2 per
// area, where ex and ey are the strains along x and y and g is the shear. With links of stiffness x and y,
// the sheet therefore resists a pull along x alone, where ey is free, by x + d - d^2 / (y + d) = x + d y /
// (y + d).
shader::FabricConstants Fabric::ofLinks(double diagonal) const {
  shader::FabricConstants c = constants();
  const double along = c.weft;
  const double across = c.warp;
  double x = along;
  double y = across;
  for (int i = 0; i < 64; ++i) {
    x = std::max(along - diagonal * y / (y + diagonal), 0.05 * along);
    y = std::max(across - diagonal * x / (x + diagonal), 0.05 * across);
  }
  c.weft = static_cast<float>(x);
  c.warp = static_cast<float>(y);
  return c;
}

}  // namespace simreel::sim

#include "sim/contact/solid.hpp"
#include "sim/mesh/height_field.hpp"
#include "sim/mesh/parameters.hpp"
#include "sim/ports/landform.hpp"
#include "sim/ports/markers.hpp"

namespace simreel::sim {

void MeshParameters::ports(Ports& ports) const {
  ports.provide<Landform>();
  ports.provide<Touchable>(collides);
  ports.provide<HeightField>(collides && !deform.list.empty()).path = {"collides"};
  ports.provide<ContactSolid>(byFaces).path = {"collides"};
}

}  // namespace simreel::sim

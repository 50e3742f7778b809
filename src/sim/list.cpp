#include "sim/list.hpp"

#include "sim/cloth.hpp"
#include "sim/gray_scott.hpp"
#include "sim/mesh.hpp"
#include "sim/particles.hpp"
#include "sim/shape.hpp"

#include <vector>

namespace simreel::sim {

std::span<const SimulationKind> simulations() {
  static const std::vector<SimulationKind> list = {
      clothKind(), particlesKind(), grayScottKind(), meshKind(), sphereKind(), capsuleKind(), planeKind(),
  };
  return list;
}

std::span<const scene::Kind> kinds() {
  static const std::vector<scene::Kind> list = [] {
    std::vector<scene::Kind> all;
    for (const SimulationKind& simulation : simulations()) all.push_back(simulation.kind);
    return all;
  }();
  return list;
}

}  // namespace simreel::sim

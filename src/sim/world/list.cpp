#include "sim/world/list.hpp"

#include "base/error.hpp"
#include "sim/arrows/arrows.hpp"
#include "sim/body/body.hpp"
#include "sim/cave/cave.hpp"
#include "sim/chart/chart.hpp"
#include "sim/color_bar/color_bar.hpp"
#include "sim/contour/contour.hpp"
#include "sim/flow/flow.hpp"
#include "sim/fluid/fluid.hpp"
#include "sim/garment/garment.hpp"
#include "sim/gray_scott/gray_scott.hpp"
#include "sim/isolines/isolines.hpp"
#include "sim/kernels/image.hpp"
#include "sim/kernels/kernels.hpp"
#include "sim/lenia/lenia.hpp"
#include "sim/life/life.hpp"
#include "sim/mesh/mesh.hpp"
#include "sim/mesh/solids.hpp"
#include "sim/nodes/camera_shot.hpp"
#include "sim/particles/particles.hpp"
#include "sim/reaction/reaction.hpp"
#include "sim/scale_bar/scale_bar.hpp"
#include "sim/shape/shape.hpp"
#include "sim/spread/epidemic.hpp"
#include "sim/spread/wildfire.hpp"
#include "sim/streamlines/streamlines.hpp"
#include "sim/text/text.hpp"
#include "sim/water/water.hpp"
#include "sim/world/port_check.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace simreel::sim {

std::span<const SimulationKind> simulations() {
  static const std::vector<SimulationKind> list = [] {
    std::vector<SimulationKind> all = {
        clothKind(),       particlesKind(), lifeKind(),     leniaKind(),    grayScottKind(), reactionKind(),
        epidemicKind(),    wildfireKind(),  fluidKind(),    waterKind(),    caveKind(),      contourKind(),
        meshKind(),        bodyKind(),      sphereKind(),   capsuleKind(),  planeKind(),     textKind(),
        chartKind(),       colorBarKind(),  isolinesKind(), scaleBarKind(), flowKind(),      arrowsKind(),
        streamlinesKind(), kernelsKind(),   imageKind(),
    };
    std::vector<SimulationKind> solids = solidKinds();
    const auto shapes = std::find_if(all.begin(), all.end(), [](const SimulationKind& one) {
      return one.kind.name == std::string_view("plane");
    });
    all.insert(shapes, std::make_move_iterator(solids.begin()), std::make_move_iterator(solids.end()));
    return all;
  }();
  return list;
}

const SimulationKind& simulationNamed(std::string_view kind) {
  const auto list = simulations();
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& s) { return s.kind.name == kind; });
  SIMREEL_CHECK(found != list.end());
  return *found;
}

const scene::Kinds& kinds() {
  static const std::vector<scene::Kind> list = [] {
    std::vector<scene::Kind> all;
    for (const SimulationKind& simulation : simulations()) all.push_back(simulation.kind);
    return all;
  }();
  static const scene::Kinds all{list, checkPorts, openCamera};
  return all;
}

}  // namespace simreel::sim

// Fuzzes the reader of glTF files with a skeleton.
#include "sim/body/figure.hpp"

#include "base/error.hpp"
#include "fuzz/reader.hpp"

#include <cmath>

namespace simreel::fuzz {
namespace {

void readFigure(std::string_view bytes) {
  const sim::Figure figure = sim::readFigure("fuzz.gltf", bytes);
  SIMREEL_CHECK_EQ(figure.follow.size(), figure.mesh.positions.size());
  SIMREEL_CHECK_EQ(figure.weights.size(), figure.mesh.positions.size());
  for (std::size_t i = 0; i < figure.follow.size(); ++i) {
    float sum = 0;
    for (int k = 0; k < 4; ++k) {
      SIMREEL_CHECK(figure.follow[i][k] < figure.joints.size());
      sum += figure.weights[i][k];
    }
    SIMREEL_CHECK(std::abs(sum - 1) < 1e-3F);
  }
  for (std::size_t i = 0; i < figure.nodes.size(); ++i)
    SIMREEL_CHECK(figure.nodes[i].parent < static_cast<int>(i));
  for (const sim::FigureJoint& joint : figure.joints)
    SIMREEL_CHECK(static_cast<std::size_t>(joint.node) < figure.nodes.size());
}

const Reader figureReader("figure", readFigure);

}  // namespace
}  // namespace simreel::fuzz

#include "base/error.hpp"
#include "sim/body/motion.hpp"
#include "sim/core/moments.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Returns the times at which the bounds are sampled: times along the animation, and the times of keys that
/// move the whole body.
std::vector<double> poseMoments(const BodyParameters& body) {
  std::vector<double> moments = {0};
  constexpr int looks = 12;
  if (!body.animation.empty() && body.speed != 0) {
    const double seconds = body.figure()->animationNamed(body.animation, "body").seconds;
    for (int i = 1; i <= looks; ++i) moments.push_back(seconds / std::abs(body.speed) * i / looks);
  }
  for (const double moment : momentsOf(body.position, body.rotation, body.scale)) moments.push_back(moment);
  return moments;
}

}  // namespace

std::vector<glm::vec3> BodyParameters::placesOnTheWay() const {
  std::vector<glm::vec3> places;
  try {
    const BodyMotion motion("body", *this);
    const Figure& figure = motion.figure();
    for (const double moment : poseMoments(*this)) {
      const std::vector<glm::vec4> rows = motion.rowsAt(moment);
      for (std::size_t v = 0; v < figure.mesh.positions.size(); ++v) {
        const glm::vec4 at(figure.mesh.positions[v], 1);
        glm::vec3 placed(0);
        for (int k = 0; k < 4; ++k)
          for (int axis = 0; axis < 3; ++axis)
            placed[axis] += figure.weights[v][k] *
                            glm::dot(rows[3 * figure.follow[v][k] + static_cast<unsigned>(axis)], at);
        places.push_back(placed);
      }
    }
  } catch (const UserError&) {
    return {};  // The constructor of the simulation reports this error.
  }
  return places;
}

std::optional<scene::Box> BodyParameters::framed() const {
  if (!visible) return std::nullopt;
  std::optional<scene::Box> box;
  for (const glm::vec3& at : placesOnTheWay()) scene::include(box, at);
  return box;
}

std::vector<glm::vec3> BodyParameters::outline() const {
  if (!visible) return {};
  return scene::outermost(placesOnTheWay());
}

}  // namespace simreel::sim

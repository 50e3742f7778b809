#include "draw/lens.hpp"

#include "base/ieee.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

using std::numbers::pi;
constexpr double pictureHeight = 0.024;  // sensor height (m) for which focal lengths are given

/// True if a point of the disc is inside the polygon. Always true if `blades` is 0, because the aperture is
/// then the disc.
bool isOpen(glm::dvec2 at, int blades) {
  if (blades == 0) return true;
  const double side = ieee::cos(pi / blades);  // distance of the polygon's sides from the centre
  for (int i = 0; i < blades; ++i) {
    const double angle = pi * (2 * i + 1) / blades;
    if (at.x * ieee::sin(angle) + at.y * ieee::cos(angle) > side) return false;
  }
  return true;
}

/// Returns the radius of the aperture (m).
double radiusOf(const scene::Lens& lens, const View& view, double seconds) {
  // reach.y is the tangent of half the angle of view. The focal length is half the sensor height divided by
  // reach.y.
  const double focal = 0.5 * pictureHeight / static_cast<double>(view.reach.y);
  return 0.5 * focal / static_cast<double>(lens.fNumber.at(seconds));
}

}  // namespace

// Uses the golden angle spiral (Vogel 1979), in which point i of n has the radius sqrt((i + 1/2) / n). The
// number n of points on the disc is raised until at least `count` of them lie in the polygon.
std::vector<glm::vec2> openingPoints(int count, int blades) {
  const double golden = pi * (3 - std::sqrt(5.0));
  std::vector<glm::vec2> points;
  for (int all = count; points.size() < static_cast<std::size_t>(count); ++all) {
    points.clear();
    for (int i = 0; i < all; ++i) {
      const double radius = std::sqrt((i + 0.5) / all), angle = golden * i;
      const glm::dvec2 at(radius * ieee::cos(angle), radius * ieee::sin(angle));
      if (isOpen(at, blades)) points.emplace_back(at);
    }
  }
  points.resize(static_cast<std::size_t>(count));
  return points;
}

std::vector<LensPoint> lensPoints(const scene::Camera& camera, const View& view, double seconds) {
  if (!camera.lens) return {LensPoint{}};
  const scene::Lens& lens = *camera.lens;
  const float focus = lens.focus ? lens.focus->at(seconds) : glm::length(view.target - view.eye);
  const auto radius = static_cast<float>(radiusOf(lens, view, seconds));
  const glm::vec3 right = view.right / view.reach.x, up = view.up / view.reach.y;
  std::vector<LensPoint> points;
  for (const glm::vec2& at : openingPoints(lens.samples, lens.blades))
    points.push_back({radius * (at.x * right + at.y * up), std::max(focus, camera.near)});
  return points;
}

glm::vec3 lensShift(const scene::Camera& camera, const View& view, glm::ivec2 size, float focus,
                    double seconds) {
  const scene::Lens& lens = *camera.lens;
  const int blades = lens.blades;
  const double area = blades == 0 ? pi : 0.5 * blades * ieee::sin(2 * pi / blades);
  // The limit keeps the points of a few views apart from each other.
  const double side = std::min(std::sqrt(area / lens.samples), 0.8);
  const double pixels = 0.5 * size.y / static_cast<double>(view.reach.y) * radiusOf(lens, view, seconds);
  return {pixels / static_cast<double>(focus), pixels / static_cast<double>(camera.near), side};
}

}  // namespace simreel::draw

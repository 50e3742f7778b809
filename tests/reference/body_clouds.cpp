// Makes distributions of bodies for gravity tests, and sums exact forces over all pairs in double
// precision.
#include "reference/gravity_tree_twin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

namespace {

/// Uniform random numbers in (0, 1) that are the same with every standard library.
class Random {
 public:
  double operator()() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }

 private:
  std::mt19937_64 engine_{7};
};

glm::dvec3 direction(Random& random) {
  const double z = 2 * random() - 1;
  const double angle = 2 * std::numbers::pi * random();
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Returns a random point of a Plummer sphere with scale 1 m. The sphere of radius 1 / sqrt(m^(-2/3) - 1)
/// contains the mass fraction m.
glm::dvec3 inPlummer(Random& random) {
  const double mass = std::min(random(), 0.999);
  return direction(random) / std::sqrt(std::pow(mass, -2.0 / 3.0) - 1);
}

/// Returns a random point of an exponential disk with scale length 1 m, thickness 0.05 m and radius 8 m.
glm::dvec3 inDisk(Random& random) {
  double r = 9;
  while (r > 8) r = -std::log(random() * random());
  const double angle = 2 * std::numbers::pi * random();
  return {r * std::cos(angle), 0.05 * (random() + random() - 1), r * std::sin(angle)};
}

glm::dvec3 place(Cloud cloud, Random& random, bool second) {
  switch (cloud) {
    case Cloud::plummer:
      return inPlummer(random);
    case Cloud::disk:
      return inDisk(random);
    case Cloud::twoClusters:
      return inPlummer(random) * 0.5 + (second ? glm::dvec3(4, 1, 0) : glm::dvec3(-2, 0, 1));
    case Cloud::onePoint:
      return {0.3, -0.7, 0.2};
    case Cloud::line:
      return {10 * random() - 3, 0.25, 0.25};
    case Cloud::farClusters:
      return inPlummer(random) + (second ? glm::dvec3(2000, 700, -300) : glm::dvec3(0));
  }
  return {};
}

}  // namespace

std::vector<glm::vec4> bodiesOf(Cloud cloud, int count) {
  Random random;
  std::vector<glm::vec4> bodies;
  bodies.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 at = place(cloud, random, i % 3 == 0);
    const double mass = (0.5 + random()) / count;
    bodies.emplace_back(at.x, at.y, at.z, mass);
  }
  return bodies;
}

std::vector<glm::dvec3> allPairs(std::span<const glm::vec4> bodies, std::span<const int> of, double gravity,
                                 double softening) {
  std::vector<glm::dvec3> result;
  for (const int i : of) {
    const glm::dvec3 here(bodies[static_cast<std::size_t>(i)]);
    glm::dvec3 sum(0);
    for (const glm::vec4& body : bodies) {
      const glm::dvec3 d = glm::dvec3(body) - here;
      const double square = glm::dot(d, d) + softening * softening;
      if (square > 0) sum += d * (static_cast<double>(body.w) / (square * std::sqrt(square)));
    }
    result.push_back(sum * gravity);
  }
  return result;
}

std::vector<double> relativeErrors(std::span<const glm::vec4> accelerations,
                                   std::span<const glm::dvec3> exact, std::span<const int> of, double min) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < of.size(); ++k) {
    const glm::dvec3 got(accelerations[static_cast<std::size_t>(of[k])]);
    errors.push_back(glm::length(got - exact[k]) / std::max(glm::length(exact[k]), min));
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

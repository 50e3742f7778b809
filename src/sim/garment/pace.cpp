#include "sim/garment/pace.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr double maxStretchError = 0.005;
/// Fraction of a length held by attachments that counts as hanging.
constexpr double attachedPart = 0.1;
constexpr int substepLimit = 1024;
/// Maximum number of substeps per frame that are added because of bending. Beyond it, elements are softened
/// instead, because otherwise a few slivers would slow down the whole cloth.
constexpr double maxForBending = 240;

constexpr double unreached = std::numeric_limits<double>::infinity();

/// Shortens `distances` along edges, starting from the vertices in `open` (Dijkstra). Returns the reached
/// vertices in the order of their distance.
std::vector<unsigned> spread(const ClothTriangles& cloth, const std::multimap<unsigned, unsigned>& links,
                             std::vector<double>& distances, std::set<std::pair<double, unsigned>> open) {
  std::vector<unsigned> reached;
  while (!open.empty()) {
    const auto [distance, vertex] = *open.begin();
    open.erase(open.begin());
    if (distance > distances[vertex]) continue;
    reached.push_back(vertex);
    const auto reach = [&](unsigned other, double length) {
      if (length >= distances[other]) return;
      distances[other] = length;
      open.emplace(length, other);
    };
    const auto [first, last] = links.equal_range(vertex);
    for (auto link = first; link != last; ++link) reach(link->second, distance);
    for (unsigned k = cloth.starts[vertex]; k < cloth.starts[vertex + 1]; ++k)
      for (const unsigned other : cloth.faces[cloth.around[k]].corners) {
        const glm::dvec3 d = cloth.points[other] - cloth.points[vertex];
        reach(other, distance + std::sqrt(glm::dot(d, d)));
      }
  }
  return reached;
}

}  // namespace

std::vector<double> hangingLengths(const ClothTriangles& cloth, const std::vector<bool>& pinned,
                                   const std::multimap<unsigned, unsigned>& links) {
  std::vector<double> distances(cloth.points.size(), unreached);
  std::set<std::pair<double, unsigned>> open;
  for (unsigned i = 0; i < distances.size(); ++i)
    if (pinned[i]) {
      distances[i] = 0;
      open.emplace(0.0, i);
    }
  spread(cloth, links, distances, open);
  for (unsigned i = 0; i < distances.size(); ++i) {
    if (distances[i] < unreached) continue;
    // For a piece without pins, searches from one end of the piece to the other.
    unsigned end = i;
    for (int way = 0; way < 2; ++way) {
      distances[end] = 0;
      const std::vector<unsigned> piece = spread(cloth, links, distances, {{0.0, end}});
      end = piece.back();
      const double longest = 0.5 * distances[end];
      for (const unsigned k : piece) distances[k] = way == 0 ? unreached : longest;
    }
  }
  return distances;
}

double hangingLength(const ClothTriangles& cloth, const std::vector<bool>& pinned,
                     const std::multimap<unsigned, unsigned>& links) {
  const std::vector<double> ways = hangingLengths(cloth, pinned, links);
  return *std::max_element(ways.begin(), ways.end());
}

GarmentPace::GarmentPace(const ClothParameters& parameters, const ClothTriangles& cloth,
                         const std::vector<MembraneElement>& membrane, const std::vector<double>& masses,
                         const std::vector<bool>& pinned, const std::multimap<unsigned, unsigned>& links) {
  softening = softeningSeconds(parameters, 1.0);
  if (parameters.keepsEnergy()) steadyPart = 0.4;  // in a swing the tension is three times as high
  const std::vector<double> ways = hangingLengths(cloth, pinned, links);
  std::vector<double> own(ways.size(), unreached);
  std::set<std::pair<double, unsigned>> pins;
  for (unsigned i = 0; i < own.size(); ++i)
    if (pinned[i]) {
      own[i] = 0;
      pins.emplace(0.0, i);
    }
  spread(cloth, {}, own, pins);
  for (std::size_t i = 0; i < ways.size(); ++i)
    hanging = std::max(hanging, own[i] < unreached ? attachedPart * own[i] : ways[i]);
  const double density = parameters.fabric->constants().density;
  double area = 0;
  double sum = 0;
  double total = 0;
  for (const double mass : masses) total += mass;
  for (std::size_t f = 0; f < membrane.size(); ++f) {
    const MembraneElement& e = membrane[f];
    const double gradients[3][2] = {{-e.p - e.q, -e.r - e.s}, {e.p, e.r}, {e.q, e.s}};
    double weight = 0;
    for (std::size_t k = 0; k < 3; ++k)
      weight += 0.5 * (gradients[k][0] * gradients[k][0] + gradients[k][1] * gradients[k][1]) /
                masses[cloth.faces[f].corners[k]];
    area += e.area;
    sum += e.area * e.area * weight;
  }
  const double fastest = parameters.fastestAir();
  const Air air = parameters.air.value_or(Air{});
  const double pushed = air.density * static_cast<double>(air.drag + air.lift);
  drag = pushed * fastest / density;
  const double streaming = 0.1 * 0.5 * pushed * fastest * fastest / density;
  const double load = parameters.greatestLoad(total / static_cast<double>(masses.size())) + streaming;
  stiffening = density * load * hanging * sum / area;
}

double GarmentPace::stableSeconds() const {
  // As for grids (ClothParameters::stableSeconds()), semi-implicit Euler is stable if (w dt)^2 + 2 c dt <
  // 4, where c is the drag rate and w^2 <= 4 T A S for faces with the tension T.
  const double rate = drag + std::sqrt(drag * drag + 16.0 * stiffening);
  return rate > 0 ? 4.0 / rate : unreached;
}

int GarmentPace::substeps(double frameSeconds, double bendingSquared, int fewest) const {
  const double bending =
      std::min(frameSeconds * std::sqrt(bendingSquared / maxBending(1.0)), maxForBending);
  const double stretching = frameSeconds * std::sqrt(stretchError(1.0) / maxStretchError);
  const double steady = frameSeconds / (steadyPart * stableSeconds());
  const double needed = std::ceil(std::max({bending, stretching, steady}));
  return static_cast<int>(
      std::clamp(needed, static_cast<double>(fewest), static_cast<double>(substepLimit)));
}

}  // namespace simreel::sim

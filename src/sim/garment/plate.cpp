#include "sim/garment/plate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace simreel::sim {

namespace {

using Face = ClothTriangles::Face;

struct FlatPoint {
  unsigned vertex;
  glm::dvec2 place;
};

/// Face unfolded into the plane of the patch's first face.
struct FlatFace {
  unsigned face;
  std::array<glm::dvec2, 3> corners;
};

/// The two faces at an edge and the rings of faces around them, unfolded into one plane. The origin is the
/// middle of the edge. The x axis runs along the edge; the y axis points out of the first face.
class Patch {
 public:
  Patch(const ClothTriangles& cloth, unsigned first, std::size_t side) : cloth_(cloth) {
    const Face& face = cloth.faces[first];
    const glm::dvec3 a = cloth.points[face.corners[side]];
    const glm::dvec3 b = cloth.points[face.corners[(side + 1) % 3]] - a;
    const glm::dvec3 c = cloth.points[face.corners[(side + 2) % 3]] - a;
    length = std::sqrt(glm::dot(b, b));
    const double half = 0.5 * length;
    FlatFace flat{first, {}};
    flat.corners[side] = {-half, 0};
    flat.corners[(side + 1) % 3] = {half, 0};
    flat.corners[(side + 2) % 3] = {glm::dot(b, c) / length - half, -2 * face.area / length};
    faces_.push_back(flat);
    for (std::size_t k = 0; k < 3; ++k) points.push_back({cloth.firstOf(face.corners[k]), flat.corners[k]});
    addBeyond(flat, side);
  }

  /// Adds the faces beyond the edges of the last ring.
  void widen() {
    const std::size_t end = faces_.size();
    for (std::size_t i = next_; i < end; ++i)
      for (std::size_t side = 0; side < 3; ++side) addBeyond(faces_[i], side);
    next_ = end;
  }

  std::vector<FlatPoint> points;
  double length;  ///< length of the edge in metres

 private:
  void addBeyond(const FlatFace from, std::size_t side) {
    const Face& face = cloth_.faces[from.face];
    const unsigned other = face.neighbours[side];
    if (other == ClothTriangles::none) return;
    if (std::any_of(faces_.begin(), faces_.end(), [&](const FlatFace& f) { return f.face == other; }))
      return;
    const glm::dvec2 p = from.corners[side];
    const glm::dvec2 along = from.corners[(side + 1) % 3] - p;
    // Uses the neighbour's corners, because after sewing they differ from this face's corners.
    const Face& beyond = cloth_.faces[other];
    const std::size_t back = cloth_.sideBeyond(from.face, side);
    const glm::dvec3 start = cloth_.points[beyond.corners[(back + 1) % 3]];
    const glm::dvec3 edge = cloth_.points[beyond.corners[back]] - start;
    const unsigned vertex = beyond.corners[(back + 2) % 3];
    const double squared = glm::dot(edge, edge);
    const double part = glm::dot(cloth_.points[vertex] - start, edge) / squared;
    const double height = 2 * cloth_.faces[other].area / squared;
    const glm::dvec2 place = p + along * part + glm::dvec2(-along.y, along.x) * height;
    FlatFace flat{other, {}};
    flat.corners[(back + 1) % 3] = p;
    flat.corners[back] = p + along;
    flat.corners[(back + 2) % 3] = place;
    faces_.push_back(flat);
    const unsigned first = cloth_.firstOf(vertex);
    if (std::none_of(points.begin(), points.end(), [&](const FlatPoint& q) { return q.vertex == first; }))
      points.push_back({first, place});
  }

  const ClothTriangles& cloth_;
  std::vector<FlatFace> faces_;
  std::size_t next_ = 0;
};

constexpr std::size_t maxUnknowns = 6;
using SolverRow = std::array<double, maxUnknowns>;

/// Returns the inverse of a symmetric positive definite matrix; nullopt if it is singular.
std::optional<std::array<SolverRow, maxUnknowns>> inverse(std::array<SolverRow, maxUnknowns> m,
                                                          std::size_t size) {
  std::array<SolverRow, maxUnknowns> result{};
  for (std::size_t i = 0; i < size; ++i) result[i][i] = 1;
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < size; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    if (!(std::abs(m[pivot][k]) > 1e-9)) return std::nullopt;
    std::swap(m[k], m[pivot]);
    std::swap(result[k], result[pivot]);
    const double by = 1 / m[k][k];
    for (std::size_t j = 0; j < size; ++j) {
      m[k][j] *= by;
      result[k][j] *= by;
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (i == k) continue;
      const double factor = m[i][k];
      for (std::size_t j = 0; j < size; ++j) {
        m[i][j] -= factor * m[k][j];
        result[i][j] -= factor * result[k][j];
      }
    }
  }
  return result;
}

/// One term of a weighted sum over vertices.
struct Term {
  unsigned vertex;
  double weight;
};

/// Returns the derivative along y at the origin (1/m) of the quadratic that best fits the points. The list
/// of terms is empty if the points do not determine a quadratic.
std::vector<Term> slopeOfFit(const Patch& patch) {
  if (patch.points.size() < maxUnknowns) return {};
  std::vector<SolverRow> values;
  std::array<SolverRow, maxUnknowns> normal{};
  for (const FlatPoint& point : patch.points) {
    const glm::dvec2 p = point.place / patch.length;
    const SolverRow row{1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y};
    values.push_back(row);
    for (std::size_t i = 0; i < maxUnknowns; ++i)
      for (std::size_t j = 0; j < maxUnknowns; ++j) normal[i][j] += row[i] * row[j];
  }
  const auto solved = inverse(normal, maxUnknowns);
  if (!solved) return {};
  std::vector<Term> terms;
  for (std::size_t i = 0; i < values.size(); ++i) {
    double weight = 0;
    for (std::size_t j = 0; j < maxUnknowns; ++j) weight += (*solved)[2][j] * values[i][j];
    terms.push_back({patch.points[i].vertex, weight / patch.length});
  }
  return terms;
}

/// Returns the mean slope of the planes of the two faces; used if there are too few points for a fit.
std::vector<Term> slopeOfPlanes(const Patch& patch) {
  std::vector<Term> terms;
  for (std::size_t k = 0; k < 4; ++k) terms.push_back({patch.points[k].vertex, 0});
  const auto ends = [&](std::size_t k) { return std::abs(patch.points[k].place.y) < 1e-9 * patch.length; };
  for (std::size_t k = 0; k < 4; ++k) {
    if (ends(k)) continue;
    const glm::dvec2 p = patch.points[k].place;
    terms[k].weight += 0.5 / p.y;
    for (std::size_t end = 0; end < 4; ++end)
      if (ends(end))
        terms[end].weight -=
            0.5 / p.y * (0.5 + p.x * patch.points[end].place.x * 2 / (patch.length * patch.length));
  }
  return terms;
}

/// Returns the derivative across an edge at its middle, in the direction out of the face.
std::vector<Term> slopeAcross(const ClothTriangles& cloth, unsigned face, std::size_t side) {
  constexpr double maximum = 3;
  constexpr int rings = 3;
  Patch patch(cloth, face, side);
  std::vector<Term> best;
  double minimum = 1e30;
  for (int ring = 0; ring < rings && minimum > maximum; ++ring) {
    patch.widen();
    std::vector<Term> terms = slopeOfFit(patch);
    double size = 0;
    for (const Term& term : terms) size += term.weight * term.weight * patch.length * patch.length;
    if (terms.empty() || size >= minimum) continue;
    minimum = size;
    best = std::move(terms);
  }
  return best.empty() ? slopeOfPlanes(patch) : best;
}

/// Returns the symmetric part of the product a b^T as (xx, yy, sqrt(2) xy), so that the dot product of the
/// result with itself is the sum of the squared entries.
glm::dvec3 symmetric(const glm::dvec2& a, const glm::dvec2& b) {
  return {a.x * b.x, a.y * b.y, (a.x * b.y + a.y * b.x) / std::numbers::sqrt2};
}

/// Returns v without its components along `directions`, which need not be orthogonal.
glm::dvec3 without(const std::vector<glm::dvec3>& directions, glm::dvec3 v) {
  std::vector<glm::dvec3> axes;
  for (glm::dvec3 axis : directions) {
    for (const glm::dvec3& other : axes) axis -= other * glm::dot(axis, other);
    const double squared = glm::dot(axis, axis);
    if (squared < 1e-12) continue;
    axes.push_back(axis / std::sqrt(squared));
    v -= axes.back() * glm::dot(v, axes.back());
  }
  return v;
}

using Slopes = std::vector<std::array<std::vector<Term>, 3>>;

/// Clamped edges of a face, one per side; null for a side that is not clamped.
using Clamps = std::array<const ClampedEdge*, 3>;

PlateElement elementOf(const ClothTriangles& cloth, unsigned number, const Slopes& slopes,
                       const Clamps& clamps) {
  const Face& face = cloth.faces[number];
  PlateElement element;
  element.area = face.area;
  const auto add = [&](unsigned vertex, const glm::dvec3& weights) {
    for (PlateElement::Part& part : element.parts)
      if (part.vertex == vertex) {
        part.weights += weights;
        return;
      }
    element.parts.push_back({vertex, weights});
  };
  const glm::dvec3 a = cloth.points[face.corners[0]];
  const glm::dvec3 b = cloth.points[face.corners[1]] - a;
  const glm::dvec3 c = cloth.points[face.corners[2]] - a;
  const double base = std::sqrt(glm::dot(b, b));
  const glm::dvec2 flat[3] = {{0, 0}, {base, 0}, {glm::dot(b, c) / base, 2 * face.area / base}};
  std::vector<glm::dvec3> free;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 edge = flat[(k + 1) % 3] - flat[k];
    const double length = std::sqrt(glm::dot(edge, edge));
    const glm::dvec2 along = edge / length;
    const glm::dvec2 out(along.y, -along.x);
    const glm::dvec3 twist =
        symmetric(along, out) / face.area;  // edge length times slope along the edge (difference / edge
                                            // length): the lengths cancel
    add(cloth.firstOf(face.corners[(k + 1) % 3]), twist);
    add(cloth.firstOf(face.corners[k]), -twist);
    if (clamps[k] != nullptr) {
      const glm::dvec3 towards = symmetric(out, out) * (length / face.area / clamps[k]->reach);
      add(clamps[k]->ghost, towards);
      for (const std::size_t end : {k, (k + 1) % 3}) add(cloth.firstOf(face.corners[end]), -0.5 * towards);
      continue;
    }
    if (face.neighbours[k] == ClothTriangles::none) {
      free.push_back(symmetric(out, out));
      continue;
    }
    const bool mine = number < face.neighbours[k];
    const std::vector<Term>& slope =
        mine ? slopes[number][k] : slopes[face.neighbours[k]][cloth.sideBeyond(number, k)];
    const glm::dvec3 bend = symmetric(out, out) * ((mine ? length : -length) / face.area);
    for (const Term& term : slope) add(term.vertex, bend * term.weight);
  }
  if (free.size() == 3) element.parts.clear();
  for (PlateElement::Part& part : element.parts) part.weights = without(free, part.weights);
  return element;
}

/// Distributes the weight of a sewn vertex evenly over all vertices that are sewn together with it.
void share(const std::vector<std::vector<unsigned>>& sewn, PlateElement& element) {
  std::vector<PlateElement::Part> parts;
  for (const PlateElement::Part& part : element.parts) {
    if (part.vertex >= sewn.size() || sewn[part.vertex].size() < 2) {
      parts.push_back(part);
      continue;
    }
    const auto& all = sewn[part.vertex];
    for (const unsigned vertex : all)
      parts.push_back({vertex, part.weights / static_cast<double>(all.size())});
  }
  element.parts = std::move(parts);
}

/// Returns an entry of the element's matrix without the factor D (the bending stiffness).
double entry(const PlateElement& element, std::size_t i, std::size_t j) {
  return element.area * glm::dot(element.parts[i].weights, element.parts[j].weights);
}

/// Returns the element's contribution, without the factor D, to the frequency bound at its i-th vertex.
double boundAt(const PlateElement& element, std::size_t i, const std::vector<double>& inverseMasses) {
  double sum = 0;
  for (std::size_t j = 0; j < element.parts.size(); ++j) sum += std::abs(entry(element, i, j));
  return sum * inverseMasses[element.parts[i].vertex];
}

std::vector<double> bounds(const std::vector<PlateElement>& elements, double bending,
                           const std::vector<double>& inverseMasses) {
  std::vector<double> sums(inverseMasses.size(), 0);
  for (const PlateElement& element : elements)
    for (std::size_t i = 0; i < element.parts.size(); ++i)
      sums[element.parts[i].vertex] += bending * boundAt(element, i, inverseMasses);
  return sums;
}

}  // namespace

std::vector<PlateElement> plateElements(const ClothTriangles& cloth,
                                        const std::vector<ClampedEdge>& clamps) {
  std::vector<PlateElement> elements;
  elements.reserve(cloth.faces.size());
  Slopes slopes(cloth.faces.size());
  for (unsigned f = 0; f < cloth.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (const unsigned other = cloth.faces[f].neighbours[k]; other != ClothTriangles::none && f < other)
        slopes[f][k] = slopeAcross(cloth, f, k);
  std::map<unsigned, Clamps> clamped;
  for (const ClampedEdge& edge : clamps) clamped.try_emplace(edge.face).first->second[edge.side] = &edge;
  for (unsigned f = 0; f < cloth.faces.size(); ++f) {
    const auto found = clamped.find(f);
    elements.push_back(elementOf(cloth, f, slopes, found == clamped.end() ? Clamps{} : found->second));
  }
  std::vector<std::vector<unsigned>> sewn(cloth.points.size());
  for (unsigned i = 0; i < cloth.points.size(); ++i) sewn[cloth.firstOf(i)].push_back(i);
  for (PlateElement& element : elements) share(sewn, element);
  return elements;
}

double plateEnergy(const std::vector<PlateElement>& elements, double bending,
                   const std::vector<glm::dvec3>& points) {
  double sum = 0;
  for (const PlateElement& element : elements) {
    glm::dvec3 second[3] = {glm::dvec3(0), glm::dvec3(0), glm::dvec3(0)};
    for (const PlateElement::Part& part : element.parts)
      for (int k = 0; k < 3; ++k) second[k] += part.weights[k] * points[part.vertex];
    for (const glm::dvec3& h : second) sum += 0.5 * bending * element.area * glm::dot(h, h);
  }
  return sum;
}

PlateMatrix::PlateMatrix(const std::vector<PlateElement>& elements, double bending,
                         const std::vector<double>& inverseMasses, double maxSquaredFrequency)
    : rows(inverseMasses.size()) {
  const std::vector<double> sums = bounds(elements, bending, inverseMasses);
  for (const PlateElement& element : elements) {
    double soft = 1;
    for (const PlateElement::Part& part : element.parts)
      if (sums[part.vertex] > maxSquaredFrequency)
        soft = std::min(soft, maxSquaredFrequency / sums[part.vertex]);
    if (soft < 1) ++softened;
    stiffnesses.push_back(bending * soft);
    for (std::size_t i = 0; i < element.parts.size(); ++i)
      for (std::size_t j = 0; j < element.parts.size(); ++j)
        if (i != j)
          rows[element.parts[i].vertex].emplace_back(element.parts[j].vertex,
                                                     bending * soft * entry(element, i, j));
  }
  for (PlateRow& row : rows) {
    std::stable_sort(row.begin(), row.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    PlateRow merged;
    for (const auto& [vertex, value] : row)
      if (!merged.empty() && merged.back().first == vertex)
        merged.back().second += value;
      else
        merged.emplace_back(vertex, value);
    row = std::move(merged);
  }
}

double plateFrequencySquared(const std::vector<PlateElement>& elements, double bending,
                             const std::vector<double>& inverseMasses, double share) {
  std::vector<double> sums = bounds(elements, bending, inverseMasses);
  sums.erase(std::remove(sums.begin(), sums.end(), 0.0), sums.end());
  std::sort(sums.begin(), sums.end());
  const auto last = static_cast<std::size_t>(share * static_cast<double>(sums.size()));
  return sums.empty() ? 0 : sums[std::min(last, sums.size() - 1)];
}

}  // namespace simreel::sim

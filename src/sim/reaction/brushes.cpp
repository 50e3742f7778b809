#include "sim/reaction/brushes.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "sim/core/collider.hpp"
#include "sim/reaction/plan.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace simreel::sim {

Brush brushAlong(const StrokeWay& way, double radius) {
  const glm::vec3 d = way.to - way.from;
  const float length2 = d.x * d.x + d.y * d.y + d.z * d.z;
  const auto reach = static_cast<float>(radius);
  return {way.from, way.to, reach * reach, length2 > 0 ? 1.0F / length2 : 0.0F};
}

// Returns the periodic images of a brush that can touch the volume. A cell is painted if any of the images
// covers it. The image nearest to a cell is at most half a volume away from it, so only images within that
// distance are considered.
std::vector<Brush> brushImages(const Brush& brush, glm::ivec3 size) {
  const double radius = std::sqrt(static_cast<double>(brush.radius2)) + 0.01;
  const glm::dvec3 sides(size);
  const glm::dvec3 reach = glm::min(glm::dvec3(radius), 0.5 * sides);
  const glm::ivec3 first(glm::floor((glm::dvec3(glm::min(brush.from, brush.to)) - reach) / sides));
  const glm::ivec3 last(glm::floor((glm::dvec3(glm::max(brush.from, brush.to)) + reach) / sides));
  std::vector<Brush> images;
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i) {
        const glm::dvec3 shift = glm::dvec3(i, j, k) * sides;
        Brush image = brush;
        image.from = glm::vec3(glm::dvec3(brush.from) - shift);
        image.to = glm::vec3(glm::dvec3(brush.to) - shift);
        images.push_back(image);
      }
  return images;
}

glm::ivec2 brushRange(const Brush& brush, int axis, int count) {
  const double radius = std::sqrt(static_cast<double>(brush.radius2)) + 1;
  const auto held = [&](double x) {
    return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(count)));
  };
  const int low = held(static_cast<double>(std::min(brush.from[axis], brush.to[axis])) - radius);
  const int high = held(static_cast<double>(std::max(brush.from[axis], brush.to[axis])) + radius + 1);
  return {low, std::max(high - low, 0)};
}

std::vector<StrokeWay> strokeLegs(const StrokeParameters& stroke) {
  if (!stroke.path) return {{stroke.from, stroke.to}};
  std::vector<StrokeWay> legs;
  const auto& keys = stroke.path->keys();
  for (std::size_t i = 0; i < keys.size(); ++i)
    legs.push_back({keys[i].value, keys[std::min(i + 1, keys.size() - 1)].value});
  return legs;
}

// Transforms a stroke's path from world space to mesh space, with the mesh's poses at `from` and `to`
// (seconds), and then to the coordinates of the cells, which are in units of length from the mesh's minimum
// corner.
Brush ReactionPlan::onMesh(StrokeWay way, float radius, double from, double to) const {
  const auto placed = [&](const glm::vec3& place, double time) {
    const glm::dmat3 turned(rotationMatrix(parameters_.mesh->rotation.at(time)));
    const glm::dvec3 offset = glm::dvec3(place) - glm::dvec3(parameters_.mesh->position.at(time));
    const glm::dvec3 own =
        glm::transpose(turned) * offset / static_cast<double>(parameters_.mesh->scale.at(time));
    return glm::vec3((own - cells_.low) * perMetre_);
  };
  way = {placed(way.from, from), placed(way.to, to)};
  const double scale = perMetre_ / static_cast<double>(parameters_.mesh->scale.at(to));
  return brushAlong(way, static_cast<double>(radius) * scale);
}

std::vector<ReactionPlan::Painted> ReactionPlan::brushesAt(double now, double seconds) const {
  std::vector<Painted> painted;
  for (std::size_t i = 0; i < parameters_.strokes.size(); ++i) {
    const ReactionStroke& stroke = parameters_.strokes[i];
    if (!isDue(stroke, now, seconds)) continue;
    const StrokeWay way = strokeWay(stroke, now, seconds);
    const bool goes = stroke.shape == StrokeParameters::Shape::circle && !paintsOnce(stroke);
    std::vector<Brush> brushes;
    if (onMesh_)
      brushes = {onMesh(way, stroke.radius, goes ? now - seconds : now, now)};
    else if (parameters_.boundary == RuleBoundary::torus)
      brushes = brushImages(brushAlong(way, static_cast<double>(stroke.radius)),
                            glm::ivec3(parameters_.size, parameters_.depth));
    else
      brushes = {brushAlong(way, static_cast<double>(stroke.radius))};
    const shader::Stroke paint = strokePaint(stroke, seed_, i, now, std::lround(now / seconds));
    for (const Brush& brush : brushes) painted.push_back({paint, parameters_.painted(stroke), brush});
  }
  return painted;
}

bool ReactionPlan::reaches(const Brush& brush) const {
  if (!onMesh_) {
    const glm::ivec3 size(parameters_.size, parameters_.depth);
    return brushRange(brush, 0, size.x).y > 0 && brushRange(brush, 1, size.y).y > 0 &&
           brushRange(brush, 2, size.z).y > 0;
  }
  return std::any_of(cells_.places.begin(), cells_.places.end(), [&](const glm::dvec3& place) {
    return shader::brushReaches(brush, glm::vec3((place - cells_.low) * perMetre_));
  });
}

// Checks the strokes. For strokes on a moving mesh or a periodic volume, it is not checked whether they
// touch a cell.
void ReactionPlan::checkBrushes(const std::string& object) const {
  const bool torus = !onMesh_ && parameters_.boundary == RuleBoundary::torus;
  const glm::dvec3 sides(parameters_.size, parameters_.depth);
  for (std::size_t i = 0; i < parameters_.strokes.size(); ++i) {
    const ReactionStroke& stroke = parameters_.strokes[i];
    double rounds = 0;
    bool reached =
        torus || (onMesh_ && (parameters_.mesh->position.moves() || parameters_.mesh->rotation.moves() ||
                              parameters_.mesh->scale.moves()));
    for (const StrokeWay& leg : strokeLegs(stroke)) {
      const glm::dvec3 way = glm::abs(glm::dvec3(leg.to) - glm::dvec3(leg.from)) / sides;
      rounds = std::max(rounds, way.x + way.y + way.z);
      reached = reached || reaches(onMesh_ ? onMesh(leg, stroke.radius, 0, 0)
                                           : brushAlong(leg, static_cast<double>(stroke.radius)));
    }
    if (torus && rounds > maxBrushRounds)
      fail(ExitCode::usage,
           "reaction \"{}\": strokes[{}] wraps around the torus of {} cells {:.0f} times at once, but at "
           "most {:.0f} are drawn; make it shorter",
           object, i, parameters_.cellsText(), rounds, maxBrushRounds);
    if (!reached)
      warn("reaction \"{}\": strokes[{}] paints nothing, it {}", object, i,
           onMesh_ ? "reaches no vertex of the mesh: places are m of the world"
                   : fmt::format("lies wholly outside the volume of {} cells", parameters_.cellsText()));
  }
}

void evaluateBrush(const ReactionPlan::Painted& painted, RuleField& field) {
  std::vector<float>& cells = field.stage[static_cast<std::size_t>(painted.species)];
  const std::size_t places = field.links != nullptr ? field.weights.size() - bindMaps : 0;
  for (int row = 0; row < field.rows(); ++row)
    for (int x = 0; x < field.size.x; ++x) {
      const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(field.size.x) +
                        static_cast<std::size_t>(x);
      glm::vec3 place = glm::vec3(x, row % field.size.y, row / field.size.y) + 0.5F;
      if (field.links != nullptr)
        place = {field.weights[places][cell], field.weights[places + 1][cell],
                 field.weights[places + 2][cell]};
      if (shader::strokePicks(painted.stroke, {x, row}) && shader::brushReaches(painted.brush, place))
        cells[cell] = painted.stroke.value;
    }
}

}  // namespace simreel::sim

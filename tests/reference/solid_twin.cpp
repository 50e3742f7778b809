#include "reference/solid_twin.hpp"

#include "sim/contour/border.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>

#define FUNCTION inline
#define precise
namespace simreel::shader {
#include "glsl/contour/model.glsl"
}
#undef precise
#undef FUNCTION

using namespace simreel;

SolidTwin::SolidTwin(const sim::SolidShape& shape, const std::function<float(int, int)>& value)
    : shape_(shape), value_(value), samples_(shape.size + 2) {
  for (int y = 0; y < samples_.y; ++y)
    for (int x = 0; x < samples_.x; ++x) {
      int reached = shape.outside;
      if (x > 0 && y > 0 && x <= shape.size.x && y <= shape.size.y) {
        reached = 0;
        for (const float level : shape.levels) reached += valueAt(x - 1, y - 1) >= level ? 1 : 0;
      }
      classes_.push_back(reached);
    }
  addCorners();
  addPoints();
  addSquares();
  for (const auto* part : {&sheets_, &walls_, &faces_})
    mesh.indices.insert(mesh.indices.end(), part->begin(), part->end());
}

float SolidTwin::valueAt(int x, int y) const {
  const float value = value_(std::clamp(x, 0, shape_.size.x - 1), std::clamp(y, 0, shape_.size.y - 1));
  return std::isfinite(value) ? std::clamp(value, -1e20F, 1e20F) : -1e20F;
}

int SolidTwin::classAt(int x, int y) const {
  return classes_[index(x, y)];
}

void SolidTwin::addCorners() {
  corners_ = static_cast<unsigned>(samples_.x * samples_.y);
  const glm::vec2 corner = sim::solidCorner(shape_);
  for (int layer = 0; layer <= (shape_.ceiling ? 1 : 0); ++layer)
    for (int y = 0; y < samples_.y; ++y)
      for (int x = 0; x < samples_.x; ++x) {
        const int height = shape_.ceiling ? layer : classAt(x, y);
        const glm::vec2 place = glm::vec2(x, y) * shape_.spacing + corner;
        mesh.positions.emplace_back(place.x, shape_.heights[static_cast<std::size_t>(height)], place.y);
        mesh.normals.emplace_back(0, layer == 0 ? 1 : -1, 0);
      }
  const auto first = static_cast<unsigned>(mesh.positions.size());
  const sim::SolidBorder border = sim::solidBorder(shape_, shape_.heights, first);
  mesh.positions.insert(mesh.positions.end(), border.positions.begin(), border.positions.end());
  mesh.normals.insert(mesh.normals.end(), border.normals.begin(), border.normals.end());
  mesh.indices = border.indices;
  firstPoint_ = static_cast<unsigned>(mesh.positions.size());
}

void SolidTwin::addPoints() {
  for (int y = 0; y < samples_.y; ++y)
    for (int x = 0; x < samples_.x; ++x)
      for (const glm::ivec2 along : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
        const glm::ivec2 end = glm::ivec2(x, y) + along;
        const bool there = end.x < samples_.x && end.y < samples_.y;
        const int from = classAt(x, y);
        const int to = there ? classAt(end.x, end.y) : from;
        const Edge edge{{x, y}, along, from, to, static_cast<unsigned>(lines.points.size())};
        (along.x > 0 ? right_ : down_).push_back(edge);
        for (int level = std::min(from, to) + 1; level <= std::max(from, to); ++level)
          addPoint(edge, level);
      }
  lines.next.assign(lines.points.size(), ~0U);
  walls_.assign(6 * lines.points.size(), 0);
}

void SolidTwin::addPoint(const Edge& edge, int level) {
  const glm::ivec2 cell = edge.at - 1;
  const glm::ivec2 next = cell + edge.along;
  const auto isWithin = [&](glm::ivec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x < shape_.size.x && at.y < shape_.size.y;
  };
  float part = 0.5F;
  glm::vec2 out(edge.to > edge.from ? -1 : 1, 0);  // Position of a crossing, with x across the edge and y
                                                   // along the edge.
  if (isWithin(cell) && isWithin(next)) {
    const glm::ivec2 side(edge.along.y, edge.along.x);
    const auto at = [&](glm::ivec2 place) { return valueAt(place.x, place.y); };
    part = shader::crossingPlace(at(cell), at(next), shape_.levels[static_cast<std::size_t>(level - 1)]);
    const float rise = 2.0F * (at(next) - at(cell)) + (at(next - side) - at(cell - side)) +
                       (at(next + side) - at(cell + side));
    const float turn = (at(cell + side) - at(cell - side)) + (at(next + side) - at(next - side));
    const float square = rise * rise + turn * turn;
    if (square >= 1e-20F && square <= 1e30F)
      out = glm::vec2(rise, turn) * -shader::exactInverseSqrt(square);
  }
  const glm::vec3 normal = edge.along.x > 0 ? glm::vec3(out.x, 0, out.y) : glm::vec3(out.y, 0, out.x);
  const glm::vec2 sample = glm::vec2(edge.at) + glm::vec2(edge.along) * part;
  const glm::vec2 corner = sim::solidCorner(shape_);
  const glm::vec2 place = sample * shape_.spacing + corner;
  const float low = shape_.heights[static_cast<std::size_t>(level - 1)];
  const float high = shape_.heights[static_cast<std::size_t>(level)];
  const float rim = shape_.ceiling ? -1 : 1;
  for (const auto& [height, n] : {std::pair{low, glm::vec3(0, 1, 0)}, std::pair{low, normal},
                                  std::pair{high, normal}, std::pair{high, glm::vec3(0, rim, 0)}}) {
    mesh.positions.emplace_back(place.x, height, place.y);
    mesh.normals.push_back(n);
  }
  lines.points.push_back((place - corner) / shape_.spacing - 1.0F);
  lines.levels.push_back(level);
}

/// Returns a side of the square at (x, y). `side`: index in the order right, down, left, up.
const SolidTwin::Edge& SolidTwin::edgeOf(int x, int y, int side) const {
  return side == 0   ? right_[index(x, y)]
         : side == 1 ? down_[index(x + 1, y)]
         : side == 2 ? right_[index(x, y + 1)]
                     : down_[index(x, y)];
}

void SolidTwin::addSquares() {
  for (int y = 0; y + 1 < samples_.y; ++y)
    for (int x = 0; x + 1 < samples_.x; ++x) {
      const int a = classAt(x, y);
      const unsigned me = static_cast<unsigned>(index(x, y));
      const auto row = static_cast<unsigned>(samples_.x);
      if (classAt(x + 1, y) != a || classAt(x, y + 1) != a || classAt(x + 1, y + 1) != a) {
        addWalls(x, y);
        addFaces(x, y);
        continue;
      }
      if (shape_.ceiling && a != 0) continue;
      sheets_.insert(sheets_.end(), {me, me + row, me + 1, me + 1, me + row, me + row + 1});
      if (!shape_.ceiling) continue;
      const unsigned up = me + corners_;
      sheets_.insert(sheets_.end(), {up, up + 1, up + row, up + row, up + 1, up + row + 1});
    }
}

/// Adds the contour segments and walls of a square. Visits the square's sides in order, up to twice. A
/// contour that enters at one side leaves at the next crossing of the same level.
void SolidTwin::addWalls(int x, int y) {
  const glm::ivec2 corners[] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
  const auto classOf = [&](int i) { return classAt(corners[i % 4].x, corners[i % 4].y); };
  for (int level = 1; level <= static_cast<int>(shape_.levels.size()); ++level)
    for (int in = 0; in < 4; ++in) {
      if (!(classOf(in) >= level && classOf(in + 1) < level)) continue;
      int out = in + 1;
      while (!(classOf(out) < level && classOf(out + 1) >= level)) ++out;
      const unsigned point = edgeOf(x, y, in).pointOf(level);
      const unsigned next = edgeOf(x, y, out % 4).pointOf(level);
      lines.next[point] = next;
      const unsigned right = firstPoint_ + 4 * point;
      const unsigned left = firstPoint_ + 4 * next;
      const unsigned wall[] = {left + 1, right + 1, right + 2, left + 1, right + 2, left + 2};
      std::copy(std::begin(wall), std::end(wall), walls_.begin() + 6 * point);
    }
}

void SolidTwin::addFaces(int x, int y) {
  const glm::ivec2 corners[] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
  const auto classOf = [&](int i) { return classAt(corners[i % 4].x, corners[i % 4].y); };
  const auto all = {classOf(0), classOf(1), classOf(2), classOf(3)};
  const int last = shape_.ceiling ? 0 : std::max(all);
  for (int c = std::min(all); c <= last; ++c) {
    const bool saddle = (classOf(0) > c) == (classOf(2) > c) && (classOf(1) > c) == (classOf(3) > c) &&
                        (classOf(0) > c) != (classOf(1) > c);
    const int start = saddle && classOf(0) <= c ? 1 : 0;
    std::vector<std::vector<unsigned>> polygons(1);
    for (int i = start; i < start + 4; ++i) {
      const int here = classOf(i);
      const int next = classOf(i + 1);
      if (here == c)
        polygons.back().push_back(static_cast<unsigned>(index(corners[i % 4].x, corners[i % 4].y)));
      const Edge& edge = edgeOf(x, y, i % 4);
      const auto lower = [&] { polygons.back().push_back(firstPoint_ + 4 * edge.pointOf(c) + 3); };
      const auto upper = [&] { polygons.back().push_back(firstPoint_ + 4 * edge.pointOf(c + 1)); };
      if (here < c && next >= c) lower();
      if (here > c && next <= c) {
        if (saddle) polygons.emplace_back();
        upper();
      }
      if (here <= c && next > c) upper();
      if (here >= c && next < c) lower();
    }
    for (const auto& polygon : polygons) addFace(polygon);
  }
}

void SolidTwin::addFace(const std::vector<unsigned>& face) {
  const auto lifted = [&](unsigned vertex) {
    return vertex < firstPoint_ ? vertex + corners_ : vertex + 3;
  };
  for (std::size_t i = 2; i < face.size(); ++i) {
    faces_.insert(faces_.end(), {face[0], face[i], face[i - 1]});
    if (shape_.ceiling)
      faces_.insert(faces_.end(), {lifted(face[0]), lifted(face[i - 1]), lifted(face[i])});
  }
}

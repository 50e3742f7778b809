#include "sim/grid/strokes.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "scene/value/implied_shape.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/grid/stroke_ways.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int maxStampSide = 8192;
constexpr double maxRounds =
    1000;  ///< Maximum number of times that a stroke's path may wrap around a periodic grid.
constexpr double maxStampImages = 4096;  ///< Maximum number of periodic copies of a stroke that paints an
                                         ///< image.

glm::vec2 flat(const glm::vec3& p) {
  return {p.x, p.y};
}

/// Returns the start and end, as fractions of a segment, of that part of the segment whose coordinate on
/// one axis is within [low, high]. If there is no such part, the start is greater than the end.
glm::dvec2 fractionsWithin(double from, double to, double low, double high) {
  if (from == to) return from >= low && from <= high ? glm::dvec2(0, 1) : glm::dvec2(1, 0);
  const double a = (low - from) / (to - from);
  const double b = (high - from) / (to - from);
  return {std::max(0.0, std::min(a, b)), std::min(1.0, std::max(a, b))};
}

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 d = b - a;
  const double length2 = d.x * d.x + d.y * d.y;
  const double along = length2 > 0 ? ((p.x - a.x) * d.x + (p.y - a.y) * d.y) / length2 : 0;
  const glm::dvec2 q = p - a - d * std::clamp(along, 0.0, 1.0);
  return std::hypot(q.x, q.y);
}

/// Returns the distance from a segment to the rectangle spanned by the centres of the grid's cells.
double distanceToCells(glm::dvec2 a, glm::dvec2 b, glm::ivec2 size) {
  const glm::dvec2 low(0.5);
  const glm::dvec2 high = glm::dvec2(size) - 0.5;
  const glm::dvec2 across = fractionsWithin(a.x, b.x, low.x, high.x);
  const glm::dvec2 down = fractionsWithin(a.y, b.y, low.y, high.y);
  if (std::max(across.x, down.x) <= std::min(across.y, down.y)) return 0;
  double nearest = 1e300;
  for (const glm::dvec2& end : {a, b}) {
    const glm::dvec2 inside(std::clamp(end.x, low.x, high.x), std::clamp(end.y, low.y, high.y));
    nearest = std::min(nearest, std::hypot(end.x - inside.x, end.y - inside.y));
  }
  for (const glm::dvec2& corner : {low, high, glm::dvec2(low.x, high.y), glm::dvec2(high.x, low.y)})
    nearest = std::min(nearest, distanceToSegment(corner, a, b));
  return nearest;
}

}  // namespace

void StrokeParameters::describe(scene::Fields& f, double max, const char* valueDoc) {
  f.choice("shape", shape, {"circle", "line", "image"},
           "A circle that may move, a line, or the light pixels of an image.");
  f.number("at", at, scene::anyNumber, "s",
           "Time at which the stroke begins; the first state at this time or later has it.");
  f.leftOut("at", "0; in version 2 with \"until\" the start of the run");
  f.number("until", until, scene::anyNumber, "s", "When it ends; not after \"at\": it paints once.");
  early = f.version() > 1 && !f.given("at") && until > at;
  f.vector("from", from, {-1e6, 1e6}, "cells",
           "Middle of the circle, start of the line, or top left of the image; the third number counts "
           "only in volumes.");
  f.vector("to", to, {-1e6, 1e6}, "cells", "Place that the circle moves to, or the end of the line.");
  f.leftOut("to", "\"from\"");
  if (!f.given("to")) to = from;
  f.optionalValue("path", path, scene::Animated<glm::vec3>(), [&](scene::Animated<glm::vec3>& keys) {
    f.vector("path", keys, {-1e6, 1e6}, "cells",
             "Place of the circle, by keyframes; the third number counts only in volumes.");
  });
  f.leftOut("path", "from \"from\" to \"to\"");
  if (path && (f.given("from") || f.given("to")))
    f.error("path", "the path says where the circle is; leave out \"from\" and \"to\"");
  f.number("radius", radius, {0, 1e5}, "cells", "Radius of the circle; half the width of the line.");
  f.asset("image", image, "Picture of shape \"image\"; its light pixels are painted.");
  scene::implyShape(f, shape, Shape::image, "image", image, "image", "circle");
  if (path && shape != Shape::circle) f.error("path", "only a circle has a path");
  f.idleUnless(shape != Shape::image, f.given("shape") ? "shape" : "image", {"radius", "to"},
               "a \"circle\" or a \"line\"");
  f.number("value", value, {0, max}, "", valueDoc);
  f.formerly("share", "fraction");
  f.number("fraction", fraction, {0, 1}, "",
           "Fraction of the cells within reach that are painted, picked at random.");
  if (shape == Shape::image && image.empty())
    f.error("shape", "shape \"image\" needs \"image\", a picture");
}

glm::vec2 StrokeParameters::placeAt(double time) const {
  return flat(strokePlace(*this, time));
}

glm::vec3 strokePlace(const StrokeParameters& p, double time) {
  if (p.path) return p.path->at(time);
  const double part = p.until > p.at ? std::clamp((time - p.at) / (p.until - p.at), 0.0, 1.0) : 0.0;
  glm::vec3 place;
  for (int i = 0; i < 3; ++i) place[i] = static_cast<float>(p.from[i] + part * (p.to[i] - p.from[i]));
  return place;
}

// `time` is a multiple of the step except for rounding. The state at `time` covers the step that ends
// there. Both ends are shifted by a small tolerance, so that rounding does not move a stroke to another
// step.
bool isDue(const StrokeParameters& p, double time, double seconds) {
  const double hair = 1e-6 * seconds;
  return (p.early || p.at <= time + hair) && (paintsOnce(p) ? p.at : p.until) > time - seconds + hair;
}

StrokeWay strokeWay(const StrokeParameters& p, double time, double seconds) {
  if (p.shape != StrokeParameters::Shape::circle) return {p.from, p.to};
  const double before = time - seconds;
  const auto held = [&](double t) { return std::clamp(t, p.at, std::max(p.at, p.until)); };
  return {strokePlace(p, p.path ? held(paintsOnce(p) ? p.at : before) : before),
          strokePlace(p, p.path ? held(paintsOnce(p) ? p.at : time) : time)};
}

shader::Stroke strokePaint(const StrokeParameters& p, int seed, std::size_t index, double time, long step) {
  shader::Stroke s{};
  s.value = static_cast<float>(p.value * static_cast<double>(p.strength.at(time)));
  s.seed = static_cast<int>(static_cast<unsigned>(seed) * 7919U + static_cast<unsigned>(index) * 104729U +
                            static_cast<unsigned>(step) * 15485863U);
  s.picked = static_cast<int>(std::lround(static_cast<double>(p.fraction) * 16777216.0));
  return s;
}

Strokes::Strokes(std::vector<StrokeParameters> strokes, int seed, StrokeGrid grid)
    : strokes_(std::move(strokes)), seed_(seed), grid_(std::move(grid)) {
  for (const StrokeParameters& stroke : strokes_) {
    Stamp& stamp = stamps_.emplace_back();
    if (stroke.shape != StrokeParameters::Shape::image) continue;
    const Picture picture = loadPicture(stroke.image, "brush image", maxStampSide);
    stamp.firstWord = static_cast<int>(bits_.size());
    stamp.size = picture.size;
    const auto pixels = static_cast<std::size_t>(picture.size.x) * static_cast<std::size_t>(picture.size.y);
    bits_.resize(bits_.size() + (pixels + 31) / 32);
    for (std::size_t i = 0; i < pixels; ++i) {
      const auto width = static_cast<std::size_t>(picture.size.x);
      if (picture.level(static_cast<int>(i % width), static_cast<int>(i / width)) > 127)
        bits_[static_cast<std::size_t>(stamp.firstWord) + i / 32] |= 1U << (i % 32);
    }
  }
  bits_.resize((bits_.size() + 4) / 4 * 4);  // Pads to whole elements of four words, with at least one word
                                             // of padding.
  for (std::size_t i = 0; i < strokes_.size(); ++i) check(i);
}

void Strokes::check(std::size_t index) const {
  const StrokeParameters& p = strokes_[index];
  const glm::dvec2 size(grid_.size);
  const bool isStamp = p.shape == StrokeParameters::Shape::image;
  const glm::dvec2 from(flat(p.from));
  const bool stays = p.shape == StrokeParameters::Shape::circle && !(p.until > p.at);
  const glm::dvec2 to = stays ? from : glm::dvec2(flat(p.to));
  const glm::dvec2 stamp(stamps_[index].size);
  // Segments of the path between consecutive keyframes.
  std::vector<std::pair<glm::dvec2, glm::dvec2>> legs = {{from, to}};
  if (p.path) {
    legs.clear();
    const auto& keys = p.path->keys();
    for (std::size_t i = 0; i < keys.size(); ++i)
      legs.emplace_back(flat(keys[i].value), flat(keys[std::min(i + 1, keys.size() - 1)].value));
  }
  if (grid_.torus) {
    double rounds = 0;
    for (const auto& [a, b] : legs) rounds += std::abs(b.x - a.x) / size.x + std::abs(b.y - a.y) / size.y;
    const double images = (stamp.x / size.x + 2) * (stamp.y / size.y + 2);
    if (isStamp ? images > maxStampImages : rounds > maxRounds)
      fail(ExitCode::usage,
           "{}: strokes[{}] wraps around the torus of {} x {} cells {:.0f} times, but at most {:.0f} are "
           "drawn; make it shorter",
           grid_.object, index, grid_.size.x, grid_.size.y, isStamp ? images : rounds,
           isStamp ? maxStampImages : maxRounds);
    return;
  }
  const glm::dvec2 corner(std::floor(from.x), std::floor(from.y));
  const bool outside =
      isStamp
          ? corner.x >= size.x || corner.y >= size.y || corner.x + stamp.x <= 0 || corner.y + stamp.y <= 0
          : std::all_of(legs.begin(), legs.end(), [&](const auto& leg) {
              return distanceToCells(leg.first, leg.second, grid_.size) > static_cast<double>(p.radius);
            });
  if (outside)
    warn("{}: strokes[{}] paints nothing, it lies wholly outside the grid of {} x {} cells", grid_.object,
         index, grid_.size.x, grid_.size.y);
}

std::vector<shader::Stroke> Strokes::into(double time, double seconds, long step,
                                          std::vector<int>* numbers) const {
  std::vector<shader::Stroke> active;
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const StrokeParameters& p = strokes_[i];
    if (!isDue(p, time, seconds)) continue;
    const StrokeWay way = strokeWay(p, time, seconds);
    const glm::vec2 from = flat(way.from), to = flat(way.to);
    const glm::vec2 d = to - from;
    const float length2 = d.x * d.x + d.y * d.y;
    shader::Stroke s = strokePaint(p, seed_, i, time, step);
    s.from = from;
    s.to = to;
    s.radius2 = p.radius * p.radius;
    s.perLength2 = length2 > 0 ? 1.0F / length2 : 0.0F;
    s.imageWord = stamps_[i].firstWord;
    s.imageFrom = glm::ivec2(glm::floor(flat(p.from)));
    s.imageSize = stamps_[i].size;
    addImages(active, s);
    if (numbers != nullptr) numbers->resize(active.size(), static_cast<int>(i));
  }
  return active;
}

// Adds the periodic images of a stroke. On a periodic grid, a cell is painted if any of the images covers
// it. The nearest image is at most half a grid away from the point of the segment that is nearest to the
// cell. Therefore, only those images are added whose cells, extended by the radius or half a grid,
// intersect the segment.
void Strokes::addImages(std::vector<shader::Stroke>& all, const shader::Stroke& stroke) const {
  if (!grid_.torus) {
    all.push_back(stroke);
    return;
  }
  const glm::dvec2 size(grid_.size);
  glm::dvec2 a(stroke.from);
  glm::dvec2 b(stroke.to);
  glm::dvec2 reach =
      glm::min(glm::dvec2(std::sqrt(static_cast<double>(stroke.radius2)) + 0.01), size * 0.5);
  if (stroke.imageSize.x > 0) {
    reach = 0.5 * glm::dvec2(stroke.imageSize);
    a = b = glm::dvec2(stroke.imageFrom) + reach;
  }
  const auto first = [](double low, double side) { return static_cast<int>(std::floor(low / side)); };
  const int lastColumn = first(std::max(a.x, b.x) + reach.x, size.x);
  for (int i = first(std::min(a.x, b.x) - reach.x, size.x); i <= lastColumn; ++i) {
    const glm::dvec2 fractions =
        fractionsWithin(a.x, b.x, i * size.x - reach.x, (i + 1) * size.x + reach.x);
    if (fractions.x > fractions.y) continue;
    const double y0 = a.y + fractions.x * (b.y - a.y);
    const double y1 = a.y + fractions.y * (b.y - a.y);
    const int lastRow = first(std::max(y0, y1) + reach.y, size.y);
    for (int j = first(std::min(y0, y1) - reach.y, size.y); j <= lastRow; ++j) {
      const glm::dvec2 shift = glm::dvec2(i, j) * size;
      shader::Stroke image = stroke;
      image.from = glm::dvec2(stroke.from) - shift;
      image.to = glm::dvec2(stroke.to) - shift;
      image.imageFrom -= glm::ivec2(shift);
      all.push_back(image);
    }
  }
}

bool Strokes::paints(const shader::Stroke& s, glm::ivec2 cell) const {
  if (!shader::strokePicks(s, cell)) return false;
  if (s.imageSize.x == 0) return shader::strokeReaches(s, cell);
  const glm::ivec2 at = cell - s.imageFrom;
  if (at.x < 0 || at.y < 0 || at.x >= s.imageSize.x || at.y >= s.imageSize.y) return false;
  const auto bit = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(s.imageSize.x) +
                   static_cast<std::size_t>(at.x);
  return (bits_[static_cast<std::size_t>(s.imageWord) + bit / 32] >> (bit % 32) & 1U) != 0;
}

glm::ivec4 Strokes::box(const shader::Stroke& s, glm::ivec2 grid) {
  glm::vec2 low(s.imageFrom);
  glm::vec2 high = low + glm::vec2(s.imageSize);
  if (s.imageSize.x == 0) {
    const float radius = std::sqrt(s.radius2) + 1.0F;
    low = glm::min(s.from, s.to) - radius;
    high = glm::max(s.from, s.to) + radius;
  }
  const auto first = [](float x, int max) {
    return static_cast<int>(std::clamp(std::floor(x), 0.0F, static_cast<float>(max)));
  };
  const glm::ivec2 a(first(low.x, grid.x), first(low.y, grid.y));
  const glm::ivec2 b(first(high.x + 1, grid.x), first(high.y + 1, grid.y));
  if (b.x <= a.x || b.y <= a.y) return {0, 0, 0, 0};
  return {a.x, a.y, b.x - a.x, b.y - a.y};
}

StrokeMembers uniformsOf(const shader::Stroke& stroke) {
  return {.from = stroke.from,
          .to = stroke.to,
          .radius2 = stroke.radius2,
          .perLength2 = stroke.perLength2,
          .value = stroke.value,
          .seed = stroke.seed,
          .picked = stroke.picked,
          .imageWord = stroke.imageWord,
          .imageFrom = stroke.imageFrom,
          .imageSize = stroke.imageSize};
}

StrokeUniforms uniformsOf(const shader::Stroke& stroke, glm::ivec4 box) {
  return {.stroke = uniformsOf(stroke), .box = box};
}

std::vector<glm::uvec4> Strokes::imageElements() const {
  std::vector<glm::uvec4> elements;
  for (std::size_t i = 0; i + 3 < bits_.size(); i += 4)
    elements.emplace_back(bits_[i], bits_[i + 1], bits_[i + 2], bits_[i + 3]);
  return elements;
}

}  // namespace simreel::sim

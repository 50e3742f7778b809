#include "sim/strokes.hpp"

#include "base/error.hpp"
#include "sim/picture_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int mostStampSide = 8192;

glm::vec2 flat(const glm::vec3& p) {
  return {p.x, p.y};
}

}  // namespace

void StrokeParameters::describe(scene::Fields& f, double most, const char* valueDoc) {
  f.choice("shape", shape, {"circle", "line", "image"},
           "A circle that may move, a line, or the light pixels of an image.");
  f.number("at", at, scene::anyNumber, "s", "When it begins.");
  f.number("until", until, scene::anyNumber, "s", "When it ends; not after \"at\": it paints once.");
  f.vector("from", from, {-1e6, 1e6}, "cells",
           "Middle of the circle, start of the line, or top left of the image; the third is unused.");
  f.vector("to", to, {-1e6, 1e6}, "cells", "Where the circle moves to, or the line's end.");
  if (!f.given("to")) to = from;
  f.number("radius", radius, {0, 1e5}, "cells", "Of the circle; half the width of the line.");
  f.asset("image", image, "Picture of shape \"image\"; its light pixels are painted.");
  f.number("value", value, {0, most}, "", valueDoc);
  f.number("share", share, {0, 1}, "", "Of the cells within reach, picked at random.");
  if (shape == Shape::image && image.empty())
    f.error("shape", "shape \"image\" needs \"image\", a picture");
}

Strokes::Strokes(std::vector<StrokeParameters> strokes, int seed)
    : strokes_(std::move(strokes)), seed_(seed) {
  for (const StrokeParameters& stroke : strokes_) {
    Stamp& stamp = stamps_.emplace_back();
    if (stroke.shape != StrokeParameters::Shape::image) continue;
    const Picture picture = loadPicture(stroke.image, "brush image", mostStampSide);
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
  bits_.resize((bits_.size() + 4) / 4 * 4);  // whole elements, at least one
}

std::vector<shader::Stroke> Strokes::during(double time, double seconds, long step) const {
  std::vector<shader::Stroke> active;
  const double end = time + seconds;
  // Times are multiples of the step but for rounding: a step owns [time, end) shifted by a hair.
  const double hair = 1e-6 * seconds;
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const StrokeParameters& p = strokes_[i];
    const bool once = !(p.until > p.at);
    const bool starts = p.at >= time - hair && p.at < end - hair;
    if (once ? !starts : !(p.at < end - hair && p.until > time + hair)) continue;
    glm::vec2 from = flat(p.from);
    glm::vec2 to = flat(p.to);
    if (p.shape == StrokeParameters::Shape::circle) {
      const auto placeAt = [&](double t) {
        const double share = once ? 0.0 : std::clamp((t - p.at) / (p.until - p.at), 0.0, 1.0);
        const glm::vec2 a = flat(p.from);
        const glm::vec2 b = flat(p.to);
        return glm::vec2(static_cast<float>(a.x + share * (b.x - a.x)),
                         static_cast<float>(a.y + share * (b.y - a.y)));
      };
      from = placeAt(time);
      to = placeAt(end);
    }
    const glm::vec2 d = to - from;
    const float length2 = d.x * d.x + d.y * d.y;
    shader::Stroke s{};
    s.segment = glm::vec4(from, to);
    s.shape =
        glm::vec4(p.radius * p.radius, length2 > 0 ? 1.0F / length2 : 0.0F, static_cast<float>(p.value), 0);
    const Stamp& stamp = stamps_[i];
    s.image = glm::ivec4(static_cast<int>(std::floor(p.from.x)), static_cast<int>(std::floor(p.from.y)),
                         stamp.firstWord, stamp.size.x);
    s.random = glm::ivec4(
        static_cast<int>(static_cast<unsigned>(seed_) * 7919U + static_cast<unsigned>(i) * 104729U +
                         static_cast<unsigned>(step) * 15485863U),
        static_cast<int>(std::lround(static_cast<double>(p.share) * 16777216.0)), stamp.size.y, 0);
    active.push_back(s);
  }
  return active;
}

bool Strokes::paints(const shader::Stroke& s, glm::ivec2 cell) const {
  if (!shader::strokePicks(s, cell)) return false;
  if (s.image.w == 0) return shader::strokeReaches(s, cell);
  const int x = cell.x - s.image.x;
  const int y = cell.y - s.image.y;
  if (x < 0 || y < 0 || x >= s.image.w || y >= s.random.z) return false;
  const auto bit =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(s.image.w) + static_cast<std::size_t>(x);
  return (bits_[static_cast<std::size_t>(s.image.z) + bit / 32] >> (bit % 32) & 1U) != 0;
}

glm::ivec4 Strokes::box(const shader::Stroke& s, glm::ivec2 grid) {
  glm::vec2 low(s.image.x, s.image.y);
  glm::vec2 high = low + glm::vec2(s.image.w, s.random.z);
  if (s.image.w == 0) {
    const float radius = std::sqrt(s.shape.x) + 1.0F;
    low = glm::min(glm::vec2(s.segment.x, s.segment.y), glm::vec2(s.segment.z, s.segment.w)) - radius;
    high = glm::max(glm::vec2(s.segment.x, s.segment.y), glm::vec2(s.segment.z, s.segment.w)) + radius;
  }
  const auto first = [](float x, int most) {
    return static_cast<int>(std::clamp(std::floor(x), 0.0F, static_cast<float>(most)));
  };
  const glm::ivec2 a(first(low.x, grid.x), first(low.y, grid.y));
  const glm::ivec2 b(first(high.x + 1, grid.x), first(high.y + 1, grid.y));
  if (b.x <= a.x || b.y <= a.y) return {0, 0, 0, 0};
  return {a.x, a.y, b.x - a.x, b.y - a.y};
}

void setStroke(const gl::Program& program, const shader::Stroke& stroke, glm::ivec4 box) {
  program.set("strokeSegment", stroke.segment);
  program.set("strokeShape", stroke.shape);
  program.set("strokeImage", stroke.image);
  program.set("strokeRandom", stroke.random);
  program.set("strokeBox", box);
}

}  // namespace simreel::sim

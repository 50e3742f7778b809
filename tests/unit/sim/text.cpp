// Tests text: its content, its layout, and the solids made from its outlines.
#include "base/file.hpp"
#include "sim/text/content.hpp"
#include "sim/text/letters/layout.hpp"
#include "sim/text/solid_text.hpp"
#include "unit/frame/help.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;
using namespace simreel::sim;
using simreel::frame::test::contains;
using simreel::frame::test::errorOf;

namespace {

std::filesystem::path shipped(const char* name) {
  return assetFolder() / "fonts" / name;
}

double areaOf(const TextOutlines& outlines) {
  double area = 0;
  for (const auto& polygon : outlines)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      area += 0.5 * (a.x * b.y - a.y * b.x);
    }
  return std::abs(area);
}

double areaOf(const std::vector<Trapezoid>& parts) {
  double area = 0;
  for (const Trapezoid& part : parts)
    area += 0.5 * (part.top - part.bottom) *
            (part.bottomRight - part.bottomLeft + part.topRight - part.topLeft);
  return area;
}

/// Returns the volume of a closed mesh, by the divergence theorem.
double volumeOf(const Mesh& mesh) {
  double volume = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
        c(mesh.positions[mesh.indices[i + 2]]);
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return volume;
}

/// Returns the number of edges without exactly one triangle on each side. Edges are compared by position,
/// not by vertex.
int openEdges(const Mesh& mesh) {
  using Place = std::array<float, 3>;
  std::map<std::pair<Place, Place>, int> edges;
  const auto place = [&](unsigned i) {
    const glm::vec3& p = mesh.positions[i];
    return Place{p.x, p.y, p.z};
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[{place(mesh.indices[i + k]), place(mesh.indices[i + (k + 1) % 3])}];
  int open = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second != count) ++open;
  }
  return open;
}

std::string mistakeOf(const char* text) {
  try {
    TextContent content(text);
  } catch (const std::invalid_argument& mistake) {
    return mistake.what();
  }
  return {};
}

}  // namespace

TEST_CASE("text: placeholders for frame, time and quantities are replaced") {
  const auto measured = [](const std::string& object, const std::string& quantity) {
    CHECK(object == "wild.fire");
    return quantity == "burnt" ? 1234567.0 : -0.0;
  };
  CHECK(TextContent("frame {frame}").at(12, 0.5, {}) == "frame 12");
  CHECK(TextContent("t = {time} s, {time:0}, {time:3}").at(12, 0.5, {}) == "t = 0.50 s, 0, 0.500");
  CHECK(TextContent("{wild.fire.burnt}|{wild.fire.burnt:1}|{wild.fire.x:1}").at(0, 0, measured) ==
        "1.23457e+06|1234567.0|0.0");
  CHECK(TextContent("{{{frame}}}").at(3, 0, {}) == "{3}");
  CHECK(TextContent("").at(3, 0, {}).empty());
  CHECK_FALSE(TextContent("plain").changes());
  CHECK(contains(mistakeOf("a {frame"), "never closed"));
  CHECK(contains(mistakeOf("{frames}"), "use {frame}, {time}"));
  CHECK(contains(mistakeOf("{time:x}"), "0 to 9"));
  CHECK(contains(mistakeOf("{time:10}"), "0 to 9"));
  CHECK(contains(mistakeOf("{.x}"), "is unknown"));
}

TEST_CASE("text: sizes are in cap heights, and lines are aligned as requested") {
  Font font(shipped("OpenSans-Bold.ttf"));
  double top = 0;
  for (const auto& polygon : font.glyph(U'H').outlines)
    for (const glm::dvec2& point : polygon) top = std::max(top, point.y);
  CHECK(top == doctest::Approx(1));
  CHECK(font.has(U'é'));
  CHECK_FALSE(font.has(U'雪'));
  CHECK(font.kerning(U'A', U'V') < -0.01);  // Kerning moves A and V closer together.
  CHECK(font.kerning(U'H', U'H') == 0);
  const auto box = [&](const TextAnchor& anchor) {
    std::pair<glm::dvec2, glm::dvec2> found{glm::dvec2(1e9), glm::dvec2(-1e9)};
    for (const auto& polygon : written(font, "HIH\nH", anchor, 1))
      for (const glm::dvec2& point : polygon)
        found = {glm::min(found.first, point), glm::max(found.second, point)};
    return found;
  };
  using Across = TextAnchor::Across;
  using Down = TextAnchor::Down;
  const double line = font.lineHeight();
  CHECK(box({Across::left, Down::baseline}).second.y == doctest::Approx(1));
  CHECK(box({Across::left, Down::baseline}).first.y == doctest::Approx(-line));
  CHECK(box({Across::left, Down::top}).second.y == doctest::Approx(0).scale(1));
  CHECK(box({Across::left, Down::bottom}).first.y == doctest::Approx(0).scale(1));
  const auto middle = box({Across::center, Down::middle});
  CHECK(middle.first.y == doctest::Approx(-middle.second.y));
  // The box is centred, except for the side bearings of the letters.
  CHECK(middle.first.x == doctest::Approx(-middle.second.x).epsilon(0.02));
  CHECK(box({Across::left, Down::top}).first.x > 0);
  CHECK(box({Across::right, Down::top}).second.x < 0);
}

TEST_CASE("text: trapezoids fill the inside of outlines exactly once") {
  for (const char* name : {"OpenSans-Bold.ttf", "OpenSans-Regular.ttf"}) {
    Font font(shipped(name));
    for (const char32_t character : std::u32string(U"simreel 0123456789 %&@gQR8BäøÆ§Ω")) {
      const TextOutlines& outlines = font.glyph(character).outlines;
      CAPTURE(static_cast<unsigned>(character));
      CHECK(areaOf(trapezoids(outlines)) == doctest::Approx(areaOf(outlines)).epsilon(1e-9));
    }
  }
  // Two overlapping squares are filled once, and a hole stays empty.
  const TextOutlines squares = {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}};
  CHECK(areaOf(trapezoids(squares)) == doctest::Approx(7));
  const TextOutlines ring = {{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}};
  CHECK(areaOf(trapezoids(ring)) == doctest::Approx(8));
  // The sides of a bow tie cross away from its corners.
  CHECK(areaOf(trapezoids({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}})) == doctest::Approx(2));
}

TEST_CASE("text: letters are closed solids with volume area times depth, facing outwards") {
  for (const char* name : {"OpenSans-Bold.ttf", "OpenSans-Regular.ttf"}) {
    Font font(shipped(name));
    for (const char* text : {"simreel", "gQ8&%@\n8BR$", "AV. Äö"}) {
      CAPTURE(text);
      const TextOutlines outlines = written(font, text, {}, 1);
      const Mesh mesh = solidText(outlines, 0.7, 0.3);
      CHECK(openEdges(mesh) == 0);
      CHECK(volumeOf(mesh) == doctest::Approx(0.3 * 0.49 * areaOf(outlines)).epsilon(1e-4));
      for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        CHECK(glm::length(mesh.normals[i]) == doctest::Approx(1).epsilon(1e-5));
      // Normals agree with the orientation of the triangles.
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]); };
        const glm::dvec3 way = glm::cross(at(1) - at(0), at(2) - at(0));
        if (glm::length(way) < 1e-12) continue;
        CHECK(glm::dot(way, glm::dvec3(mesh.normals[mesh.indices[i]])) > 0);
      }
      const Mesh flat = solidText(outlines, 0.7, 0);
      for (const glm::vec3& position : flat.positions) CHECK(position.z == 0);
    }
  }
  CHECK(solidText({}, 1, 1).indices.empty());
}

TEST_CASE("text: invalid fonts and missing characters are refused") {
  CHECK(contains(errorOf([] { Font font(assetFolder() / "scenes" / "flag.json"); }).second,
                 "it is no TrueType or OpenType file"));
  const Font font(shipped("OpenSans-Bold.ttf"));
  CHECK(contains(errorOf([&] { checkWritable(font, "a\n雪"); }).second, "the font has no \"雪\" (U+96EA)"));
  CHECK(contains(errorOf([&] { checkWritable(font, "a\xff"); }).second, "not UTF-8"));
}

#include "frame/file/contour_file.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::frame {

namespace {

/// True if b lies on the straight segment from a to c.
bool isBetween(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
  const glm::dvec2 first(glm::dvec2(b) - glm::dvec2(a));
  const glm::dvec2 second(glm::dvec2(c) - glm::dvec2(b));
  return first.x * second.y == first.y * second.x && first.x * second.x + first.y * second.y > 0;
}

std::vector<glm::vec2> withoutStraight(const std::vector<glm::vec2>& points) {
  std::vector<glm::vec2> kept;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i)
    if (!isBetween(points[(i + count - 1) % count], points[i], points[(i + 1) % count]))
      kept.push_back(points[i]);
  return kept;
}

}  // namespace

std::vector<ContourLoop> contourLoops(const sim::ContourLines& lines) {
  std::vector<ContourLoop> loops;
  std::vector<bool> taken(lines.points.size(), false);
  for (std::size_t first = 0; first < lines.points.size(); ++first) {
    if (taken[first]) continue;
    std::vector<glm::vec2> points;
    for (std::size_t i = first; !taken[i]; i = lines.next[i]) {
      taken[i] = true;
      points.push_back(lines.points[i]);
    }
    loops.push_back({lines.levels[first], withoutStraight(points)});
  }
  return loops;
}

std::string encodeSvg(const sim::ContourLines& lines, glm::ivec2 size,
                      std::span<const std::string> comments) {
  std::string text;
  const auto out = std::back_inserter(text);
  // The centre of cell (x, y) is at (x, y), so the view box from -1 to `size` leaves a margin of half a
  // cell.
  fmt::format_to(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-1 -1 {} {}\">\n", size.x + 1,
                 size.y + 1);
  for (std::string comment : comments) {
    std::replace(comment.begin(), comment.end(), '-', '_');  // "--" would end the SVG comment.
    fmt::format_to(out, "<!-- {} -->\n", comment);
  }
  const std::vector<ContourLoop> loops = contourLoops(lines);
  int levels = 0;
  for (const ContourLoop& loop : loops) levels = std::max(levels, loop.level);
  for (int level = 1; level <= levels; ++level) {
    fmt::format_to(out,
                   "<path id=\"level{}\" fill=\"#604830\" fill-opacity=\"0.35\" fill-rule=\"evenodd\" "
                   "stroke=\"#302010\" stroke-width=\"0.1\" d=\"",
                   level);
    for (const ContourLoop& loop : loops) {
      if (loop.level != level || loop.points.empty()) continue;
      const char* command = "M";
      for (const glm::vec2& p : loop.points)
        fmt::format_to(out, "{}{} {}", std::exchange(command, " L"), p.x, p.y);
      text += " Z ";
    }
    text += "\"/>\n";
  }
  text += "</svg>\n";
  return text;
}

std::string encodeGeoJson(const sim::ContourLines& lines, std::span<const glm::vec2> path,
                          std::span<const std::string> comments) {
  using Json = nlohmann::ordered_json;
  const auto pointOf = [](glm::vec2 p) { return Json::array({p.x, 0.0F - p.y}); };
  Json features = Json::array();
  const auto add = [&](Json coordinates, const char* type, Json properties) {
    features.push_back({{"type", "Feature"},
                        {"properties", std::move(properties)},
                        {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}});
  };
  for (const ContourLoop& loop : contourLoops(lines)) {
    if (loop.points.empty()) continue;
    Json coordinates = Json::array();
    for (const glm::vec2& p : loop.points) coordinates.push_back(pointOf(p));
    coordinates.push_back(pointOf(loop.points.front()));
    add(std::move(coordinates), "LineString", {{"level", loop.level}});
  }
  for (std::size_t i = 0; i < lines.rooms.size(); ++i) {
    const sim::Room& room = lines.rooms[i];
    add(pointOf(glm::vec2(room.centre)), "Point",
        {{"room", i + 1}, {"cells", room.cells}, {"area", room.area}});
  }
  if (path.size() > 1) {
    Json coordinates = Json::array();
    for (const glm::vec2& p : path) coordinates.push_back(pointOf(p));
    add(std::move(coordinates), "LineString", {{"path", true}});
    add(pointOf(path.front()), "Point", {{"name", "entrance"}});
    add(pointOf(path.back()), "Point", {{"name", "exit"}});
  }
  const Json document = {{"type", "FeatureCollection"},
                         {"comments", std::vector<std::string>(comments.begin(), comments.end())},
                         {"features", std::move(features)}};
  return document.dump(1) + "\n";
}

}  // namespace simreel::frame

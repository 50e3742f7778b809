#pragma once
#include "base/file.hpp"
#include "source_folder.hpp"

#include <array>
#include <regex>
#include <string>

#include <doctest/doctest.h>
#include <glm/vec2.hpp>

/// Parses the points in glsl/draw/exact/shadows/disc_points.glsl, because C++ cannot compile that array.
inline std::array<glm::vec2, 32> pointsOfFile() {
  std::array<glm::vec2, 32> points{};
  const std::string text =
      simreel::readFile(sourceFolder() + "/glsl/draw/exact/shadows/disc_points.glsl", "points");
  const std::regex point(R"(vec2\((-?[0-9.]+)f, (-?[0-9.]+)f\))");
  std::size_t found = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), point), end; i != end; ++i, ++found)
    points.at(found) = glm::vec2(std::stof((*i)[1]), std::stof((*i)[2]));
  REQUIRE(found == points.size());
  return points;
}
inline const std::array<glm::vec2, 32>& discPoints() {
  static const std::array<glm::vec2, 32> points = pointsOfFile();
  return points;
}

// Tests the colour maps by comparison with the published tables (matplotlib's _cm_listed at 0, 1/4, 1/2,
// 3/4, 1).
#include "sim/grid/color_map.hpp"

#include "base/hash.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

double encoded(double x) {
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

}  // namespace

TEST_CASE("colour maps are within 2/255 of the published values at their quarters") {
  using Five = std::array<std::array<double, 3>, 5>;
  const std::map<std::string, Five> published = {
      {"viridis",
       {{{68.09, 1.24, 84.0},
         {58.71, 81.93, 139.1},
         {32.68, 144.1, 140.48},
         {92.53, 200.61, 98.58},
         {253.28, 231.07, 36.7}}}},
      {"magma",
       {{{0.37, 0.12, 3.54},
         {80.35, 18.15, 123.63},
         {181.86, 54.54, 121.44},
         {251.42, 135.15, 96.92},
         {251.7, 252.82, 191.12}}}},
      {"inferno",
       {{{0.37, 0.12, 3.54},
         {86.68, 15.75, 109.45},
         {186.86, 54.65, 84.67},
         {249.24, 140.92, 9.7},
         {252.03, 254.58, 164.46}}}},
      {"plasma",
       {{{12.85, 7.6, 134.63},
         {125.82, 2.94, 167.8},
         {203.08, 70.89, 120.19},
         {247.92, 148.34, 64.79},
         {239.7, 248.67, 33.49}}}},
      {"turbo",
       {{{48.44, 18.3, 59.2},
         {40.84, 186.96, 235.92},
         {162.8, 252.7, 60.3},
         {251.26, 127.96, 33.76},
         {122.3, 4.04, 2.69}}}},
      {"polar", {{{205, 244, 246}, {6, 122, 173}, {13, 13, 13}, {174, 85, 4}, {245, 235, 206}}}},
      {"grey",
       {{{0, 0, 0},
         {63.75, 63.75, 63.75},
         {127.5, 127.5, 127.5},
         {191.25, 191.25, 191.25},
         {255, 255, 255}}}}};
  CHECK(sim::colorMapNames().size() == published.size());
  for (const auto& [key, wanted] : published) {
    const std::string& name = key;  // Clang 14 cannot capture a structured binding.
    CAPTURE(name);
    CHECK(std::count(sim::colorMapNames().begin(), sim::colorMapNames().end(), name) == 1);
    const auto stops = sim::colorMapStops(name);
    REQUIRE(stops.size() >= 16);
    REQUIRE(stops.size() % 4 == 1);
    for (std::size_t quarter = 0; quarter < 5; ++quarter) {
      const glm::vec3 stop = stops[quarter * (stops.size() - 1) / 4];
      for (int i = 0; i < 3; ++i)
        CHECK(std::abs(encoded(static_cast<double>(stop[i])) -
                       wanted[quarter][static_cast<std::size_t>(i)]) <= 2);
    }
  }
}

TEST_CASE("viridis, grey, magma, inferno and plasma only get lighter; an unknown map has no stops") {
  for (const char* name : {"viridis", "grey", "magma", "inferno", "plasma"}) {
    CAPTURE(name);
    double before = -1;
    for (const glm::vec3 c : sim::colorMapStops(name)) {
      const double luminance = 0.2126 * static_cast<double>(c.x) + 0.7152 * static_cast<double>(c.y) +
                               0.0722 * static_cast<double>(c.z);
      CHECK(luminance > before);
      before = luminance;
    }
  }
  CHECK(sim::colorMapStops("rainbow").empty());
  CHECK(sim::colorMapStops("").empty());
}

TEST_CASE("polar is dark in the middle and symmetric in OKLab lightness") {
  const auto stops = sim::colorMapStops("polar");
  REQUIRE(stops.size() == 33);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const glm::dvec3 c(stops[i]);
    const double l = std::cbrt(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
    const double m = std::cbrt(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
    const double s = std::cbrt(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
    const double lightness = 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
    const double from = std::abs(static_cast<double>(i) - 16) / 16;
    CHECK(std::abs(lightness - (0.16 + 0.78 * from)) < 0.012);
  }
}

TEST_CASE("colour maps have the same bits on every machine") {
  std::vector<glm::vec3> all;
  for (const std::string& name : sim::colorMapNames())
    for (const glm::vec3& stop : sim::colorMapStops(name)) all.push_back(stop);
  CHECK(hashHex(std::as_bytes(std::span(all))) == "0e3de52b88b7e00091792f7a3b2a6c15");
}

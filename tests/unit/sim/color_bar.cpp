#include "sim/color_bar/parameters.hpp"

#include <string>
#include <vector>

#include <doctest/doctest.h>

using simreel::sim::BarTick;
using simreel::sim::barTicks;

namespace {

std::vector<std::string> texts(const std::vector<BarTick>& ticks) {
  std::vector<std::string> all;
  all.reserve(ticks.size());
  for (const BarTick& tick : ticks) all.push_back(tick.text);
  return all;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("ticks of a colour bar stand at round numbers within the range") {
  CHECK(texts(barTicks(0, 1, 5)) == Texts{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(texts(barTicks(0, 3, 5)) == Texts{"0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0"});
  CHECK(texts(barTicks(-0.3, 0.31, 3)) == Texts{"-0.2", "0.0", "0.2"});
  CHECK(texts(barTicks(12, 4800, 4)) == Texts{"1000", "2000", "3000", "4000"});
  CHECK(texts(barTicks(0, 2e6, 4)) == Texts{"0", "5e+05", "1e+06", "1.5e+06", "2e+06"});
}

TEST_CASE("ticks of a colour bar run backwards if the range does") {
  const std::vector<BarTick> ticks = barTicks(10, 0, 5);
  REQUIRE(ticks.size() == 6);
  CHECK(ticks.front().text == "0");
  CHECK(ticks.front().at == doctest::Approx(1));
  CHECK(ticks.back().at == doctest::Approx(0));
}

TEST_CASE("a range without width has one tick") {
  CHECK(texts(barTicks(2, 2, 5)) == Texts{"2"});
}

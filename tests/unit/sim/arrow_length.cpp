// Tests the default length of arrows at points.
#include "scene/load.hpp"
#include "sim/arrows/parameters.hpp"
#include "sim/world/list.hpp"

#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;  // NOLINT

namespace {

float lengthOf(int version, const std::string& members) {
  const scene::Scene scene = scene::parseScene(
      fmt::format(R"({{"version": {}, "objects": {{"p": {{"particles": {{"groups": [{{}}]}}}},
                      "a": {{"arrows": {{"of": "p"{}}}}}}}}})",
                  version, members),
      "s.json", {}, sim::kinds());
  return dynamic_cast<const sim::ArrowParameters&>(*scene.objects.back().parameters).lengthAt(0.05F);
}

}  // namespace

TEST_CASE("arrows: since version 2 the length at every n-th point grows with the square root of n") {
  CHECK(lengthOf(2, "") == doctest::Approx(0.4));
  CHECK(lengthOf(2, R"(, "every": 16)") == doctest::Approx(1.6));
  CHECK(lengthOf(1, R"(, "every": 16)") == doctest::Approx(0.4));
  CHECK(lengthOf(2, R"(, "every": 16, "length": 0.3)") == doctest::Approx(0.3));
}

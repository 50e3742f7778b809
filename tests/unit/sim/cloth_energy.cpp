// What becomes of the energy of cloth that swings undamped for a minute; tools/bench/studies.cpp has more.
#include "reference/swing.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("energy: undamped springs keep it for a minute") {
  for (const double degrees : {10.0, 45.0}) {
    CAPTURE(degrees);
    auto given = swing::springs(degrees, 0.1);
    given.parameters.substeps = 12;
    const auto course = swing::courseOfTwin(given, 60);
    CHECK(std::abs(course.drift()) < 0.01);
    CHECK(course.rise < 1e-3);
  }
}

TEST_CASE("energy: of a fabric that swings undamped the mean over a swing never rises") {
  // What it loses: constraints pull along where a substep would lead to, which takes w^2 dt a second of a
  // small swing's energy, by the frequency of a hanging chain: 14.2 / 480. A mesh's attachments take half
  // as much again.
  for (const bool mesh : {false, true})
    for (const double degrees : {10.0, 45.0}) {
      CAPTURE(mesh);
      CAPTURE(degrees);
      auto given = mesh ? swing::strip(degrees, 0.1) : swing::fabric(degrees, 0.1);
      given.parameters.substeps = 8;
      const auto course = swing::courseOfTwin(given, 60);
      CHECK(course.rise < 1e-4);
      if (degrees > 10) continue;
      const double swings = static_cast<double>(course.means.size() - 1);
      const double seconds = swings * 2 * 3.14159265 / 3.764;
      const double rate = -std::log(course.means.back() / course.means.front()) / seconds;
      CHECK(rate < (mesh ? 1.6 : 1.3) * 14.2 / 480);
    }
}

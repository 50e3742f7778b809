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

TEST_CASE("energy: a fabric two columns wide, which cannot flutter, keeps it for a minute") {
  auto given = swing::fabric(10, 0.1);
  given.parameters.size.x = 2;
  given.parameters.substeps = 16;
  const auto course = swing::courseOfTwin(given, 60);
  CHECK(std::abs(course.drift()) < 0.01);
  CHECK(course.rise < 3e-3);
}

TEST_CASE("energy: of cloth that swings undamped the mean over a swing does not rise") {
  // Wider ones begin to flutter, which goes on in ever finer waves until no substep follows them.
  for (const bool mesh : {false, true})
    for (const double degrees : {10.0, 45.0}) {
      CAPTURE(mesh);
      CAPTURE(degrees);
      auto given = mesh ? swing::strip(degrees, 0.1) : swing::fabric(degrees, 0.1);
      given.parameters.substeps = 8;
      const auto course = swing::courseOfTwin(given, 60);
      CHECK(course.rise < 2e-3);
      if (degrees < 11) CHECK(course.drift() > -0.2);
    }
}

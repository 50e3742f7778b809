#include "sim/numerics.hpp"

#include "gpu/context.hpp"

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("exact arithmetic has the bits of its C++ twin") {
  testContext();
  const auto numerics = sim::probeNumerics();
  CHECK_MESSAGE(numerics.exactHolds, numerics.firstFailure);
  CHECK(numerics.fingerprint.size() == 16);
  CHECK(numerics.fingerprint == sim::probeNumerics().fingerprint);
}

#include "sim/core/numerics.hpp"

#include "draw/screen/picture_probe.hpp"
#include "gpu/context.hpp"

#include <string>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("exact arithmetic has the bits of its C++ twin") {
  testContext();
  const auto numerics = sim::probeNumerics();
  CHECK_MESSAGE(numerics.exactHolds, numerics.firstFailure);
  CHECK(numerics.fingerprint.size() == 16);
  CHECK(numerics.fingerprint == sim::probeNumerics().fingerprint);
}

TEST_CASE("the drawn probe gives the same fingerprint each time and causes no GL errors") {
  const gl::Context& context = testContext();
  const std::string fingerprint = draw::probePictures();
  CHECK(fingerprint.size() == 16);
  CHECK(fingerprint == draw::probePictures());
  context.check();
}

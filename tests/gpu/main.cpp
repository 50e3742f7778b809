#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "gpu/context.hpp"

#include <cstdlib>

#include <doctest/doctest.h>

simreel::gl::Context& testContext() {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
  const char* path = std::getenv("SIMREEL_TEST_MEMORY_PATH");
  static simreel::gl::Context context(
      {.device = "", .debug = true, .memoryPath = path == nullptr ? "" : path});
  return context;
}

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "gpu/context.hpp"

#include <cstdlib>
#include <string>

#include <doctest/doctest.h>

using simreel::gl::Context;

namespace {

/// Returns the memory path from SIMREEL_TEST_MEMORY_PATH, "storage" or "texel". The value "other" selects
/// the path that is not the driver's default. An empty result means the default.
std::string wantedPath() {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
  const char* path = std::getenv("SIMREEL_TEST_MEMORY_PATH");
  if (path == nullptr || std::string(path) != "other") return path == nullptr ? "" : path;
  const Context usual;
  return simreel::gl::memoryPath() == simreel::gl::MemoryPath::texel ? "storage" : "texel";
}

}  // namespace

Context& testContext() {
  static Context context({.device = "", .debug = true, .memoryPath = wantedPath()});
  return context;
}

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "gpu/context.hpp"

#include <doctest/doctest.h>

simreel::gl::Context& testContext() {
  static simreel::gl::Context context({.device = "", .debug = true, .memoryPath = ""});
  return context;
}

#pragma once
#include "gl/context.hpp"

#include <filesystem>
#include <string>
#include <unistd.h>

/// Returns the single GL context of the test process. The context has debug output, so that check() fails
/// on high-severity messages.
simreel::gl::Context& testContext();

/// Returns a temporary path that contains the process ID, because tests run in parallel.
inline std::filesystem::path temporaryFile(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("simreel-" + std::to_string(::getpid()) + "-" + name);
}

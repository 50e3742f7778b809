#pragma once
#include "gl/context.hpp"

#include <filesystem>
#include <string>
#include <unistd.h>

/// The one context of the test process, with debug output; high-severity messages fail at check().
simreel::gl::Context& testContext();

/// A place for a file of this process: tests run beside each other.
inline std::filesystem::path temporaryFile(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("simreel-" + std::to_string(::getpid()) + "-" + name);
}

#include "gl/shader_cache.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <unistd.h>

namespace simreel::gl {

namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): no other thread sets it
  return value == nullptr ? "" : value;
}

/// Parses a boolean environment variable by Mesa's rules.
bool isOn(std::string_view text) {
  return text == "1" || text == "true" || text == "y" || text == "yes" || text == "t" || text == "TRUE";
}

}  // namespace

bool shaderCacheKept() {
  if (isOn(variable("MESA_SHADER_CACHE_DISABLE")) || isOn(variable("MESA_GLSL_CACHE_DISABLE")))
    return false;
  std::filesystem::path folder = variable("MESA_SHADER_CACHE_DIR");
  if (folder.empty()) folder = variable("MESA_GLSL_CACHE_DIR");
  if (folder.empty()) folder = variable("XDG_CACHE_HOME");
  if (folder.empty() && !variable("HOME").empty())
    folder = std::filesystem::path(variable("HOME")) / ".cache";
  if (folder.empty()) return false;
  std::error_code ignored;
  while (!folder.empty() && !std::filesystem::exists(folder, ignored) && folder != folder.parent_path())
    folder = folder.parent_path();
  return !folder.empty() && ::access(folder.c_str(), W_OK) == 0;
}

}  // namespace simreel::gl

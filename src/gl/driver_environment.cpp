#include "gl/driver_environment.hpp"

#include "base/text.hpp"

#include <array>
#include <cstdlib>

#include <fmt/format.h>

namespace simreel::gl {

std::string driverVariables() {
  constexpr std::array names = {"GALLIUM_DRIVER",
                                "MESA_LOADER_DRIVER_OVERRIDE",
                                "MESA_GL_VERSION_OVERRIDE",
                                "MESA_GLSL_VERSION_OVERRIDE",
                                "MESA_EXTENSION_OVERRIDE",
                                "LIBGL_ALWAYS_SOFTWARE",
                                "LIBGL_DRIVERS_PATH",
                                "EGL_PLATFORM",
                                "DRI_PRIME",
                                "__EGL_VENDOR_LIBRARY_FILENAMES",
                                "__EGL_VENDOR_LIBRARY_DIRS",
                                "VK_ICD_FILENAMES",
                                "VK_DRIVER_FILES"};
  std::string words;
  for (const char* name : names)
    // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0')
      words += fmt::format("{}{}={}", words.empty() ? "" : " and ", name, oneLine(value));
  return words;
}

std::string driverAdvice() {
  const std::string variables = driverVariables();
  const std::string first =
      variables.empty()
          ? std::string()
          : fmt::format("{} in the environment selects another driver. Unset it first, or ", variables);
  return first +
         "install a driver (Debian/Ubuntu: apt install libegl1 libegl-mesa0 libgl1-mesa-dri) and see "
         "`simreel "
         "doctor`";
}

}  // namespace simreel::gl

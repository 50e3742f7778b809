#pragma once
#include <string>

namespace simreel::gl {

/// Returns the environment variables that are set and choose a driver or change its features, for example
/// "GALLIUM_DRIVER=softpipe and LIBGL_DRIVERS_PATH=/x". Returns an empty text if no such variable is set.
[[nodiscard]] std::string driverVariables();

/// Returns advice for the end of an error message if no device can run the program.
[[nodiscard]] std::string driverAdvice();

}  // namespace simreel::gl

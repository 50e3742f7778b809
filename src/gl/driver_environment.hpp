#pragma once
#include <string>

namespace simreel::gl {

/// Returns the set environment variables that choose a driver or change its features, for example
/// "GALLIUM_DRIVER=softpipe and LIBGL_DRIVERS_PATH=/x"; empty if none of them is set.
[[nodiscard]] std::string driverVariables();

/// Returns advice for the end of an error message if no device can run the program.
[[nodiscard]] std::string driverAdvice();

}  // namespace simreel::gl

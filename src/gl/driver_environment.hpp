#pragma once
#include <string>

namespace simreel::gl {

/// Returns the environment variables that are set and that choose a driver or change the driver's features,
/// for example "GALLIUM_DRIVER=softpipe and LIBGL_DRIVERS_PATH=/x". Returns an empty text if no such
/// variable is set.
[[nodiscard]] std::string driverVariables();

/// Returns advice for users whose devices cannot run the program, for the end of an error message.
[[nodiscard]] std::string driverAdvice();

}  // namespace simreel::gl

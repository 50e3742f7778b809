#pragma once
#include <string>

namespace simreel::gl {

/// Variables of the environment that choose a driver or change what it offers, as they are set:
/// "GALLIUM_DRIVER=softpipe and LIBGL_DRIVERS_PATH=/x"; empty: none is.
[[nodiscard]] std::string driverVariables();

/// What to do where no device can run the program, for the end of a message.
[[nodiscard]] std::string driverAdvice();

}  // namespace simreel::gl

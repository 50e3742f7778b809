#pragma once
#include <string>

namespace simreel::gl {

/// Variables of the environment that choose a driver or change what it offers, as they are set:
/// "GALLIUM_DRIVER=softpipe and LIBGL_DRIVERS_PATH=/x"; empty: none is.
[[nodiscard]] std::string driverVariables();

}  // namespace simreel::gl

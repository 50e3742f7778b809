#pragma once

namespace simreel {

/// Version of the program, "major.minor.patch".
[[nodiscard]] const char* version();

}  // namespace simreel

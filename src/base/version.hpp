#pragma once

namespace simreel {

/// Returns the version of the program, "major.minor.patch".
[[nodiscard]] const char* version();

}  // namespace simreel

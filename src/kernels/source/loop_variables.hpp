#pragma once
#include "kernels/source/scan.hpp"

#include <string_view>

namespace simreel::kernels {

/// Moves the declaration of a loop variable before the loop, for the last loop before a line that declares
/// it: in Microsoft's older rules it lives on behind the loop. Empty if there is no such loop.
[[nodiscard]] Edits declaredBeforeLoop(const Scan& scan, std::string_view name, int line);

}  // namespace simreel::kernels

#pragma once
#include "kernels/source/scan.hpp"

#include <string_view>

namespace simreel::kernels {

/// Returns edits that move the declaration of loop variable `name` before its loop. The loop is the last
/// one before `line` that declares the variable. In Microsoft's older rules, a loop variable still exists
/// after its loop. Returns no edits if there is no such loop.
[[nodiscard]] Edits declaredBeforeLoop(const Scan& scan, std::string_view name, int line);

}  // namespace simreel::kernels

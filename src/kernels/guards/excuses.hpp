#pragma once
#include "kernels/spirv/module.hpp"

#include <unordered_map>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// Maps each value to the conditions (with the required results) under which a module uses the value. HLSL
/// computes both sides of "i < count && list[i] > 0" and of "i < count ? list[i] : 0". A faulty read there
/// is a mistake only if the condition selects its result.
using Excuses = std::unordered_map<Id, std::vector<std::pair<Id, bool>>>;

[[nodiscard]] Excuses excusesOf(const Module& module);

}  // namespace simreel::kernels

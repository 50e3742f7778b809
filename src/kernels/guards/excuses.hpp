#pragma once
#include "kernels/spirv/module.hpp"

#include <unordered_map>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// Conditions, and their values, under which a value of a module is used at all. HLSL computes both sides
/// of "i < count && list[i] > 0" and of "i < count ? list[i] : 0", so a read there is a mistake only if the
/// condition lets its result through.
using Excuses = std::unordered_map<Id, std::vector<std::pair<Id, bool>>>;

[[nodiscard]] Excuses excusesOf(const Module& module);

}  // namespace simreel::kernels

#pragma once
#include "kernels/spirv/module.hpp"

#include <cstdint>
#include <unordered_map>

namespace simreel::kernels {

/// A loop that ends when the comparison of an integer variable with a constant fails.
struct CountedLoop {
  Id variable = 0;           ///< pointer to the loop counter
  SpvOp compare = SpvOpNop;  ///< the loop continues while `variable compare end`
  Id end = 0;                ///< id of the constant
};

/// Returns the counted loops of a module (in the form that glslang writes), by the labels of their headers.
/// A counted loop counts from a constant to a constant in constant steps, in at most `maximum` iterations.
/// Nothing else changes its counter. No `break` leaves it, but a `return` may.
[[nodiscard]] std::unordered_map<Id, CountedLoop> countedLoops(const Module& module, std::uint32_t maximum);

}  // namespace simreel::kernels

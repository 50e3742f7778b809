#pragma once
#include "kernels/spirv/module.hpp"

#include <cstdint>
#include <unordered_map>

namespace simreel::kernels {

/// A loop that ends by a comparison of an integer variable with a constant.
struct CountedLoop {
  Id variable = 0;           ///< pointer to the loop's own counter
  SpvOp compare = SpvOpNop;  ///< the loop continues while `variable compare end`
  Id end = 0;                ///< a constant
};

/// Returns the loops of a module (as glslang writes it) that count from a constant to a constant in
/// constant steps, at most `most` iterations, by the labels of their headers. Nothing else changes the
/// counter, and no `break` leaves the loop; a `return` may.
[[nodiscard]] std::unordered_map<Id, CountedLoop> countedLoops(const Module& module, std::uint32_t most);

}  // namespace simreel::kernels

#pragma once
#include "sim/reaction/evaluate.hpp"

#include <cstddef>
#include <string>

namespace simreel::sim {

/// How a kernel is cut up; every choice gives the same bits.
struct RuleCut {
  int rows = 2;  ///< that an invocation goes down
  int groupX = 32, groupY = 4;
};

/// Of the uniform block of a pass: what is told, the two grains, then values beyond fixed edges.
[[nodiscard]] std::size_t toldVectors(const RulePass& pass);

/// The compute shader of a pass, for gl::Program::computeText: names of a scene do not occur in it, only
/// numbers of planes and of what is told. `seed`: of noise.
[[nodiscard]] std::string kernelText(const Rule& rule, const RulePass& pass, RuleSpace space,
                                     RuleBoundary boundary, unsigned seed, const RuleCut& cut);

}  // namespace simreel::sim

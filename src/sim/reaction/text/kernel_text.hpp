#pragma once
#include "sim/reaction/rule/evaluate.hpp"

#include <cstddef>
#include <string>

namespace simreel::sim {

/// Distribution of a kernel's work among invocations. Every choice gives the same bits.
struct WorkSplit {
  int rows = 2;  ///< number of rows per invocation
  int groupX = 32, groupY = 4;
  int stepsPerPass = 1;   ///< number of steps that a pass computes; if it is more than 1, the pass works in
                          ///< strips, provided that stripsCan() returns true
  int stripElements = 1;  ///< number of elements (of four cells) across a strip that an invocation
                          ///< processes
  int stripRows = 0;      ///< number of rows in a strip; 0 chooses it by the grid's size
  int stripSpecies = maxSpecies;  ///< maximum number of species for which a pass computes several steps,
                                  ///< because registers hold four rows of every species and step
  double stripsAfter = 0;  ///< number of cell updates (cells times steps) after which compiling the strip
                           ///< kernel saves time; before, steps are computed one at a time
  int volumeRows = 2;      ///< value of `rows` for a volume
};

/// Returns true if a pass can compute several steps of a rule. Requires Euler's method, a plane whose width
/// is a multiple of four, no edges of the kind "fixed", stencils of species only (ddy only on a torus), and
/// no coordinates, time or noise.
[[nodiscard]] bool stripsCan(const Rule& rule, const RuleProgram& program, RuleSpace space,
                             RuleBoundary boundary, int width);

/// Returns the compute shader of a pass of several steps in strips; see kernelText().
[[nodiscard]] std::string stripText(const Rule& rule, const RulePass& pass, const WorkSplit& cut);

/// Returns the number of vec4 in the uniform block of a pass, which holds the uniform values, the two
/// grains, and the values beyond edges of the kind "fixed".
[[nodiscard]] std::size_t uniformVectors(const RulePass& pass);

/// Returns the compute shader of a pass for gl::Kernel::generated. The text contains no names of the scene,
/// only numbers of planes and uniforms. `seed` is the seed of the noise.
[[nodiscard]] std::string kernelText(const Rule& rule, const RulePass& pass, RuleSpace space,
                                     RuleBoundary boundary, unsigned seed, const WorkSplit& cut);

}  // namespace simreel::sim

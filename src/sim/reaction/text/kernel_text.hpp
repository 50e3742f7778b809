#pragma once
#include "sim/reaction/rule/evaluate.hpp"

#include <cstddef>
#include <string>

namespace simreel::sim {

/// Partition of a kernel's work among invocations; every choice gives the same bits.
struct RuleCut {
  int rows = 2;  ///< number of rows per invocation
  int groupX = 32, groupY = 4;
  int stepsPerPass = 1;  ///< more than 1: a pass computes several steps in strips, if stripsCan() allows it
  int stripElements = 1;          ///< number of elements (four cells) per invocation across a strip
  int stripRows = 0;              ///< number of rows in a strip; 0: chosen by the grid's size
  int stripSpecies = maxSpecies;  ///< maximum number of species for several steps per pass, because
                                  ///< registers hold four rows of every species and step
  double stripsAfter = 0;  ///< number of cells times steps computed one step at a time before compiling the
                           ///< strip kernel pays off
  int volumeRows = 2;      ///< value of `rows` for a volume
};

/// True if a pass can compute several of a rule's steps. Requires Euler's method, a plane whose width is a
/// multiple of four, edges that are not fixed, stencils of species only (ddy only on a torus), and no
/// coordinates, time or noise.
[[nodiscard]] bool stripsCan(const Rule& rule, const RuleProgram& program, RuleSpace space,
                             RuleBoundary boundary, int width);

/// Returns the compute shader of a pass of several steps in strips; see kernelText().
[[nodiscard]] std::string stripText(const Rule& rule, const RulePass& pass, const RuleCut& cut);

/// Returns the number of vec4 in the uniform block of a pass: the uniform values, the two grains, then the
/// values beyond fixed edges.
[[nodiscard]] std::size_t toldVectors(const RulePass& pass);

/// Returns the compute shader of a pass for gl::Kernel::generated. It contains no names of the scene,
/// only numbers of planes and uniforms. `seed`: for noise.
[[nodiscard]] std::string kernelText(const Rule& rule, const RulePass& pass, RuleSpace space,
                                     RuleBoundary boundary, unsigned seed, const RuleCut& cut);

}  // namespace simreel::sim

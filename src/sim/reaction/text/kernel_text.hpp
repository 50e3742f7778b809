#pragma once
#include "sim/reaction/rule/evaluate.hpp"

#include <cstddef>
#include <string>

namespace simreel::sim {

/// How a kernel is cut up; every choice gives the same bits.
struct RuleCut {
  int rows = 2;  ///< that an invocation goes down
  int groupX = 32, groupY = 4;
  int stepsPerPass = 1;   ///< more than 1: several steps a pass in strips, of what stripsCan
  int stripElements = 1;  ///< elements (four cells) across a strip that each of its invocations takes
  int stripRows = 0;      ///< and rows that they go down; 0: as the grid's size asks
  int stripSpecies = maxSpecies;  ///< rules of more go one step a pass: of each, four rows of every step
                                  ///< are held in registers
  double stripsAfter = 0;  ///< cells times steps that go one a pass before strips are worth compiling
  int volumeRows = 2;      ///< `rows` of a volume
};

/// Whether a rule's steps can go several a pass: by Euler's method on a grid whose width is a multiple of
/// four and whose edges are not fixed, with stencils of species alone, on a torus ddy among them, and no
/// place, time or noise in it.
[[nodiscard]] bool stripsCan(const Rule& rule, const RuleProgram& program, RuleSpace space,
                             RuleBoundary boundary, int width);

/// As kernelText, of such a pass.
[[nodiscard]] std::string stripText(const Rule& rule, const RulePass& pass, const RuleCut& cut);

/// Of the uniform block of a pass: what is told, the two grains, then values beyond fixed edges.
[[nodiscard]] std::size_t toldVectors(const RulePass& pass);

/// The compute shader of a pass, for gl::Kernel::generated: names of a scene do not occur in it, only
/// numbers of planes and of what is told. `seed`: of noise.
[[nodiscard]] std::string kernelText(const Rule& rule, const RulePass& pass, RuleSpace space,
                                     RuleBoundary boundary, unsigned seed, const RuleCut& cut);

}  // namespace simreel::sim

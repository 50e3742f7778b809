#pragma once
#include "base/error.hpp"
#include "sim/automata/rule/cell_rule.hpp"

#include <string>
#include <string_view>

#include <doctest/doctest.h>

/// Helpers for tests of readers of text formats.
namespace simreel::test {

/// Returns a rule in standard notation, or the error as "CHARACTER: MESSAGE".
[[nodiscard]] inline std::string written(std::string_view text) {
  sim::CellRule rule;
  const sim::RuleProblem problem = sim::parseCellRule(text, rule);
  return problem.message.empty() ? rule.text() : std::to_string(problem.at) + ": " + problem.message;
}

/// Returns the error with which `read` refuses its input, or "no mistake" if `read` accepts it.
template <class Read>
[[nodiscard]] std::string mistakeIn(const Read& read) {
  try {
    static_cast<void>(read());
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "no mistake";
}

}  // namespace simreel::test

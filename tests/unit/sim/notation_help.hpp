#pragma once
#include "base/error.hpp"
#include "sim/automata/rule/cell_rule.hpp"

#include <string>
#include <string_view>

#include <doctest/doctest.h>

/// What tests of texts that others write ask of their readers.
namespace simreel::test {

/// A rule as it is written, or what is wrong with it: "CHARACTER: MESSAGE".
[[nodiscard]] inline std::string written(std::string_view text) {
  sim::CellRule rule;
  const sim::RuleProblem problem = sim::parseCellRule(text, rule);
  return problem.message.empty() ? rule.text() : std::to_string(problem.at) + ": " + problem.message;
}

/// What `read` refuses as bad input; "no mistake" where it takes it.
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

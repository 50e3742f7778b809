#include "golden/result.hpp"

#include "base/error.hpp"

#include <array>
#include <cstddef>

namespace simreel::golden {

namespace {

constexpr std::array<StatusWords, statusCount> words = {{
    {"pass", "passed", "passed"},
    {"updated", "updated", "baselines were written"},
    {"xfail", "failed as expected", "failed as expected"},
    {"flaky", "flaky", "failed, then passed"},
    {"fail", "failed", "differs from its baseline"},
    {"nondeterministic", "nondeterministic", "two runs of the same program differ"},
    {"missing", "without baseline", "has no baseline"},
    {"xpass", "passed unexpectedly", "was expected to fail, but passed"},
    {"error", "could not be tested", "could not be tested"},
}};

}  // namespace

const StatusWords& wordsOf(Status status) {
  const auto index = static_cast<std::size_t>(status);
  SIMREEL_CHECK(index < words.size());
  return words[index];
}

std::optional<Status> statusOfName(std::string_view name) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (name == words[i].name) return static_cast<Status>(i);
  return std::nullopt;
}

bool isFailure(Status status, bool allowFlaky) {
  if (status == Status::flaky) return !allowFlaky;
  return status != Status::pass && status != Status::updated && status != Status::xfail;
}

}  // namespace simreel::golden

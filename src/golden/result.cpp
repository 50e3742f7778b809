#include "golden/result.hpp"

#include "base/error.hpp"

#include <array>
#include <cstddef>

namespace simreel::golden {

namespace {

constexpr std::array<const char*, statusCount> names = {
    "pass", "updated", "xfail", "flaky", "fail", "nondeterministic", "missing", "xpass", "error"};

}  // namespace

const char* statusName(Status status) {
  const auto index = static_cast<std::size_t>(status);
  SIMREEL_CHECK(index < names.size());
  return names[index];
}

std::optional<Status> statusOfName(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (name == names[i]) return static_cast<Status>(i);
  return std::nullopt;
}

bool isFailure(Status status, bool allowFlaky) {
  switch (status) {
    case Status::pass:
    case Status::updated:
    case Status::xfail:
      return false;
    case Status::flaky:
      return !allowFlaky;
    case Status::fail:
    case Status::nondeterministic:
    case Status::missing:
    case Status::xpass:
    case Status::error:
      return true;
  }
  return true;
}

}  // namespace simreel::golden

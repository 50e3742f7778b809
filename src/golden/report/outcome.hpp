#pragma once
#include "golden/report/json.hpp"
#include "golden/result.hpp"

#include <string>

namespace simreel::golden {

/// What a process that tested a scene tells the one that started it.
[[nodiscard]] std::string outcomeText(Outcome outcome);
/// Reads what outcomeText wrote; throws as parseReport does.
[[nodiscard]] Outcome parseOutcome(const std::string& text);

}  // namespace simreel::golden

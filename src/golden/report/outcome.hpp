#pragma once
#include "golden/report/json.hpp"
#include "golden/result.hpp"

#include <string>

namespace simreel::golden {

/// Serializes the outcome of a scene, so that a worker process can pass it to its parent.
[[nodiscard]] std::string outcomeText(Outcome outcome);
/// Parses the output of outcomeText(). Throws the same errors as parseReport(), and UserError(inputOutput)
/// if the report does not contain exactly one scene.
[[nodiscard]] Outcome parseOutcome(const std::string& text);

}  // namespace simreel::golden

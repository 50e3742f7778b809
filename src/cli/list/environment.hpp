#pragma once
#include <span>

namespace simreel::cli {

/// An environment variable that the program reads.
struct Variable {
  const char* name;
  const char* meaning;
};

[[nodiscard]] std::span<const Variable> variables();

}  // namespace simreel::cli

#pragma once
#include <string>

namespace simreel::gl {

class Context;

/// What a driver's pictures are the same on: where either differs, so may a few of their bits.
struct Machine {
  /// processorName, and what the environment makes Mesa's software drivers take it for.
  std::string processor;
  /// Name and version, those of Mesa and LLVM where the driver says them.
  std::string driver;
};
[[nodiscard]] Machine machineOf(const Context& context);

}  // namespace simreel::gl

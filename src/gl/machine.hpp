#pragma once
#include <string>

namespace simreel::gl {

class Context;

/// Processor and driver. Images are bit-identical only if both are equal. Otherwise, a few bits may differ.
struct Machine {
  /// processorName, plus environment variables that make Mesa's software drivers assume another processor
  std::string processor;
  /// name and version, including Mesa and LLVM versions if the driver reports them
  std::string driver;
};
[[nodiscard]] Machine machineOf(const Context& context);

}  // namespace simreel::gl

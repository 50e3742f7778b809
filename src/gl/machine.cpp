#include "gl/machine.hpp"

#include "base/processor.hpp"
#include "gl/context.hpp"

#include <cstdlib>

namespace simreel::gl {

Machine machineOf(const Context& context) {
  Machine machine{processorName(), context.device().name + ", OpenGL " + context.device().version};
  for (const char* name :
       {"GALLIUM_OVERRIDE_CPU_CAPS", "LP_NATIVE_VECTOR_WIDTH", "GALLIVM_PERF", "LP_PERF"})
    // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0')
      machine.processor += std::string(", ") + name + "=" + value;
  return machine;
}

}  // namespace simreel::gl

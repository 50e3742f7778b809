#include "sim/core/port.hpp"

#include "base/error.hpp"

namespace simreel::sim {

void* Links::checked(void* outlet, const PortInfo& port, std::string_view object) {
  if (outlet == nullptr) fail(ExitCode::usage, "object \"{}\" provides no {} to others", object, port.name);
  return outlet;
}

}  // namespace simreel::sim

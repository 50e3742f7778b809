#include "base/version.hpp"

namespace simreel {

const char* version() {
  return SIMREEL_VERSION;
}

}  // namespace simreel

#include "base/error.hpp"

#include "base/text.hpp"

#include <cstdlib>

namespace simreel {

void brokenInvariant(const char* file, int line, const char* what, const std::string& values) {
  fmt::print(stderr, "simreel: internal error at {}:{}: {} does not hold: {}\n", file, line, what,
             oneLine(values));
  std::abort();
}

}  // namespace simreel

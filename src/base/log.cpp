#include "base/log.hpp"

#include <atomic>

namespace simreel {

namespace {
std::atomic<Verbosity> level = Verbosity::normal;
}

void setVerbosity(Verbosity verbosity) {
  level = verbosity;
}

Verbosity verbosity() {
  return level;
}

void warnLine(const std::string& message) {
  if (level != Verbosity::quiet) fmt::print(stderr, "simreel: warning: {}\n", message);
}

void infoLine(const std::string& message) {
  if (level != Verbosity::quiet) fmt::print(stderr, "{}\n", message);
}

void detailLine(const std::string& message) {
  if (level == Verbosity::verbose) fmt::print(stderr, "{}\n", message);
}

}  // namespace simreel

#include "base/log.hpp"

#include <atomic>
#include <cstdio>

namespace simreel {

namespace {
std::atomic<Verbosity> level = Verbosity::normal;
}

void errorLine(const std::string& message) {
  // Not fmt::print, which throws when standard error is closed: a run does not end for want of a listener.
  std::fputs((message + "\n").c_str(), stderr);
}

void setVerbosity(Verbosity verbosity) {
  level = verbosity;
}

Verbosity verbosity() {
  return level;
}

void warnLine(const std::string& message) {
  if (level != Verbosity::quiet) errorLine("simreel: warning: " + message);
}

void infoLine(const std::string& message) {
  if (level != Verbosity::quiet) errorLine(message);
}

void detailLine(const std::string& message) {
  if (level == Verbosity::verbose) errorLine(message);
}

}  // namespace simreel

#include "base/log.hpp"

#include "base/text.hpp"

#include <atomic>
#include <cstdio>

namespace simreel {

namespace {
std::atomic<Verbosity> level = Verbosity::normal;
std::atomic<bool> commandsAvoided = false;

void put(std::FILE* where, const std::string& text) {
  // Not fmt::print, which throws when standard error is closed: a run does not end for want of a listener.
  const std::string plain = commandsAvoided ? withoutCommands(text) : text;
  static_cast<void>(std::fwrite(plain.data(), 1, plain.size(), where));
}
}  // namespace

void errorLine(const std::string& message) {
  put(stderr, oneLine(message) + "\n");
}

void errorLines(const std::string& report) {
  put(stderr, severalLines(report) + "\n");
}

void printText(const std::string& text) {
  put(stdout, severalLines(text));
}

void printPainted(const std::string& text) {
  put(stdout, text);
}

void avoidWorkflowCommands() {
  commandsAvoided = true;
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

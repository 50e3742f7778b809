#include "base/log.hpp"

#include "base/message_taker.hpp"
#include "base/text.hpp"

#include <atomic>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <set>
#include <string_view>
#include <unistd.h>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel {

namespace {

std::atomic<Verbosity> level = Verbosity::normal;
std::atomic<bool> commandsAvoided = false;
std::atomic<bool> json = false;

void put(std::FILE* where, const std::string& text) {
  // fmt::print() is not used, because it throws if standard error is closed, which must not end a run.
  const std::string plain = commandsAvoided ? withoutCommands(text) : text;
  static_cast<void>(std::fwrite(plain.data(), 1, plain.size(), where));
}

std::string_view withoutPrefix(std::string_view text, std::string_view prefix) {
  return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
}

std::mutex takerMutex;
MessageTaker taker;

/// Passes a message to the taker if there is one. Otherwise writes it to standard error, as plain text, or
/// as a JSON object without `prefix`.
void say(const char* kind, std::string_view prefix, const std::string& text) {
  if (const std::scoped_lock lock(takerMutex); taker)
    return taker(kind, std::string(withoutPrefix(text, prefix)));
  if (!json) return put(stderr, text + "\n");
  using Json = nlohmann::ordered_json;
  const Json object = {{"event", "message"}, {"level", kind}, {"text", withoutPrefix(text, prefix)}};
  put(stderr, object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace

void setMessageTaker(MessageTaker newTaker) {
  const std::scoped_lock lock(takerMutex);
  taker = std::move(newTaker);
}

void logAsJson() {
  json = true;
}

void rawErrorLine(const char* text) noexcept {
  const auto part = [](const char* bytes) { (void)!::write(STDERR_FILENO, bytes, std::strlen(bytes)); };
  if (json) part(R"({"event":"message","level":"error","text":")");
  part(text);
  part(json ? "\"}\n" : "\n");
}

void errorLine(const std::string& message) {
  say("error", "simreel: error: ", oneLine(message));
}

void errorLines(const std::string& report) {
  say("error", "", severalLines(report));
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
  if (level != Verbosity::quiet)
    say("warning", "simreel: warning: ", "simreel: warning: " + oneLine(message));
}

namespace {

/// Returns true on the first call with this text.
bool isNew(const std::string& text) {
  static std::mutex mutex;
  static std::set<std::string> said;
  const std::scoped_lock lock(mutex);
  return said.insert(text).second;
}

}  // namespace

void warnLinesOnce(const std::string& report) {
  if (level != Verbosity::quiet && isNew(report)) say("warning", "", severalLines(report));
}

void infoLine(const std::string& message) {
  if (level == Verbosity::quiet) return;
  // Clears the terminal's current line, which may show a progress bar.
  if (!json && ::isatty(STDERR_FILENO) != 0) put(stderr, "\r\x1b[K");
  say("info", "simreel: ", oneLine(message));
}

void infoLineOnce(const std::string& message) {
  if (level != Verbosity::quiet && isNew(message)) infoLine(message);
}

void detailLine(const std::string& message) {
  if (level == Verbosity::verbose) say("detail", "", oneLine(message));
}

}  // namespace simreel

#pragma once
#include <string>
#include <utility>

#include <fmt/format.h>

namespace simreel {

enum class Verbosity { quiet, normal, verbose };

void setVerbosity(Verbosity verbosity);
[[nodiscard]] Verbosity verbosity();

/// Suppresses all messages except errors while the object exists.
class Silence {
 public:
  Silence() : before_(verbosity()) { setVerbosity(Verbosity::quiet); }
  ~Silence() { setVerbosity(before_); }
  Silence(Silence&&) = delete;
  Silence(const Silence&) = delete;
  Silence& operator=(Silence&&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  Verbosity before_;
};

/// Makes all later lines JSON objects: {"event":"message","level":"error","text":"..."}.
void logAsJson();
/// Writes one line of plain ASCII to standard error. Safe in signal handlers.
void rawErrorLine(const char* text) noexcept;

// All functions below except printPainted() escape control characters (base/text.hpp), so that text from
// files, names and arguments cannot control the terminal.

/// Writes one line to standard error at any verbosity. Ignores write errors.
void errorLine(const std::string& message);
/// Writes a report of several lines to standard error at any verbosity. Keeps its newlines.
void errorLines(const std::string& report);
/// Writes text to standard output. A write error is detected when the program flushes the stream.
void printText(const std::string& text);
/// Writes text to standard output unchanged. The text must already be escaped and may contain colours.
void printPainted(const std::string& text);
/// Makes all later output escape lines that GitHub Actions would interpret as commands.
void avoidWorkflowCommands();
/// Writes one line "simreel: warning: ..." to standard error unless quiet.
void warnLine(const std::string& message);
/// Writes a report of several lines to standard error unless quiet. Writes each report only once per
/// process.
void warnLinesOnce(const std::string& report);
/// Writes one line to standard error unless quiet.
void infoLine(const std::string& message);
/// Writes one line to standard error unless quiet. Writes each message only once per process.
void infoLineOnce(const std::string& message);
/// Writes one line to standard error if the user gave -v (verbose).
void detailLine(const std::string& message);

template <class... Args>
void warn(fmt::format_string<Args...> format, Args&&... args) {
  warnLine(fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void info(fmt::format_string<Args...> format, Args&&... args) {
  infoLine(fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void detail(fmt::format_string<Args...> format, Args&&... args) {
  if (verbosity() == Verbosity::verbose) detailLine(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace simreel

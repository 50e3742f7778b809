#pragma once
#include <string>
#include <utility>

#include <fmt/format.h>

namespace simreel {

enum class Verbosity { quiet, normal, verbose };

void setVerbosity(Verbosity verbosity);
[[nodiscard]] Verbosity verbosity();

/// Only errors are shown while it lives.
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

/// From here on each line is a JSON object: {"event":"message","level":"error","text":"..."}.
void logAsJson();
/// One line of plain ASCII on standard error, for signal handlers.
void rawErrorLine(const char* text) noexcept;

// What comes from files, names and arguments never reaches the terminal raw: each of these spells out what
// would steer it (base/text.hpp).

/// One line on standard error, always; nothing happens where it cannot be written.
void errorLine(const std::string& message);
/// The same for a report of several lines, all of them ours.
void errorLines(const std::string& report);
/// Text for standard output. Whether it could be written shows when the program flushes it.
void printText(const std::string& text);
/// The same for text that is clean already and may be coloured.
void printPainted(const std::string& text);
/// From here on no line of the above is one that GitHub Actions reads as a command.
void avoidWorkflowCommands();
/// One line on standard error, "simreel: warning: ..."; shown unless quiet.
void warnLine(const std::string& message);
/// A report of several lines on standard error, all of them ours; shown unless quiet, and each once.
void warnLinesOnce(const std::string& report);
/// One line on standard error; shown unless quiet.
void infoLine(const std::string& message);
/// The same, once a process for each message.
void infoLineOnce(const std::string& message);
/// One line on standard error; shown with -v only.
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

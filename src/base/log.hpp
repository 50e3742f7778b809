#pragma once
#include <string>
#include <utility>

#include <fmt/format.h>

namespace simreel {

enum class Verbosity { quiet, normal, verbose };

void setVerbosity(Verbosity verbosity);
[[nodiscard]] Verbosity verbosity();

/// One line on standard error, always; nothing happens where it cannot be written.
void errorLine(const std::string& message);
/// One line on standard error, "simreel: warning: ..."; shown unless quiet.
void warnLine(const std::string& message);
/// One line on standard error; shown unless quiet.
void infoLine(const std::string& message);
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

#pragma once
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace simreel {

/// What the program returns to the shell. Signals return 128 + n.
enum class ExitCode {
  ok = 0,
  different = 1,        ///< images or invariants differ
  usage = 2,            ///< command line or scene
  baselineMissing = 3,  ///< nothing to compare with
  device = 4,           ///< no device, a limit, or NaN in the state
  nothingRan = 5,
  inputOutput = 6,
};

/// A mistake the user can mend. The message says what, where and what to do; main prints it.
class UserError : public std::runtime_error {
 public:
  /// A sentence is printed after "simreel: error: "; a report's lines say "place: error: " themselves.
  enum class Form { sentence, report };

  /// A zero byte, at which what() would end, is spelt out: \x00.
  UserError(ExitCode code, const std::string& message, Form form = Form::sentence);
  [[nodiscard]] ExitCode code() const { return code_; }
  [[nodiscard]] Form form() const { return form_; }

 private:
  ExitCode code_;
  Form form_;
};

/// Throws a UserError with a formatted message.
template <class... Args>
[[noreturn]] void fail(ExitCode code, fmt::format_string<Args...> format, Args&&... args) {
  throw UserError(code, fmt::format(format, std::forward<Args>(args)...));
}

[[noreturn]] void brokenInvariant(const char* file, int line, const char* what, const std::string& values);

}  // namespace simreel

/// Stops the program when an invariant of ours is broken, printing both values.
#define SIMREEL_CHECK_EQ(a, b)                                              \
  do {                                                                      \
    const auto& checkA = (a);                                               \
    const auto& checkB = (b);                                               \
    if (!(checkA == checkB))                                                \
      ::simreel::brokenInvariant(__FILE__, __LINE__, #a " == " #b,          \
                                 fmt::format("{} and {}", checkA, checkB)); \
  } while (false)
#define SIMREEL_CHECK(condition)                                                           \
  do {                                                                                     \
    if (!(condition)) ::simreel::brokenInvariant(__FILE__, __LINE__, #condition, "false"); \
  } while (false)

#pragma once
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace simreel {

/// Exit codes of the program. After signal n, the exit code is 128 + n.
enum class ExitCode {
  ok = 0,
  different = 1,        ///< the images of a comparison differ, or an invariant does not hold
  usage = 2,            ///< the command line or the scene has an error
  baselineMissing = 3,  ///< there is no baseline to compare with
  device = 4,           ///< no device, a device limit, or NaN in the state
  nothingRan = 5,
  inputOutput = 6,
};

/// Error that the user can fix. The message states the problem, its location and a remedy. main() prints
/// it.
class UserError : public std::runtime_error {
 public:
  /// Form of the message. sentence: main() prints the message after "simreel: error: ". report: main()
  /// prints the message unchanged, because its lines contain "place: error: ".
  enum class Form { sentence, report };

  /// Replaces zero bytes in `message` by \x00, because what() would end at a zero byte.
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

/// Checks that two values are equal. If they are not, the program has a bug, so the macro prints both
/// values and aborts.
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

#include "base/error.hpp"
#include "cli/commands.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <unistd.h>

namespace simreel::cli {

namespace {

/// Prints one line without allocating memory and exits immediately with `code`. Files on disk stay
/// complete, as after a kill.
[[noreturn]] void end(const char* message, ExitCode code) {
  static_cast<void>(std::fputs("simreel: error: ", stderr));
  static_cast<void>(std::fputs(message, stderr));
  static_cast<void>(std::fputs("\n", stderr));
  ::_exit(static_cast<int>(code));
}

[[noreturn]] void terminated() {
  if (std::current_exception() == nullptr) std::abort();
  try {
    throw;
  } catch (const std::bad_alloc&) {
    end("not enough memory", ExitCode::device);
  } catch (const std::exception& error) {
    end(error.what(), ExitCode::inputOutput);
  } catch (...) {
    std::abort();
  }
}

}  // namespace

void explainTermination() {
  std::set_terminate(terminated);
}

namespace {

/// Installs the handler before any static object is constructed, because the constructors of static objects
/// run before main() and may allocate memory.
[[gnu::used, gnu::section(".preinit_array")]] void (*const beforeStaticObjects)() = explainTermination;

}  // namespace

}  // namespace simreel::cli

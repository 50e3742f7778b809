#include "base/error.hpp"
#include "base/log.hpp"
#include "base/process.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/help/help_format.hpp"
#include "cli/help/mistyped.hpp"
#include "cli/stack_room.hpp"
#include "frame/interrupt.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fcntl.h>
#include <iostream>
#include <new>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

int exitCode = 0;
std::string typed;

int print(const UserError& error) {
  printError(error);
  return static_cast<int>(error.code());
}

int print(const std::string& message, ExitCode code) {
  return print(UserError(code, message));
}

ExitCode exitCodeOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::scene:
    case ErrorKind::usage:
      return ExitCode::usage;
    case ErrorKind::device:
    case ErrorKind::process:
      return ExitCode::device;
    case ErrorKind::different:
      return ExitCode::different;
    case ErrorKind::inputOutput:
    case ErrorKind::interrupted:
    case ErrorKind::internal:
      break;
  }
  return ExitCode::inputOutput;
}

/// Opens /dev/null on each of the descriptors 0 to 2 that the caller closed. Otherwise a file opened later
/// would get such a descriptor, and messages would be written into that file. /dev/null is opened
/// read-only, so that writing fails as it does on a closed descriptor.
void holdStandardDescriptors() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) < 0) (void)::open("/dev/null", O_RDONLY);
}

/// Flushes standard output and returns the exit code. A full disk is detected only by the flush, because
/// text stays in the buffer until then.
int flushed(int code) {
  std::cout.flush();
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
  if (code != 0 || written) return code;
  return print("cannot write to standard output", ExitCode::inputOutput);
}

/// True if the arguments contain --progress=ndjson. Called before the command line is parsed, so that parse
/// errors are also reported as NDJSON.
bool asksForNdjson(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--progress=ndjson") return true;
    if (word == "--progress" && i + 1 < argc && std::string_view(argv[i + 1]) == "ndjson") return true;
  }
  return false;
}

}  // namespace

const std::string& commandLine() {
  return typed;
}

void setExitCode(int code) {
  exitCode = code;
}

void printError(const UserError& error) {
  if (error.form() == UserError::Form::report)
    errorLines(error.what());
  else
    errorLine("simreel: error: " + std::string(error.what()));
}

UserError userErrorOf(const Error& error) {
  const std::string text = error.what();
  // A report of the driver begins with "simreel: error:" itself.
  const bool report = error.kind() == ErrorKind::scene || text.starts_with("simreel: error: ");
  return {exitCodeOf(error.kind()), text, report ? UserError::Form::report : UserError::Form::sentence};
}

void addCommands(CLI::App& app) {
  app.name("simreel");
  useHelpFormat(app);
  app.set_version_flag("--version", std::string("simreel ") + version());
  app.require_subcommand(1);
  app.fallthrough();
  app.add_flag_callback(
      "-q,--quiet", [] { setVerbosity(Verbosity::quiet); }, "Print errors only");
  app.add_flag_callback(
      "-v,--verbose", [] { setVerbosity(Verbosity::verbose); }, "Print more");
  for (const auto add : {addRender, addServe,  addBake,    addNew,    addList,      addExplain, addValidate,
                         addTest,   addAccept, addReport,  addDiff,   addReproduce, addTrace,   addBisect,
                         addSweep,  addPieces, addKernels, addDoctor, addBench,     addSchema})
    add(app);
  groupCommands(app);
}

namespace {

/// Turns `simreel help render` into `simreel render --help`.
void askForHelp(int argc, char** argv) {
  static std::string flag = "--help";
  if (argc < 2 || std::string_view(argv[1]) != "help") return;
  std::rotate(argv + 1, argv + 2, argv + argc);
  argv[argc - 1] = flag.data();
}

int runCommand(int argc, char** argv) {
  askForHelp(argc, argv);
  for (int i = 0; i < argc; ++i) typed += (i == 0 ? "" : " ") + inShellQuotes(argv[i]);
  CLI::App app;
  addCommands(app);
  try {
    app.parse(argc, argv);
    return flushed(exitCode);
  } catch (const CLI::CallForHelp& help) {
    return flushed(app.exit(help));
  } catch (const CLI::CallForAllHelp& help) {
    return flushed(app.exit(help));
  } catch (const CLI::CallForVersion& versionCall) {
    return flushed(app.exit(versionCall));
  } catch (const CLI::ParseError& error) {
    return print(UserError(ExitCode::usage, "simreel: error: " + explainMistake(app, error),
                           UserError::Form::report));
  }
}

/// Runs the command and converts every exception, including those during setup, to one line and an exit
/// code.
int explained(int argc, char** argv) {
  try {
    takeStackRoom(argv);
    return runCommand(argc, argv);
  } catch (const UserError& error) {
    return print(error);
  } catch (const Error& error) {
    return print(userErrorOf(error));
  } catch (const frame::Interrupted& interrupted) {  // A signal arrived while a command created its world.
    info("simreel: interrupted");
    return 128 + interrupted.signal;
  } catch (const std::bad_alloc&) {
    return print("not enough memory", ExitCode::device);
  } catch (const std::exception& error) {
    return print(error.what(), ExitCode::inputOutput);
  }
}

}  // namespace

int run(int argc, char** argv) {
  holdStandardDescriptors();
  if (asksForNdjson(argc, argv)) logAsJson();
  try {
    return explained(argc, argv);
  } catch (...) {
    // There is no memory left to format a message.
    static_cast<void>(std::fputs("simreel: error: not enough memory\n", stderr));
    return static_cast<int>(ExitCode::device);
  }
}

}  // namespace simreel::cli

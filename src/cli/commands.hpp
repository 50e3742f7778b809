#pragma once
#include "base/error.hpp"

#include <simreel/error.hpp>
#include <string>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Runs the command in the arguments and returns the exit code. Prints a UserError on standard error as
/// "simreel: error: ...", or unchanged if the error is a report.
int run(int argc, char** argv);
/// Installs a terminate handler for exceptions that cannot be caught (out of memory in a destructor, or a
/// thread that a library could not start). The process then ends immediately with one line and a documented
/// exit code.
void explainTermination();

/// Adds the whole command line: name, flags and commands. tools/manual makes the man page from it.
void addCommands(CLI::App& app);

// Each of these functions adds one command. The command's callback throws UserError or calls setExitCode().
void addRender(CLI::App& app);
void addValidate(CLI::App& app);
void addSchema(CLI::App& app);
void addList(CLI::App& app);
void addDoctor(CLI::App& app);
void addDiff(CLI::App& app);
void addBake(CLI::App& app);
void addSweep(CLI::App& app);
void addPieces(CLI::App& app);
void addReproduce(CLI::App& app);
void addTest(CLI::App& app);
void addTrace(CLI::App& app);
void addBisect(CLI::App& app);
void addBench(CLI::App& app);
void addAccept(CLI::App& app);
void addReport(CLI::App& app);
void addServe(CLI::App& app);
void addNew(CLI::App& app);
void addExplain(CLI::App& app);
void addKernels(CLI::App& app);

/// Returns the command line as typed, quoted for a shell where needed.
[[nodiscard]] const std::string& commandLine();

/// Prints an error on standard error. A sentence follows "simreel: error: ", and a report is printed
/// unchanged.
void printError(const UserError& error);
/// Returns an error of libsimreel's interface with the exit code and form that the same error of an
/// internal function has.
[[nodiscard]] UserError userErrorOf(const Error& error);

/// Sets the exit code of a command that ends without an exception (130 after an interrupt).
void setExitCode(int code);

}  // namespace simreel::cli

#pragma once
#include "base/error.hpp"

#include <string>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Picks the command, prints a UserError on standard error, as "simreel: error: ..." unless it is a report,
/// and returns the exit code.
int run(int argc, char** argv);
/// Exceptions that nothing can catch (memory that ran out in a destructor, a thread that a library could
/// not start) end with one line and a documented code too, as at once as a kill.
void explainTermination();

/// The whole command line: name, flags and commands. tools/manual makes the man page of it.
void addCommands(CLI::App& app);

// One command each; the callback throws UserError, or sets the exit code through setExitCode.
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

/// What was typed, quoted for a shell where needed.
[[nodiscard]] const std::string& commandLine();

/// A sentence after "simreel: error: ", or a report as it is, on standard error.
void printError(const UserError& error);

/// Exit code of a command that ended without an error of its own (130 after an interrupt).
void setExitCode(int code);

}  // namespace simreel::cli

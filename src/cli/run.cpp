#include <exception>
#include <string>

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

int exitCode = 0;

int print(const std::string& message, ExitCode code) {
  fmt::print(stderr, "simreel: error: {}\n", message);
  return static_cast<int>(code);
}

}  // namespace

void setExitCode(int code) {
  exitCode = code;
}

int run(int argc, char** argv) {
  CLI::App app("Renders GPU simulations without a display.", "simreel");
  app.set_version_flag("--version", std::string("simreel ") + version());
  app.require_subcommand(1);
  app.fallthrough();
  app.add_flag_callback("-q,--quiet", [] { setVerbosity(Verbosity::quiet); }, "Say nothing but errors");
  app.add_flag_callback("-v,--verbose", [] { setVerbosity(Verbosity::verbose); }, "Say more");
  addRender(app);
  addValidate(app);
  addSchema(app);
  addList(app);
  addDoctor(app);
  try {
    app.parse(argc, argv);
    return exitCode;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForAllHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForVersion& versionCall) {
    return app.exit(versionCall);
  } catch (const CLI::ParseError& error) {
    return print(std::string(error.what()) + "; see `simreel --help`", ExitCode::usage);
  } catch (const UserError& error) {
    return print(error.what(), error.code());
  } catch (const std::bad_alloc&) {
    return print("not enough memory", ExitCode::device);
  } catch (const std::exception& error) {
    return print(error.what(), ExitCode::inputOutput);
  }
}

}  // namespace simreel::cli

// Commands that only read: validate, schema, list.
#include "base/error.hpp"
#include "base/log.hpp"
#include "cli/commands.hpp"
#include "cli/scene_options.hpp"
#include "sim/list.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

void validate(const std::vector<std::string>& files, const std::vector<std::string>& overrides) {
  const auto all = parseOverrides(overrides);
  std::size_t bad = 0;
  for (const std::string& file : files) {
    try {
      const auto scene = scene::loadTestScene(file, all, sim::kinds());  // with what stands beside it
      fmt::print("{}: ok\n", file);
    } catch (const UserError& error) {
      if (error.code() != ExitCode::usage && files.size() == 1) throw;
      ++bad;
      std::fflush(stdout);
      errorLine(error.what());
    }
  }
  if (bad > 0)
    fail(ExitCode::usage, "{} of {} scene{} cannot be used", bad, files.size(),
         files.size() == 1 ? "" : "s");
}

}  // namespace

void addValidate(CLI::App& app) {
  struct Arguments {
    std::vector<std::string> files, overrides;
  };
  auto arguments = std::make_shared<Arguments>();
  auto* command = app.add_subcommand("validate", "Check scene files and report every mistake");
  command->add_option("scenes", arguments->files, "Scene files")->required();
  command->add_option("-D", arguments->overrides, "Override any value: path=value, repeatable")
      ->allow_extra_args(false);
  command->callback([arguments] { validate(arguments->files, arguments->overrides); });
}

void addSchema(CLI::App& app) {
  app.add_subcommand("schema", "Print the JSON Schema of scene files")->callback([] {
    fmt::print("{}", scene::schemaText(sim::kinds()));
  });
}

void addList(CLI::App& app) {
  auto name = std::make_shared<std::string>();
  auto* command =
      app.add_subcommand("list", "Print what a scene may hold, or every parameter of one thing");
  command->add_option("name", *name, "A simulation or section, for example cloth");
  command->callback([name] {
    fmt::print("{}", name->empty() ? scene::listText(sim::kinds()) : scene::helpText(*name, sim::kinds()));
  });
}

}  // namespace simreel::cli

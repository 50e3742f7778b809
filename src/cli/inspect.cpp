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

struct ValidateOptions {
  std::vector<std::string> files, overrides, assets;
};

void validate(const ValidateOptions& o) {
  const auto all = parseOverrides(o.overrides);
  const auto folders = assetFolders(o.assets);
  const std::vector<std::string>& files = o.files;
  std::size_t bad = 0;
  for (const std::string& file : files) {
    try {
      const auto scene =
          scene::loadTestScene(file, all, sim::kinds(), folders);  // with what stands beside it
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
  auto o = std::make_shared<ValidateOptions>();
  auto* command = app.add_subcommand("validate", "Check scene files and report every mistake");
  command->add_option("scenes", o->files, "Scene files, or - for standard input")->required();
  command->add_option("-D", o->overrides, "Override any value: path=value, repeatable")
      ->allow_extra_args(false);
  addAssets(*command, o->assets);
  command->callback([o] { validate(*o); });
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

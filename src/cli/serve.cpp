#include "serve/serve.hpp"

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "cli/options/shipped_scene.hpp"
#include "frame/interrupt.hpp"
#include "gl/context.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct ServePageOptions {
  SceneOptions scene;
  gl::ContextOptions on;
  std::string address = "127.0.0.1";
  int port = 0;
  int memory = 1024;
  bool edit = false;
  std::string output;
  std::string from;
  std::string other;
  bool embed = false;
  std::vector<std::string> beside;
};

/// Returns the settings of the right side, which shows another scene with the same options, or the same
/// scene with other values.
serve::CounterpartOptions counterpart(const ServePageOptions& o) {
  if (o.other == "-") fail(ExitCode::usage, "serve watches both files; standard input cannot be watched");
  serve::CounterpartOptions other;
  other.ownFile = !o.other.empty();
  other.on = other.ownFile || !o.beside.empty();
  other.edits = parseOverrides(o.beside);
  other.arguments = o.scene.arguments();
  if (other.ownFile) other.arguments.front() = o.other;
  if (other.ownFile && !std::filesystem::exists(o.other))
    fail(ExitCode::usage, "{}: there is no such file", o.other);
  other.source = {other.ownFile ? o.other : o.scene.file, o.scene.changes(), assetFolders(o.scene.assets)};
  return other;
}

void servePage(const ServePageOptions& o) {
  if (o.scene.file == "-")
    fail(ExitCode::usage, "serve watches the scene's file; standard input cannot be watched");
  if (o.edit && o.scene.shipped)
    fail(ExitCode::usage, "--edit would change the shipped scene; copy it first: cp {} .", o.scene.file);
  if (o.edit && std::filesystem::path(o.scene.file).extension() != ".json")
    fail(ExitCode::usage, "--edit {}: only scenes can be edited", o.scene.file);
  if (o.edit && !o.other.empty() && std::filesystem::path(o.other).extension() != ".json")
    fail(ExitCode::usage, "--edit {}: only scenes can be edited", o.other);
  std::error_code unknown;
  if (std::filesystem::exists(o.output, unknown) && !std::filesystem::is_directory(o.output, unknown))
    fail(ExitCode::usage, "--output {}: this is a file; name a folder for the pictures", o.output);
  serve::ServeOptions options;
  options.player.source = {o.scene.file, o.scene.changes(), assetFolders(o.scene.assets)};
  options.player.arguments = o.scene.arguments();
  options.player.memory = static_cast<std::size_t>(o.memory) << 20;
  options.player.edit = o.edit;
  options.player.output = o.output;
  options.player.other = counterpart(o);
  options.player.from = o.from;
  options.embed = o.embed;
  options.address = o.address;
  options.port = o.port;
  frame::catchInterrupts();
  frame::ignoreBrokenPipes();
  const gl::Context context(o.on);
  const int signal = serve::serveScene(std::move(options), context);
  if (signal != 0) setExitCode(128 + signal);
}

}  // namespace

void addServe(CLI::App& app) {
  auto o = std::make_shared<ServePageOptions>();
  auto* command = app.add_subcommand("serve", "Show a scene in a browser while you edit it");
  o->scene.add(*command);
  command->get_option("scene")->description("Scene file; the page follows its changes");
  findShipped(*command->add_option("other", o->other,
                                   "A second scene, shown side by side with the first at the same frame"));
  command
      ->add_option("--beside", o->beside,
                   "Override a value on the right side only: path=value, repeatable; without a second "
                   "scene the right side shows the same scene")
      ->allow_extra_args(false);
  command->add_option("--from", o->from,
                      "Begin at this checkpoint instead of at the scene's start; any run of the same "
                      "simulation can have written it. The page follows its changes");
  command->add_flag("--embed", o->embed,
                    "Let other pages that know the address show this page in a frame, as notebooks do");
  command->add_option("--port", o->port, "Port to listen at; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command
      ->add_option("--bind", o->address,
                   "IP address to listen at; with 0.0.0.0 other machines can connect, if they have the "
                   "address with its token")
      ->check(CLI::ValidIPV4)
      ->capture_default_str();
  command->add_option("--memory", o->memory, "MiB for past states, to go back to")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  command->add_flag("--edit", o->edit,
                    "Write values that are changed on the page into the scene file (and those of the right "
                    "side into its file); without this flag no scene file changes");
  command->add_option(
      "-o,--output", o->output,
      "Folder for pictures that are rendered from the page; left out: the page cannot render");
  addDevice(*command, o->on);
  command->callback([o] { servePage(*o); });
}

}  // namespace simreel::cli

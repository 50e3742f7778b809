// simreel reproduce: checks that rendering a picture's scene again gives the same picture.
#include "batch/reproduce/reproduce.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "frame/interrupt.hpp"

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct ReproduceOptions {
  batch::ReproduceRequest request;
  std::vector<std::string> assets;
};

void reproduce(ReproduceOptions& o) {
  o.request.assets = assetFolders(o.assets);
  frame::catchInterrupts();
  const batch::Reproduction made = batch::reproduce(o.request);
  printText(oneLine(fmt::format("{}: frame {} is {}", o.request.file.string(), made.frame,
                                made.same ? "the same, in state and in every pixel" : "not the same")) +
            "\n");
  for (const std::string& line : made.differences) printText("  " + oneLine(line) + "\n");
  if (!made.same) setExitCode(static_cast<int>(ExitCode::different));
}

}  // namespace

void addReproduce(CLI::App& app) {
  auto o = std::make_shared<ReproduceOptions>();
  auto* command =
      app.add_subcommand("reproduce", "Render a picture's frame again, and check that it is the same");
  command
      ->add_option("file", o->request.file,
                   "A picture that simreel rendered, a manifest, or a folder or video with a manifest")
      ->required();
  command->add_option("--frame", o->request.frame, "Frame of a manifest (default: its last)");
  command->add_option("--scene", o->request.scene,
                      "Scene to render, instead of as-run.json beside the picture");
  addAssets(*command, o->assets);
  command->add_option("-o,--output", o->request.output, "Folder to keep the new picture in");
  addDevice(*command, o->request.on);
  command->callback([o] { reproduce(*o); });
}

}  // namespace simreel::cli

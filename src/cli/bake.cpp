// `simreel bake`: what a simulation computed, as files for other programs.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/version.hpp"
#include "cli/bake_maps.hpp"
#include "cli/commands.hpp"
#include "cli/scene_options.hpp"
#include "frame/frames_spec.hpp"
#include "frame/interrupt.hpp"
#include "frame/ply.hpp"
#include "gl/context.hpp"
#include "sim/world.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

struct BakeOptions {
  SceneOptions scene;
  std::string output, object, device, memoryPath;
  std::string format = "points", look;
  std::optional<std::string> frames;
  bool overwrite = false;
};

/// Objects whose state is points: the one asked for, or all.
std::vector<std::size_t> bakedObjects(const sim::World& world, const std::string& wanted) {
  std::vector<std::size_t> objects;
  std::string names;
  for (std::size_t i = 0; i < world.objectCount(); ++i) {
    if (world.object(i).points().columns.empty()) continue;
    names += (names.empty() ? "" : ", ") + world.objectName(i);
    if (wanted.empty() || wanted == world.objectName(i)) objects.push_back(i);
  }
  if (objects.empty() && names.empty()) fail(ExitCode::usage, "no object of the scene has points to bake");
  if (objects.empty())
    fail(ExitCode::usage, "--object: there is no \"{}\" with points; there is {}", wanted, names);
  return objects;
}

fs::path fileOf(const BakeOptions& o, const std::string& object, int frame) {
  return fs::path(o.output) / fmt::format("{}_{:06}.ply", object, frame);
}

void bake(const BakeOptions& o) {
  if (o.format == "maps")
    return bakeMaps({.scene = o.scene,
                     .output = o.output,
                     .object = o.object,
                     .look = o.look,
                     .device = o.device,
                     .memoryPath = o.memoryPath,
                     .frames = o.frames,
                     .overwrite = o.overwrite});
  if (!o.look.empty()) fail(ExitCode::usage, "--look belongs to --format maps");
  const scene::Scene scene = o.scene.load();
  std::vector<int> frames;
  if (o.frames)
    frames = frame::parseFrames(*o.frames);
  else
    for (int frame = 0; frame < scene.frameCount(); ++frame) frames.push_back(frame);
  frame::catchInterrupts();
  const gl::Context context({.device = o.device, .debug = false, .memoryPath = o.memoryPath});
  sim::World world(scene);
  const auto objects = bakedObjects(world, o.object);
  for (const int frame : frames)
    for (const std::size_t object : objects)
      if (const auto file = fileOf(o, world.objectName(object), frame); !o.overwrite && pathExists(file))
        fail(ExitCode::inputOutput, "{} exists; use --overwrite to replace it", file.string());
  makeFolders(o.output);
  int files = 0;
  int simulated = world.firstFrame();
  for (const int frame : frames) {
    for (; simulated <= frame; ++simulated) {
      if (const int signal = frame::interruptSignal()) {
        info("simreel: interrupted; the {} files written so far are whole", files);
        return setExitCode(128 + signal);
      }
      world.advanceTo(simulated);
      world.startSummary();
      static_cast<void>(world.takeSummary(true));  // throws when the state is lost
    }
    for (const std::size_t object : objects) {
      const sim::PointTable table = world.object(object).points();
      const std::vector<std::string> comments = {
          fmt::format("simreel {}", version()), fmt::format("scene {}", scene.hash),
          fmt::format("object {} frame {} time {:g} s seed {}", world.objectName(object), frame,
                      world.time(), scene.seed)};
      writeFileAtomically(fileOf(o, world.objectName(object), frame),
                          frame::encodePly(table.columns, table.values, comments));
      ++files;
    }
  }
  info("{} files -> {}", files,
       fileOf(o, world.objectName(objects.front()), frames.front()).string() + " ...");
}

}  // namespace

void addBake(CLI::App& app) {
  auto o = std::make_shared<BakeOptions>();
  auto* command =
      app.add_subcommand("bake", "Write what was simulated for other programs: points, materials");
  o->scene.add(*command);
  command->add_option("-o,--output", o->output, "Folder for NAME_000000.ply, NAME_000000_albedo.png ...")
      ->required();
  command
      ->add_option(
          "--format", o->format,
          "points: PLY files, one a frame. maps: of skins, textures that tile (albedo, normal with +y up, "
          "16-bit height, roughness, occlusion; --size sets theirs)")
      ->check(CLI::IsMember({"points", "maps"}));
  command->add_option("--frames", o->frames,
                      "Frames to write, for example 0-99x2,150; none given: all, of maps the last");
  command->add_option("--look", o->look, "With maps: a field as it is, as leather, spots, cracks or map");
  command->add_option("--object", o->object, "Only this object");
  command->add_option("--device", o->device, "Index or part of a name (see `simreel doctor`)");
  command->add_option("--memory-path", o->memoryPath,
                      "How kernels read: storage or texel (default: by driver)");
  command->add_flag("--overwrite", o->overwrite, "Replace files that exist");
  command->callback([o] { bake(*o); });
}

}  // namespace simreel::cli

// `simreel bake`: what a simulation computed, as files for other programs.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/scene_options.hpp"
#include "frame/field_file.hpp"
#include "frame/frames_spec.hpp"
#include "frame/interrupt.hpp"
#include "frame/ply.hpp"
#include "gl/context.hpp"
#include "sim/field_values.hpp"
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
  std::string format = "ply";
  std::optional<std::string> frames;
  bool overwrite = false;
};

constexpr const char* pointFormat = "ply";

/// The field that an object publishes at present, or null.
const sim::Field* fieldOf(const sim::Drawables& drawables, const std::string& object) {
  for (const sim::Field& field : drawables.fields)
    if (*field.name == object) return &field;
  return nullptr;
}

/// Objects that the format is for: the one asked for, or all.
std::vector<std::size_t> bakedObjects(const sim::World& world, const std::string& wanted, bool points) {
  const char* what = points ? "points" : "a field";
  const sim::Drawables drawables = world.drawables();
  std::vector<std::size_t> objects;
  std::string names;
  for (std::size_t i = 0; i < world.objectCount(); ++i) {
    if (points ? world.object(i).points().columns.empty()
               : fieldOf(drawables, world.objectName(i)) == nullptr)
      continue;
    names += (names.empty() ? "" : ", ") + world.objectName(i);
    if (wanted.empty() || wanted == world.objectName(i)) objects.push_back(i);
  }
  if (objects.empty() && names.empty())
    fail(ExitCode::usage, "no object of the scene has {} to bake", what);
  if (objects.empty())
    fail(ExitCode::usage, "--object: there is no \"{}\" with {}; there is {}", wanted, what, names);
  return objects;
}

fs::path fileOf(const BakeOptions& o, const std::string& object, int frame) {
  return fs::path(o.output) / fmt::format("{}_{:06}.{}", object, frame, o.format);
}

/// The file of an object at the world's present frame.
std::vector<std::byte> encoded(const BakeOptions& o, const scene::Scene& scene, const sim::World& world,
                               std::size_t object) {
  const std::string& name = world.objectName(object);
  if (o.format != pointFormat) {
    const sim::Drawables drawables = world.drawables();
    const sim::Field* field = fieldOf(drawables, name);
    SIMREEL_CHECK(field != nullptr);
    return frame::encodeField(frame::parseFieldFormat(o.format), field->size, sim::fieldValues(*field));
  }
  const sim::PointTable table = world.object(object).points();
  const std::vector<std::string> comments = {
      fmt::format("simreel {}", version()), fmt::format("scene {}", scene.hash),
      fmt::format("object {} frame {} time {:g} s seed {}", name, world.frame(), world.time(), scene.seed)};
  return frame::encodePly(table.columns, table.values, comments);
}

void bake(const BakeOptions& o) {
  const scene::Scene scene = o.scene.load();
  std::vector<int> frames;
  if (o.frames)
    frames = frame::parseFrames(*o.frames);
  else
    for (int frame = 0; frame < scene.frameCount(); ++frame) frames.push_back(frame);
  frame::catchInterrupts();
  const gl::Context context({.device = o.device, .debug = false, .memoryPath = o.memoryPath});
  sim::World world(scene);
  const auto objects = bakedObjects(world, o.object, o.format == pointFormat);
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
      writeFileAtomically(fileOf(o, world.objectName(object), frame), encoded(o, scene, world, object));
      ++files;
    }
  }
  info("{} files -> {}", files,
       fileOf(o, world.objectName(objects.front()), frames.front()).string() + " ...");
}

}  // namespace

void addBake(CLI::App& app) {
  auto o = std::make_shared<BakeOptions>();
  auto* command = app.add_subcommand(
      "bake", "Write what a simulation computed as files, one a frame: points, or the values of fields");
  o->scene.add(*command);
  command->add_option("-o,--output", o->output, "Folder for NAME_000000.ply ...")->required();
  command->add_option("--format", o->format, "ply: points. npy or pfm: values of fields")
      ->check(CLI::IsMember({"ply", "npy", "pfm"}));
  command->add_option("--frames", o->frames, "Frames to write, for example 0-99x2,150; all are simulated");
  command->add_option("--object", o->object, "Only this object");
  command->add_option("--device", o->device, "Index or part of a name (see `simreel doctor`)");
  command->add_option("--memory-path", o->memoryPath,
                      "How kernels read: storage or texel (default: by driver)");
  command->add_flag("--overwrite", o->overwrite, "Replace files that exist");
  command->callback([o] { bake(*o); });
}

}  // namespace simreel::cli

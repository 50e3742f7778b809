// `simreel bake`: writes the results of a simulation to files that other programs read.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "batch/render/chosen_frames.hpp"
#include "cli/bake/files.hpp"
#include "cli/bake/maps.hpp"
#include "cli/bake/sequences.hpp"
#include "cli/bake/series.hpp"
#include "cli/bake/skins.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "frame/interrupt.hpp"
#include "frame/mesh/mesh_sequence.hpp"
#include "gl/context.hpp"
#include "scene/json/words.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
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
  std::string output, object, format, look;
  gl::ContextOptions on;
  std::vector<std::string> fields;  ///< names of the fields to write; if empty, all fields are written
  std::optional<std::string> frames;
  bool overwrite = false;
  bool sequence = false;  ///< true if all frames of an object are written to one file
};

/// A file that is written for each baked frame, with the object's index, the file's name and format.
struct BakedFile {
  static constexpr std::size_t wholeScene = std::numeric_limits<std::size_t>::max();
  std::size_t object;  ///< or wholeScene
  std::string name, format;
};

/// True if all objects are written into one file.
bool isWhole(const BakeOptions& o) {
  return o.format == "glb" && o.object.empty() && !o.sequence;
}

/// Returns the files of the object `o.object`, or of every object that can be written in the format. Throws
/// UserError(usage) if there are no such files.
std::vector<BakedFile> bakedFiles(const sim::World& world, const BakeOptions& o) {
  std::vector<BakedFile> files;
  std::string names, all;
  bool known = o.object.empty();
  for (std::size_t i = 0; i < world.objectCount(); ++i) {
    all += (all.empty() ? "" : ", ") + world.objectName(i);
    known = known || o.object == world.objectName(i);
  }
  if (!known)
    fail(ExitCode::usage, "--object: there is no \"{}\"; the scene has {}", o.object,
         all.empty() ? "no objects" : all);
  for (std::size_t i = 0; i < world.objectCount(); ++i) {
    const std::string format = formatFor(world, i, o.format);
    if (format.empty() || (o.sequence && !world.object(i).mesh())) continue;
    names += (names.empty() ? "" : ", ") + world.objectName(i);
    if (!o.object.empty() && o.object != world.objectName(i)) continue;
    for (const std::string& name : fileNames(world, i, format)) files.push_back({i, name, format});
  }
  if (files.empty() && names.empty())
    fail(ExitCode::usage, "no object of the scene has {} to bake", contentsOf(o.format));
  if (files.empty())
    fail(ExitCode::usage, "--object: there is no \"{}\" with {}; there is {}", o.object,
         contentsOf(o.format), names);
  const std::string stem = o.scene.file == "-" ? "scene" : fs::path(o.scene.file).stem().string();
  if (isWhole(o)) return {{BakedFile::wholeScene, stem, o.format}};
  return files;
}

/// Removes all files except the files of the fields that --fields names. Throws UserError(usage) for the
/// name of a field that does not exist.
void chooseFields(std::vector<BakedFile>& files, const std::vector<std::string>& fields) {
  if (fields.empty()) return;
  std::vector<std::string> names;
  for (const BakedFile& file : files) names.push_back(file.name);
  for (const std::string& field : fields)
    if (std::find(names.begin(), names.end(), field) == names.end())
      fail(ExitCode::usage, "--fields: the scene has no field \"{}\"; {}", field,
           scene::suggestion(field, names));
  std::erase_if(files, [&](const BakedFile& file) {
    return std::find(fields.begin(), fields.end(), file.name) == fields.end();
  });
}

fs::path fileOf(const BakeOptions& o, const BakedFile& baked, int frame) {
  return fs::path(o.output) / fmt::format("{}_{:06}.{}", baked.name, frame, baked.format);
}

/// Checks --sequence against --format. A sequence format implies --sequence. --sequence without --format
/// selects the first sequence format.
void settleSequence(BakeOptions& o) {
  if (o.format == "csv") return void(o.sequence = false);  // A CSV file is always one table for all frames.
  const auto& formats = frame::sequenceFormats;
  const bool known = std::find(formats.begin(), formats.end(), o.format) != formats.end();
  if (o.sequence && o.format.empty()) o.format = formats.front();
  if (o.sequence && !known && o.format != formats.front())
    fail(ExitCode::usage, "--sequence: {} holds one frame; take --format glb, pc2 or mdd", o.format);
  o.sequence = o.sequence || (known && o.format != "glb");
}

/// Returns the comment lines about an object, or about the whole scene, at the current frame.
std::vector<std::string> commentsOn(const scene::Scene& scene, const sim::World& world,
                                    std::size_t object) {
  std::vector<std::string> comments = {
      fmt::format("simreel {}", version()), fmt::format("scene {}", scene.hash),
      fmt::format(
          "{}frame {} time {:g} s seed {}",
          object == BakedFile::wholeScene ? "" : fmt::format("object {} ", world.objectName(object)),
          world.frame(), world.time(), scene.seed)};
  if (!scene.overrides.empty())
    comments.push_back("overrides " + oneLine(scene::asArguments(scene.overrides)));
  return comments;
}

void bakeFrames(const BakeOptions& o, const scene::Scene& scene, sim::World& world,
                const std::vector<BakedFile>& all, const std::vector<int>& frames) {
  for (const int frame : frames)
    for (const BakedFile& baked : all)
      if (const auto file = fileOf(o, baked, frame); !o.overwrite && pathExists(file))
        fail(ExitCode::inputOutput, "{} exists; use --overwrite to replace it", file.string());
  makeFolders(o.output);
  BakedSkins skins(scene, world);
  int files = 0;
  for (const int frame : frames) {
    if (!simulateTo(world, frame, files)) return;
    const auto pictures = [&](const scene::Material& material) { return skins.of(material); };
    for (const BakedFile& baked : all) {
      const std::vector<std::string> comments = commentsOn(scene, world, baked.object);
      writeFileAtomically(fileOf(o, baked, frame), baked.object == BakedFile::wholeScene
                                                       ? sceneGlb(world, comments, pictures)
                                                       : stateFile(world, baked.object, baked.name,
                                                                   baked.format, comments, pictures));
      ++files;
    }
  }
  info("{} files -> {}", files, fileOf(o, all.front(), frames.front()).string() + " ...");
}

/// Checks --fields against --format. Fields are written as npy files unless --format is pfm.
void settleFields(BakeOptions& o) {
  if (o.fields.empty()) return;
  if (o.format.empty() && !o.sequence) o.format = "npy";
  if (o.sequence || (o.format != "npy" && o.format != "pfm"))
    fail(ExitCode::usage, "--fields: fields are written as npy or pfm; take --format npy");
}

void bake(BakeOptions o) {
  settleFields(o);
  settleSequence(o);
  if (o.format == "maps")
    return bakeMaps({.scene = o.scene,
                     .output = o.output,
                     .object = o.object,
                     .look = o.look,
                     .on = o.on,
                     .frames = o.frames,
                     .overwrite = o.overwrite});
  if (!o.look.empty()) fail(ExitCode::usage, "--look needs --format maps");
  const scene::Scene scene = o.scene.load();
  const std::vector<int> frames = batch::chosenFrames(o.frames, scene);
  frame::catchInterrupts();
  frame::interruptFrames();
  const gl::Context context(o.on);
  sim::World world(scene);
  static_cast<void>(world.grow());  // Enlarges buffers of meshes that are too small for the first frame, so
                                    // that each object reports everything that it can write.
  if (o.format == "csv") return bakeSeries(scene, world, o.output, o.object, frames, o.overwrite);
  auto all = bakedFiles(world, o);
  chooseFields(all, o.fields);
  if (!o.sequence) return bakeFrames(o, scene, world, all, frames);
  std::vector<std::size_t> objects;
  objects.reserve(all.size());
  for (const BakedFile& baked : all) objects.push_back(baked.object);
  BakedSkins skins(scene, world);
  bakeSequences(world, {.format = o.format,
                        .output = o.output,
                        .objects = objects,
                        .frames = frames,
                        .fps = scene.time.fps,
                        .overwrite = o.overwrite,
                        .comments = [&](std::size_t object) { return commentsOn(scene, world, object); },
                        .skins = [&](const scene::Material& material) { return skins.of(material); }});
}

}  // namespace

void addBake(CLI::App& app) {
  auto o = std::make_shared<BakeOptions>();
  auto* command =
      app.add_subcommand("bake", "Write states, meshes, fields and materials for other programs");
  o->scene.add(*command);
  command->add_option("-o,--output", o->output, "Folder for NAME_000000.ply, NAME_000000_albedo.png ...")
      ->required();
  std::vector<std::string> formats(stateFormats.begin(), stateFormats.end());
  for (const char* more : {"csv", "pc2", "mdd", "maps"}) formats.emplace_back(more);
  command
      ->add_option(
          "--format", o->format,
          "ply: points or meshes; obj: meshes; glb (binary glTF): meshes and particles with their "
          "materials, all objects in one file if --object is left out; "
          "pc2, mdd: all frames of a mesh as a point cache, its first as obj beside it; svg, geojson: "
          "contours, and of caves the "
          "path and rooms; npy, pfm: values of fields, of caves the steps from the entrance too; rle: "
          "cells of automata; csv: what objects measure (`simreel list KIND`), all frames in a table; "
          "maps: of "
          "skins, textures that tile (albedo, normal with +y up, 16-bit height, "
          "roughness, occlusion; --size sets theirs). None given: rle, ply or npy, what there is")
      ->check(CLI::IsMember(formats));
  command->add_option(
      "--frames", o->frames,
      "Frames to write, for example 0-99x2,150 or last; left out: all, or the last for maps");
  command->add_option(
      "--look", o->look,
      "With --format maps: bake the fields themselves with this look (leather, spots, cracks or map); "
      "left out: bake the skins of materials");
  command
      ->add_option("--fields", o->fields,
                   "Only the fields of these names, OBJECT or OBJECT.PART; implies --format npy")
      ->delimiter(',');
  command->add_option("--object", o->object, "Only the object of this name");
  command->add_flag(
      "--sequence", o->sequence,
      "Write all frames of a mesh into one file, NAME.glb, as morph targets and an animation");
  addDevice(*command, o->on);
  command->add_flag("--overwrite", o->overwrite, "Replace files that exist");
  command->callback([o] { bake(*o); });
}

}  // namespace simreel::cli

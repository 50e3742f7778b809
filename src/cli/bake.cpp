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
#include "frame/obj.hpp"
#include "frame/ply.hpp"
#include "gl/context.hpp"
#include "sim/field_values.hpp"
#include "sim/world.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
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

/// Whether the format is one of fields; else it is of points and meshes.
bool ofFields(const BakeOptions& o) {
  return o.format == "npy" || o.format == "pfm";
}

/// The field that an object publishes at present, or null.
const sim::Field* fieldOf(const sim::Drawables& drawables, const std::string& object) {
  for (const sim::Field& field : drawables.fields)
    if (*field.name == object) return &field;
  return nullptr;
}

/// Objects that have what the format is for: the one asked for, or all.
std::vector<std::size_t> bakedObjects(const BakeOptions& o, const sim::World& world) {
  const char* what = ofFields(o) ? "a field" : "points or a deformed mesh";
  const std::string& wanted = o.object;
  const sim::Drawables drawables = world.drawables();
  std::vector<std::size_t> objects;
  std::string names;
  for (std::size_t i = 0; i < world.objectCount(); ++i) {
    const sim::Simulation& object = world.object(i);
    if (ofFields(o) ? fieldOf(drawables, world.objectName(i)) == nullptr
                    : object.points().columns.empty() && !object.mesh())
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

/// Position, normal and, where there is one, uv of each vertex; then the triangles.
std::vector<std::byte> meshPly(const sim::MeshTable& mesh, std::span<const std::string> comments) {
  std::vector<const char*> columns = {"x", "y", "z", "nx", "ny", "nz"};
  if (!mesh.uvs.empty()) columns.insert(columns.end(), {"s", "t"});
  std::vector<float> values;
  values.reserve(mesh.positions.size() * columns.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    const glm::vec3& n = mesh.normals[i];
    values.insert(values.end(), {p.x, p.y, p.z, n.x, n.y, n.z});
    if (!mesh.uvs.empty()) values.insert(values.end(), {mesh.uvs[i].x, mesh.uvs[i].y});
  }
  return frame::encodePly(columns, values, mesh.indices, comments);
}

void writeObject(const BakeOptions& o, const fs::path& file, const sim::Simulation& object,
                 const std::vector<std::string>& comments) {
  const std::optional<sim::MeshTable> mesh = object.mesh();
  if (o.format == "obj") {
    const std::string text = frame::encodeObj(*mesh, comments);
    return writeFileAtomically(file, text);
  }
  if (mesh) return writeFileAtomically(file, meshPly(*mesh, comments));
  const sim::PointTable table = object.points();
  writeFileAtomically(file, frame::encodePly(table.columns, table.values, comments));
}

std::vector<std::byte> fieldFile(const BakeOptions& o, const sim::World& world, const std::string& object) {
  const sim::Drawables drawables = world.drawables();
  const sim::Field* field = fieldOf(drawables, object);
  SIMREEL_CHECK(field != nullptr);
  return frame::encodeField(frame::parseFieldFormat(o.format), field->size, sim::fieldValues(*field));
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
  const auto objects = bakedObjects(o, world);
  for (const std::size_t object : objects)
    if (o.format == "obj" && !world.object(object).mesh())
      fail(ExitCode::usage, "--format obj: \"{}\" has points and no triangles; use ply, or --object",
           world.objectName(object));
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
      const fs::path file = fileOf(o, world.objectName(object), frame);
      if (ofFields(o)) {
        writeFileAtomically(file, fieldFile(o, world, world.objectName(object)));
      } else {
        const std::vector<std::string> comments = {
            fmt::format("simreel {}", version()), fmt::format("scene {}", scene.hash),
            fmt::format("object {} frame {} time {:g} s seed {}", world.objectName(object), frame,
                        world.time(), scene.seed)};
        writeObject(o, file, world.object(object), comments);
      }
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
      "bake", "Write points and deformed meshes (PLY, OBJ) or values of fields (NPY, PFM), a file a frame");
  o->scene.add(*command);
  command->add_option("-o,--output", o->output, "Folder for NAME_000000.ply ...")->required();
  command->add_option("--format", o->format, "ply or, of meshes, obj; of fields npy or pfm")
      ->check(CLI::IsMember({"ply", "obj", "npy", "pfm"}))
      ->capture_default_str();
  command->add_option("--frames", o->frames, "Frames to write, for example 0-99x2,150; all are simulated");
  command->add_option("--object", o->object, "Only this object");
  command->add_option("--device", o->device, "Index or part of a name (see `simreel doctor`)");
  command->add_option("--memory-path", o->memoryPath,
                      "How kernels read: storage or texel (default: by driver)");
  command->add_flag("--overwrite", o->overwrite, "Replace files that exist");
  command->callback([o] { bake(*o); });
}

}  // namespace simreel::cli

// Command `simreel kernels`: prints the contents of a shader file or the GLSL generated from it.
#include "kernels/kernels.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "cli/commands.hpp"
#include "cli/list/kernel_scene.hpp"
#include "cli/options/device_options.hpp"
#include "gl/context.hpp"
#include "scene/load.hpp"
#include "sim/kernels/kernels.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::cli {

namespace {

struct KernelsOptions {
  kernels::Request request;
  bool glsl = false;
  bool scene = false;
  std::string checked;  ///< scene file whose dispatches are checked for races
  gl::ContextOptions on;
  std::string format = "text";
  std::string race;
};

std::string typed(const kernels::Member& member) {
  std::string text = member.type + " " + member.name;
  for (const std::size_t length : member.array) text += length == 0 ? "[]" : fmt::format("[{}]", length);
  return text;
}

void describe(std::string& out, const std::vector<kernels::Member>& members, std::size_t indent) {
  for (const kernels::Member& member : members) {
    out += fmt::format("{:{}}{:5}  {}\n", "", indent, member.offset, typed(member));
    describe(out, member.members, indent + 2);
  }
}

const char* access(bool reads, bool writes) {
  return reads && writes ? "read and written" : writes ? "written" : reads ? "read" : "unused";
}

/// Describes a buffer. For an HLSL buffer (a single unsized array), prints the element type instead of the
/// member list.
void describe(std::string& out, const kernels::Buffer& buffer) {
  const bool plain =
      buffer.members.size() == 1 && buffer.members[0].array.size() == 1 && buffer.members[0].array[0] == 0;
  const std::string use = access(buffer.reads, buffer.writes);
  if (!buffer.counterOf.empty()) {
    out += fmt::format("  buffer {}: counter, {}, binding {}\n", buffer.name, use, buffer.binding);
    return;
  }
  if (!plain) {
    out += fmt::format("  buffer {}: {}, binding {}\n", buffer.name, use, buffer.binding);
    return describe(out, buffer.members, 4);
  }
  const kernels::Member& element = buffer.members[0];
  out += fmt::format("  buffer {}: {} of {} bytes each, {}, binding {}\n", buffer.name, element.type,
                     element.stride, use, buffer.binding);
  describe(out, element.members, 4);
}

std::string described(const kernels::Kernel& kernel) {
  std::string out =
      fmt::format("kernel {}: groups of {} threads\n", kernel.name, fmt::join(kernel.threads, " x "));
  for (const kernels::Buffer& buffer : kernel.buffers) describe(out, buffer);
  for (const kernels::Texture& texture : kernel.textures)
    out += fmt::format("  texture {}: {} of {}{}{}, {}, {} {}\n", texture.name, texture.type,
                       texture.values, texture.format.empty() ? "" : ", " + texture.format,
                       texture.sampler.empty() ? "" : ", sampler " + texture.sampler,
                       access(texture.reads, texture.writes),
                       texture.format.empty() && !texture.writes ? "unit" : "image", texture.binding);
  for (const kernels::Block& block : kernel.blocks) {
    out += block.name.empty() ? fmt::format("  constants, block {}\n", block.binding)
                              : fmt::format("  constants {}, block {}\n", block.name, block.binding);
    describe(out, block.members, 4);
  }
  return out;
}

std::string listed(const kernels::Shader& shader, const KernelsOptions& o) {
  if (o.format == "json") return kernels::toJson(shader, 2) + "\n";
  std::string out;
  if (o.scene) return sceneOf(shader, o.request.file);
  if (o.glsl) {
    for (const kernels::Kernel& kernel : shader.kernels)
      out += shader.kernels.size() == 1 ? kernel.glsl
                                        : fmt::format("// kernel {}\n{}\n", kernel.name, kernel.glsl);
    return out;
  }
  for (const auto& list : shader.keywords)
    out += fmt::format("keywords {}: {} unless --keyword says otherwise\n", fmt::join(list, ", "), list[0]);
  for (const kernels::Kernel& kernel : shader.kernels) out += described(kernel);
  return out;
}

/// Runs a scene's kernels and prints their races. Throws UserError if there are any.
void checkRaces(const KernelsOptions& o) {
  const scene::Scene scene = scene::loadScene(o.checked, {}, sim::kinds());
  const std::vector<std::filesystem::path> files = sim::shaderFiles(scene);
  if (std::none_of(files.begin(), files.end(), [&](const std::filesystem::path& file) {
        std::error_code error;
        return std::filesystem::equivalent(file, o.request.file, error);
      }))
    fail(ExitCode::usage, "{}: no object runs the shader {}", o.checked, o.request.file.string());
  const gl::Context context(o.on);
  sim::World world(scene);
  world.advanceTo(0);
  const std::vector<std::string> found = world.races();
  std::string lines;
  for (const std::string& line : found) lines += line + "\n";
  printText(lines);
  if (!found.empty())
    fail(ExitCode::different, "{}: {} place{} of its kernels race{}", o.checked, found.size(),
         found.size() == 1 ? "" : "s", found.size() == 1 ? "s" : "");
  info("simreel: {}: no kernel reads or writes what another invocation of the same dispatch writes",
       o.checked);
}

}  // namespace

void addKernels(CLI::App& app) {
  auto o = std::make_shared<KernelsOptions>();
  auto* command = app.add_subcommand("kernels",
                                     "Print what a file of compute shaders has (Unity's .compute, .hlsl, "
                                     "GLSL), or the GLSL that it becomes");
  command->add_option("file", o->request.file, "The shader file")->required();
  command->add_option("--kernel", o->request.kernels, "Only this kernel; may be given again")
      ->type_name("NAME");
  command->add_flag("--glsl", o->glsl, "Print the GLSL 4.5 that runs, with the same bits on every driver");
  command->add_flag("--scene", o->scene,
                    "Print a scene that runs the kernels, to start from: sizes and values are guesses");
  command->add_flag("--fast", o->request.fast,
                    "Keep the file as it is written, with the driver's own arithmetic");
  command->add_flag("--report", o->request.report,
                    "Add the code that notes reads and writes out of bounds, and loops at their limit");
  command
      ->add_option("--previous", o->request.previous,
                   "A buffer that kernels read as it was before the dispatch; may be given again")
      ->type_name("NAME");
  command
      ->add_option("--race", o->race,
                   "Add the code that records which invocation changes each word (record), or that "
                   "compares accesses with such a record (check)")
      ->check(CLI::IsMember({"record", "check"}));
  command->add_option("--max-iterations", o->request.maxIterations,
                      "Most iterations of a loop, which then ends (default 0: no limit)");
  command
      ->add_option("-I", o->request.folders,
                   "A folder that #include may read, beside the file's own; may be given again")
      ->type_name("FOLDER");
  command
      ->add_option(
          "--keyword", o->request.keywords,
          "The keyword to choose from a multi_compile list, instead of its first; may be given again")
      ->type_name("NAME");
  command->add_option("--format", o->format, "text (the default) or json")
      ->check(CLI::IsMember({"text", "json"}));
  const auto printing = command->get_options([](const CLI::Option* option) {
    return !option->get_positional() && option->get_name() != "--help";
  });
  auto* check =
      command
          ->add_option("--check", o->checked,
                       "Search the dispatches of this scene's first steps for races, and print them")
          ->type_name("SCENE");
  for (CLI::Option* option : printing) option->excludes(check);
  addDevice(*command, o->on);
  for (const char* name : {"--device", "--memory-path"}) command->get_option(name)->needs(check);
  command->callback([o] {
    if (!o->checked.empty()) return checkRaces(*o);
    if (o->race == "record") o->request.race = kernels::Race::record;
    if (o->race == "check") o->request.race = kernels::Race::check;
    printText(listed(kernels::load(o->request), *o));
  });
}

}  // namespace simreel::cli

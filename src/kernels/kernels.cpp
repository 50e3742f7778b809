#include "kernels/kernels.hpp"

#include "base/error.hpp"
#include "base/isolated.hpp"
#include "kernels/cache.hpp"
#include "kernels/compile/front_end.hpp"
#include "kernels/exact/bounds.hpp"
#include "kernels/exact/calls.hpp"
#include "kernels/exact/copies_back.hpp"
#include "kernels/exact/cubes.hpp"
#include "kernels/exact/limits.hpp"
#include "kernels/exact/refuse.hpp"
#include "kernels/exact/sampling.hpp"
#include "kernels/guards/loops.hpp"
#include "kernels/guards/previous.hpp"
#include "kernels/guards/race.hpp"
#include "kernels/guards/report.hpp"
#include "kernels/guards/shared.hpp"
#include "kernels/source/derivatives.hpp"
#include "kernels/source/files.hpp"
#include "kernels/source/pragmas.hpp"
#include "kernels/source/toy.hpp"
#include "kernels/spirv/layout.hpp"
#include "kernels/spirv/module.hpp"
#include "kernels/spirv/optimize.hpp"
#include "kernels/text/exits.hpp"
#include "kernels/text/glsl.hpp"
#include "kernels/text/reflect.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace simreel::kernels {

namespace {

/// Compiles a kernel, limits its loops, replaces inexact operations, and optimizes the module with
/// SPIRV-Tools.
Module prepared(Files& files, const Unit& unit, const Request& request, Report* report) {
  const bool hlsl = unit.language == Language::hlsl;
  if (hlsl)
    if (auto mistakes = variableGroups(files, unit.entry); !mistakes.empty()) files.fail(mistakes);
  Module compiled(compile(files, unit));
  if (auto mistakes = copyBack(compiled, files); !mistakes.empty()) files.fail(mistakes);
  if (auto mistakes = refused(compiled, files, request.fast); !mistakes.empty()) files.fail(mistakes);
  if (auto mistakes = beyondLimits(compiled, files, unit.entry, unit.line); !mistakes.empty())
    files.fail(mistakes);
  if (auto mistakes = hlsl                  ? withoutGroups(files, unit.entry)
                      : unit.before.empty() ? withoutLocalSize(files)
                                            : std::vector<Mistake>{};
      !mistakes.empty())
    files.fail(mistakes);
  const auto made = [&](bool unrolled) {
    Module module = compiled;
    if (report != nullptr || !request.previous.empty() || request.race == Race::check) repeatLines(module);
    if (request.maxIterations != 0) {
      limitLoops(module, request.maxIterations, unrolled, report);
      if (report != nullptr) report->hold(module);
    }
    if (!request.fast)
      linkLibrary(module, placeCalls(module, unit.language, request.careful), request.careful);
    return Module(optimized(module.words(), hlsl));
  };
  Module plain = made(!hlsl);
  return hlsl && request.maxIterations != 0 && keepsUnrolled(plain) ? made(true) : plain;
}

/// Marks the buffers that the runtime provides (reports, previous states, shadows) and sets the numbers of
/// guard elements.
void describeGuards(Kernel& kernel, bool fast) {
  for (Buffer& buffer : kernel.buffers) {
    if (buffer.name == reportBlock) kernel.report = buffer.binding;
    if (buffer.name.ends_with(previousSuffix))
      buffer.previousOf = buffer.name.substr(0, buffer.name.rfind('.'));
    if (buffer.name.ends_with(shadowSuffix)) {
      buffer.shadowOf = buffer.name.substr(0, buffer.name.rfind('.'));
      buffer.shadowWords = static_cast<int>(shadowWords);
      continue;
    }
    if (!fast && !buffer.members.empty() && !buffer.members.back().array.empty() &&
        buffer.members.back().array[0] == 0)
      buffer.guards = static_cast<int>(guardElements);
  }
  std::erase_if(kernel.buffers, [](const Buffer& buffer) { return buffer.name == reportBlock; });
}

Kernel lowered(Files& files, const Unit& unit, const Request& request) {
  Report reporting(files);
  Report* const report = request.report && request.race != Race::check ? &reporting : nullptr;
  Module module = prepared(files, unit, request, report);
  const bool hlsl = unit.language == Language::hlsl;
  if (auto mistakes = beyondShared(module, files, unit.line); !mistakes.empty()) files.fail(mistakes);
  const unsigned axes = axesRead(module);
  if (auto mistakes = readPrevious(module, files, hlsl, request.previous); !mistakes.empty())
    files.fail(mistakes);
  if (!request.fast) keepInside(module, report);
  const std::set<Id> cubes = flattenCubes(module);
  std::set<std::string> cubeNames;
  for (const Id cube : cubes) cubeNames.insert(module.name(cube));
  if (!request.fast || !cubes.empty()) filterExactly(module, cubes, request.fast, request.careful);
  layOut(module, hlsl);
  const std::uint32_t guards = request.fast ? 0 : guardElements;
  if (request.race == Race::record) recordWrites(module, hlsl, guards);
  if (request.race == Race::check) {
    checkAccesses(module, hlsl, guards, reporting);
    checkShared(module, reporting);
  }
  reporting.complete(module);
  bindResources(module);
  Kernel kernel = reflected(module, unit.language);
  kernel.axes = axes;
  describeGuards(kernel, request.fast);
  kernel.places = reporting.places();
  splitLoopExits(module);
  writeGlsl(module, kernel, !request.fast);
  for (Texture& texture : kernel.textures)
    if (cubeNames.contains(texture.name)) texture.type = "Cube";
  kernel.name = unit.entry;
  kernel.line = unit.line;
  return kernel;
}

/// Returns the declared kernels that the request selects, in the file's order.
std::vector<Announced> wanted(const Announcements& announced, const Request& request) {
  if (announced.kernels.empty())
    fail(ExitCode::usage,
         "{} has no kernel: it needs a line \"#pragma kernel NAME\" or a function with [numthreads(x, y, "
         "z)]; those of files that it includes do not count",
         request.file.string());
  std::vector<std::string> names;
  for (const Announced& kernel : announced.kernels) names.push_back(kernel.name);
  for (const std::string& name : request.kernels)
    if (std::find(names.begin(), names.end(), name) == names.end())
      fail(ExitCode::usage, "{} has no kernel {}; {}", request.file.string(), scene::inQuotes(name),
           scene::suggestion(name, names));
  std::vector<Announced> result;
  for (const Announced& kernel : announced.kernels)
    if (request.kernels.empty() ||
        std::find(request.kernels.begin(), request.kernels.end(), kernel.name) != request.kernels.end())
      result.push_back(kernel);
  return result;
}

std::vector<std::string> heldKeywords(const Announcements& announced, const Request& request) {
  std::vector<std::string> unknown;
  std::vector<std::string> held = announced.held(request.keywords, unknown);
  if (!unknown.empty()) {
    std::vector<std::string> known;
    for (const auto& list : announced.keywords) known.insert(known.end(), list.begin(), list.end());
    fail(ExitCode::usage, "{} has no keyword {}; {}", request.file.string(), scene::inQuotes(unknown[0]),
         known.empty() ? "it has no multi_compile" : scene::suggestion(unknown[0], known));
  }
  return held;
}

}  // namespace

namespace {

/// Loads the single kernel of a ShaderToy pass.
Shader loadToy(Files& files, const Request& request) {
  if (!isToy(files.text(0)))
    fail(ExitCode::usage, "{} has no function mainImage(out vec4, in vec2)", request.file.string());
  Unit unit{Language::glsl, "main", {}, 1};
  unit.before = textBefore(request.pass, usesDerivatives(files.text(0)));
  unit.behind = textBehind(files.text(0), request.pass, request.upsideDown);
  Shader shader;
  shader.language = "GLSL";
  shader.kernels.push_back(lowered(files, unit, request));
  shader.kernels.back().name = request.pass;
  for (const auto& path : files.read()) shader.files.push_back(path.string());
  return shader;
}

}  // namespace

Shader loadHere(const Request& request) {
  Files files(request.file, request.folders);
  if (!request.pass.empty()) return loadToy(files, request);
  const Announcements announced = announcements(files);
  const std::vector<std::string> keywords = heldKeywords(announced, request);
  Shader shader;
  shader.language = announced.language == Language::hlsl ? "HLSL" : "GLSL";
  shader.keywords = announced.keywords;
  for (const Announced& one : wanted(announced, request)) {
    Unit unit{announced.language, one.name, one.defines, one.line};
    for (const std::string& keyword : keywords) unit.defines.emplace_back(keyword, "1");
    try {
      shader.kernels.push_back(lowered(files, unit, request));
    } catch (const UserError&) {
      throw;
    } catch (const std::exception& error) {
      files.fail({{0, unit.line, unit.entry,
                   fmt::format("kernel {} cannot be written as GLSL 4.5: {}", scene::inQuotes(unit.entry),
                               error.what())}});
    }
  }
  for (const auto& path : files.read()) shader.files.push_back(path.string());
  return shader;
}

std::vector<std::string> kernelNames(const Request& request) {
  const Files files(request.file, request.folders);
  std::vector<std::string> names;
  for (const Announced& kernel : announcements(files).kernels) names.push_back(kernel.name);
  return names;
}

Shader load(const Request& request) {
  constexpr ProcessLimits allotment{std::size_t{2} << 30, 120};
  if (auto known = cachedShader(request)) return *known;
  try {
    Shader shader = fromJson(runIsolated(allotment, [&] { return toJson(loadHere(request)); }));
    keepShader(request, shader);
    return shader;
  } catch (const UserError&) {
    throw;
  } catch (const std::runtime_error& error) {
    fail(ExitCode::usage, "{}: the shader compiler {}", request.file.string(), error.what());
  }
}

}  // namespace simreel::kernels

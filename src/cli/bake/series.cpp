#include "cli/bake/series.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "cli/bake/files.hpp"

#include <cstddef>
#include <vector>

#include <fmt/format.h>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

/// Table of one object's quantities.
struct Series {
  std::size_t object;
  fs::path file;
  std::string text;
};

/// Returns the tables, which at first contain only the header line.
std::vector<Series> seriesOf(const scene::Scene& scene, const sim::World& world, const fs::path& output,
                             const std::string& object) {
  std::vector<Series> all;
  std::string measured;
  for (std::size_t i = 0; i < world.objectCount(); ++i) {
    const scene::Parameters& parameters = *scene.objects[i].parameters;
    if (!parameters.measures()) continue;
    const std::string& name = world.objectName(i);
    measured += (measured.empty() ? "" : ", ") + name;
    if (!object.empty() && object != name) continue;
    Series& one = all.emplace_back(Series{i, output / (name + ".csv"), "frame,time"});
    for (const scene::Quantity& quantity : parameters.quantities())
      one.text += fmt::format(",{}", quantity.name);
    one.text += "\n";
  }
  if (measured.empty())
    fail(ExitCode::usage,
         "no object of the scene measures a quantity; `simreel list KIND` names those of each kind");
  if (all.empty())
    fail(ExitCode::usage, "--object: \"{}\" is no object that measures a quantity; there is {}", object,
         measured);
  return all;
}

}  // namespace

void bakeSeries(const scene::Scene& scene, sim::World& world, const fs::path& output,
                const std::string& object, std::span<const int> frames, bool overwrite) {
  std::vector<Series> all = seriesOf(scene, world, output, object);
  for (const Series& one : all)
    if (!overwrite && pathExists(one.file))
      fail(ExitCode::inputOutput, "{} exists; use --overwrite to replace it", one.file.string());
  makeFolders(output);
  std::size_t rows = 0;
  for (const int frame : frames) {
    if (!simulateTo(world, frame, 0)) break;
    for (Series& one : all) {
      one.text += fmt::format("{},{}", frame, world.time());
      for (const double value : world.object(one.object).measure()) one.text += fmt::format(",{}", value);
      one.text += "\n";
    }
    ++rows;
  }
  for (const Series& one : all) writeFileAtomically(one.file, one.text);
  info("{} frames in {} {} -> {}", rows, all.size(), all.size() > 1 ? "files" : "file",
       all.front().file.string() + (all.size() > 1 ? " ..." : ""));
}

}  // namespace simreel::cli

// simreel new KIND: prints a commented scene that users can edit.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/wrap.hpp"
#include "cli/commands.hpp"
#include "cli/list/pages.hpp"
#include "scene/json/words.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

std::string starterText(std::string_view kind) {
  std::vector<std::string> known;
  for (const scene::Kind& one : sim::kinds().list) known.emplace_back(one.name);
  if (std::find(known.begin(), known.end(), kind) == known.end())
    fail(ExitCode::usage, "no starter scene is named {}; {}", scene::inQuotes(scene::printable(kind)),
         scene::suggestion(kind, known));
  return readFile(assetFolder() / "starters" / (std::string(kind) + ".json"), "starter scene");
}

namespace {

std::string startersText() {
  const std::size_t width = textWidth();
  std::string out = "Starter scenes:\n";
  for (const scene::Kind& kind : sim::kinds().list) out += listEntry(kind.name, kind.doc, 14, width);
  return out +
         "\nPrint one into a file and render it:\n  simreel new cloth > cloth.json\n"
         "  simreel render cloth.json -o cloth_####.png\n";
}

}  // namespace

void addNew(CLI::App& app) {
  auto kind = std::make_shared<std::string>();
  auto* command = app.add_subcommand(
      "new", "Print a small commented scene to start from: simreel new cloth > cloth.json");
  command->add_option("kind", *kind, "A kind of object, for example cloth; left out: the names of all");
  command->callback([kind] { printText(kind->empty() ? startersText() : starterText(*kind)); });
}

}  // namespace simreel::cli

// simreel list: prints pages about kinds of objects, sections of a scene or one parameter, and searches
// them.
#include "sim/world/list.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/wrap.hpp"
#include "cli/commands.hpp"
#include "cli/list/pages.hpp"
#include "cli/list/reference.hpp"
#include "scene/texts/help_page.hpp"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

struct ListOptions {
  std::string name, search, reference;
  std::string format = "text";
};

std::string listed(const ListOptions& o) {
  if (!o.search.empty()) {
    if (!o.name.empty() || o.format != "text")
      fail(ExitCode::usage, "--search searches everything and prints text; leave out {}",
           o.name.empty() ? "--format" : o.name);
    return searchText(o.search, textWidth());
  }
  if (o.format == "json") return o.name.empty() ? listJson() : pageJson(o.name);
  if (o.format == "markdown") return o.name.empty() ? listMarkdown() : pageMarkdown(o.name);
  if (o.name.empty()) return scene::listText(sim::kinds().list, textWidth());
  if (o.name.find('.') != std::string::npos) return parameterText(o.name, textWidth());
  return scene::helpText(o.name, sim::kinds().list, textWidth());
}

}  // namespace

void addList(CLI::App& app) {
  auto o = std::make_shared<ListOptions>();
  auto* command = app.add_subcommand(
      "list", "Print what a scene can hold, every parameter of one thing, or one parameter");
  command->add_option("name", o->name,
                      "A kind of object or a section (cloth, camera), or one parameter (cloth.pins); left "
                      "out: the names of all");
  command->add_option("--search", o->search, "Print every parameter whose name or sentence has these words")
      ->type_name("WORDS");
  command->add_option("--format", o->format, "text (the default), json or markdown")
      ->check(CLI::IsMember({"text", "json", "markdown"}));
  auto* reference =
      command
          ->add_option("--reference", o->reference,
                       "Write the whole reference as Markdown pages into this folder, and print nothing")
          ->type_name("FOLDER");
  for (const char* name : {"name", "--search", "--format"}) command->get_option(name)->excludes(reference);
  command->callback([o, &app] {
    if (!o->reference.empty()) return writeReference(o->reference, app);
    printText(listed(*o));
  });
}

}  // namespace simreel::cli

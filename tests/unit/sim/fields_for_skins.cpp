// Tests that skins may refer to every object that publishes a field.
#include "scene/scene.hpp"
#include "scene/texts/help_page.hpp"
#include "scene/texts/schema_text.hpp"
#include "sim/core/kind.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/world/list.hpp"

#include <set>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("every kind that publishes a field declares it") {
  std::set<std::string> fields;
  for (const scene::Kind& kind : sim::kinds().list) {
    scene::Object object;
    object.parameters = kind.makeParameters();
    if (sim::provides(object, sim::FieldSource::port)) fields.insert(kind.name);
  }
  std::set<std::string> displayed;  // Kinds of objects that can be drawn over the picture publish a field.
  for (const scene::Kind& kind : sim::kinds().list)
    if (scene::helpText(kind.name, sim::kinds().list, 100).find("\ndisplay") != std::string::npos ||
        scene::helpText(kind.name, sim::kinds().list, 100).find("\n  display") != std::string::npos)
      displayed.insert(kind.name);
  displayed.insert("flow");  // "flow" draws its field as a sheet in the world.
  CHECK(displayed.size() >= 4);
  CHECK(fields == displayed);
}

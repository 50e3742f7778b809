#include "sim/ports/field_source.hpp"

#include "base/error.hpp"
#include "sim/core/kind.hpp"
#include "sim/ports/landform.hpp"

namespace simreel::sim {

const PortInfo FieldSource::port = {
    .name = "field",
    .lacks = ", not a field",
    .none = "the scene has no field",
    .part = "field",
    .fits =
        [](const ObjectParameters& provider, const ObjectParameters& wanter) {
          const auto* theirs = dynamic_cast<const OwnCells*>(&provider);
          const auto* ours = dynamic_cast<const OwnCells*>(&wanter);
          return theirs != nullptr && ours != nullptr && ours->readsCellsOf(*theirs);
        },
};

const PortInfo Landform::port = {
    .name = "terrain",
    .lacks = ", which has no surface for lines of equal height",
    .none = "the scene has no mesh, water or terrain",
};

Field fieldNamed(const Links& links, const std::string& name) {
  Drawables drawables;
  if (const Simulation* owner = links.simulation(PartName(name).object))
    owner->publish(links.now(), drawables);
  for (const Field& field : drawables.fields)
    if (*field.name == name) return field;
  fail(ExitCode::usage, "no object has a field named \"{}\"", name);
}

}  // namespace simreel::sim

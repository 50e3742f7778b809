#include "sim/ports/color_scale.hpp"

#include "base/error.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/kind.hpp"
#include "sim/ports/field_source.hpp"

namespace simreel::sim {

const PortInfo ColorScale::port = {
    .name = "colour scale",
    .lacks = ", which is not drawn in colours of a scale",
    .none =
        "the scene has no field or contour, no particles, cloth or points with \"colorBy\", and no "
        "arrows or streamlines with \"colors\"",
    .when = When::afterFrame,
    .part = "field",
    .implied =
        [](const scene::Object& provider, std::vector<std::string>& parts) {
          for (const Ports::Offer& offer : portsOf(provider).offers)
            if (offer.port == &FieldSource::port && offer.given) {
              parts = offer.parts;
              return true;
            }
          return false;
        },
};

ShownQuantity shownQuantityOf(const Links& links, const std::string& name) {
  const PartName named(name);
  const scene::Object* const object = links.declared(named.object);
  if (object == nullptr) return {""};
  if (!named.part.empty()) {
    const auto* parts = dynamic_cast<const NamesParts*>(object->parameters.get());
    return parts == nullptr ? ShownQuantity{""} : parts->quantityOf(named.part);
  }
  const auto* shows = dynamic_cast<const ShowsQuantity*>(object->parameters.get());
  return shows == nullptr ? ShownQuantity{""} : shows->shownQuantity();
}

ColorScale colorScaleOf(const Links& links, const std::string& name) {
  const std::string object(PartName(name).object);
  Drawables drawables;
  const Simulation* const owner = links.simulation(object);
  if (const auto* scaled = dynamic_cast<const HasColorScale*>(owner)) return scaled->colorScale();
  if (owner != nullptr) owner->publish(links.now(), drawables);
  for (const Field& field : drawables.fields)
    if (*field.name == name && field.colors != nullptr) {
      if (field.ownColors)
        fail(ExitCode::usage,
             "\"{}\" is drawn in colours of its own, which a bar cannot explain; show a quantity, for a "
             "fluid \"show\": \"speed\"",
             name);
      // Cells that are bits have two classes, whose colours are also the ends of a map.
      ColorScale scale{*field.colors, field.range, field.categories || field.classes != nullptr, {}};
      if (field.classes != nullptr) scale.classes = *field.classes;
      return scale;
    }
  for (const Instances& instances : drawables.instances)
    if (instances.colors != nullptr && instances.colorBy != Instances::ColorBy::material)
      return {*instances.colors, instances.colorRange, false, {}};
  for (const Surface& surface : drawables.surfaces)
    if (surface.stops != nullptr) return {*surface.stops, surface.colorRange, false, {}};
  fail(ExitCode::usage, "\"{}\" is not drawn in colours of a scale", name);
}

}  // namespace simreel::sim

#include "sim/ports/measured.hpp"

#include "base/error.hpp"
#include "sim/core/kind.hpp"

namespace simreel::sim {

const PortInfo Measured::port = {
    .name = "quantity",
    .lacks = ", which measures nothing",
    .none = "none of this scene measures anything",
    .when = When::afterFrame,
    .part = "quantity",
    .partNeeded = true,
    .implied =
        [](const scene::Object& object, std::vector<std::string>& parts) {
          if (!object.parameters->measures()) return false;
          for (const scene::Quantity& quantity : object.parameters->quantities())
            parts.emplace_back(quantity.name);
          return true;
        },
};

QuantityReader::QuantityReader(const Links* links, const scene::Object& wanter) : links_(links) {
  for (const Ports::Want& want : portsOf(wanter).wants) {
    const PartName name(want.name);
    const scene::Object* owner = links == nullptr ? nullptr : links->declared(name.object);
    if (want.port != &Measured::port || owner == nullptr) continue;
    const auto known = owner->parameters->quantities();
    for (std::size_t i = 0; i < known.size(); ++i)
      if (name.part == known[i].name) indices_[want.name] = i;
  }
}

double QuantityReader::operator()(const std::string& object, const std::string& quantity) const {
  const auto found = indices_.find(object + "." + quantity);
  const Simulation* owner = found == indices_.end() ? nullptr : links_->simulation(object);
  if (owner != nullptr) return owner->measure().at(found->second);
  fail(ExitCode::usage, "no object \"{}\" measures \"{}\"", object, quantity);
}

}  // namespace simreel::sim

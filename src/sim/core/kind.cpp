#include "sim/core/kind.hpp"

#include <algorithm>

namespace simreel::sim {

Ports portsOf(const scene::Object& object) {
  Ports ports;
  if (const auto* parameters = dynamic_cast<const ObjectParameters*>(object.parameters.get()))
    parameters->ports(ports);
  return ports;
}

bool provides(const scene::Object& object, const PortInfo& port) {
  std::vector<std::string> parts;
  if (object.parameters != nullptr && port.implied != nullptr && port.implied(object, parts)) return true;
  const Ports ports = portsOf(object);
  return std::any_of(ports.offers.begin(), ports.offers.end(),
                     [&](const Ports::Offer& offer) { return offer.port == &port && offer.given; });
}

}  // namespace simreel::sim

#pragma once
#include "sim/core/port.hpp"
#include "sim/core/simulation.hpp"

#include <cstdint>
#include <memory>

namespace simreel::sim {

/// Parameters of a simulation.
struct ObjectParameters : scene::Parameters {
  /// Declares what the object provides to the others of a scene and what it takes from them.
  virtual void ports(Ports& /*ports*/) const {}
  /// Returns true where only a run tells the places that it goes to.
  [[nodiscard]] virtual bool wanders() const { return false; }
  /// Bytes of one buffer that it needs at least, as far as its parameters alone tell; and what software
  /// drivers (llvmpipe of Mesa 22) and small cards allow.
  [[nodiscard]] virtual std::int64_t leastBlockBytes() const { return 0; }
  static constexpr std::int64_t commonBlockBytes = std::int64_t{128} << 20;
};

/// Returns what an object declares; nothing where its parameters could not be read.
[[nodiscard]] Ports portsOf(const scene::Object& object);
/// Returns true where an object provides the port.
[[nodiscard]] bool provides(const scene::Object& object, const PortInfo& port);

/// What a scene says of an object of a kind whose parameters are `Parameters`.
template <class Parameters>
[[nodiscard]] const Parameters& parametersOf(const scene::Object& object) {
  return dynamic_cast<const Parameters&>(*object.parameters);
}

/// Makes a `Model` of an object and its setting.
template <class Model>
[[nodiscard]] std::unique_ptr<Simulation> makeSimulation(const scene::Object& object,
                                                         const Setting& setting) {
  return std::make_unique<Model>(object, setting);
}

/// An entry of the list of simulations; `check` and `make` as SimulationKind has them.
template <class Parameters, class Check, class Make>
[[nodiscard]] SimulationKind kindOf(const char* name, const char* summary, Check check, Make make) {
  return {{name, summary, [] { return std::make_unique<Parameters>(); }}, check, make};
}

}  // namespace simreel::sim

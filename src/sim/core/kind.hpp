#pragma once
#include "sim/core/port.hpp"
#include "sim/core/simulation.hpp"

#include <cstdint>
#include <memory>

namespace simreel::sim {

/// Parameters of a simulated object.
struct ObjectParameters : scene::Parameters {
  /// Declares what the object provides to other objects of the scene and what it takes from them.
  virtual void ports(Ports& /*ports*/) const {}
  /// Returns true if the object's motion is known only after simulating it.
  [[nodiscard]] virtual bool motionIsUnpredictable() const { return false; }
  /// Returns a lower bound, from the parameters alone, of the size in bytes of the largest single buffer.
  /// commonBlockBytes is the maximum buffer size of software drivers (llvmpipe of Mesa 22) and small
  /// graphics cards.
  [[nodiscard]] virtual std::int64_t minLargestBufferBytes() const { return 0; }
  static constexpr std::int64_t commonBlockBytes = std::int64_t{128} << 20;
};

/// Returns the ports that an object declares. The result is empty if the object's parameters could not be
/// read.
[[nodiscard]] Ports portsOf(const scene::Object& object);
/// Returns true if an object provides the port.
[[nodiscard]] bool provides(const scene::Object& object, const PortInfo& port);

/// Returns an object's parameters cast to their type `Parameters`. Throws std::bad_cast if the type
/// differs.
template <class Parameters>
[[nodiscard]] const Parameters& parametersOf(const scene::Object& object) {
  return dynamic_cast<const Parameters&>(*object.parameters);
}

/// Creates a simulation of class `Model` from a scene object and its Setting.
template <class Model>
[[nodiscard]] std::unique_ptr<Simulation> makeSimulation(const scene::Object& object,
                                                         const Setting& setting) {
  return std::make_unique<Model>(object, setting);
}

/// Returns an entry for the list of simulation kinds. See SimulationKind for `check` and `make`.
template <class Parameters, class Check, class Make>
[[nodiscard]] SimulationKind kindOf(const char* name, const char* summary, Check check, Make make) {
  return {{name, summary, [] { return std::make_unique<Parameters>(); }}, check, make};
}

}  // namespace simreel::sim

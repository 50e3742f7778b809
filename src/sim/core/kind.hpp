#pragma once
#include "sim/core/simulation.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace simreel::sim {

/// Parameters of a simulation, and what it is to the others of a scene.
struct ObjectParameters : scene::Parameters {
  /// Whether the object publishes a field, which a skin may be grown from.
  [[nodiscard]] virtual bool isField() const { return false; }
  /// Whether it publishes a path.
  [[nodiscard]] virtual bool findsPath() const { return false; }
  /// Whether it is a surface of heights that others fall onto; a scene has at most one.
  [[nodiscard]] virtual bool publishesHeights() const { return false; }
  /// Whether others touch it: a shape, a body, a mesh that collides.
  [[nodiscard]] virtual bool isTouched() const { return publishesHeights(); }
  /// Whether it asks for something to touch, which the scene should have.
  [[nodiscard]] virtual bool asksToCollide() const { return false; }
  /// What it keeps (m) from rigid meshes that collide; below 0: it touches none.
  [[nodiscard]] virtual double touchMargin() const { return -1; }
  /// Whether it is made of another object's field, and the name of that: an object, or NAME.u of one that
  /// has several.
  [[nodiscard]] virtual bool needsField() const { return false; }
  [[nodiscard]] virtual std::string readsField() const { return {}; }
  /// Whether it is a body with bones, which steps before those that it moves or touches.
  [[nodiscard]] virtual bool isBody() const { return false; }
  /// Whether cloths in contact feel its faces, and whether it is such a cloth.
  [[nodiscard]] virtual bool collidesByFaces() const { return false; }
  [[nodiscard]] virtual bool feelsFaces() const { return false; }
  /// The name of the cloth in contact that it meets, empty: none by name; and whether it meets all there
  /// are.
  [[nodiscard]] virtual std::string meetsCloth() const { return {}; }
  [[nodiscard]] virtual bool meetsAllCloths() const { return false; }
  /// Whether it is a cloth.
  [[nodiscard]] virtual bool isCloth() const { return false; }
  /// The bodies that it is tied to: their names, and where its parameters name them.
  struct Tie {
    std::string body;
    std::vector<std::string> path;
  };
  [[nodiscard]] virtual std::vector<Tie> ties() const { return {}; }
  /// Quantities of other objects that it tells of, and where its parameters name them.
  struct Named {
    std::string object, quantity;
    std::vector<std::string> path;
  };
  [[nodiscard]] virtual std::vector<Named> namesQuantities() const { return {}; }
  /// Whether it is a solid that others may collide with, and the name of that which it collides with
  /// itself; empty: none.
  [[nodiscard]] virtual bool hasWalls() const { return false; }
  [[nodiscard]] virtual std::string meetsWalls() const { return {}; }
  /// Whether others may take it as their wind. Nothing that blows takes wind itself, so it steps before
  /// them.
  [[nodiscard]] virtual bool blows() const { return false; }
  /// Bytes of one buffer that it needs at least, as far as its parameters alone tell; and what software
  /// drivers (llvmpipe of Mesa 22) and small cards allow.
  [[nodiscard]] virtual std::int64_t leastBlockBytes() const { return 0; }
  static constexpr std::int64_t commonBlockBytes = std::int64_t{128} << 20;
  /// The fluid that is its wind: its name (empty: none), and where its parameters name it.
  struct WindFrom {
    std::string fluid;
    std::vector<std::string> path;
  };
  [[nodiscard]] virtual WindFrom windFrom() const { return {}; }
};

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

#pragma once
#include "scene/scene.hpp"
#include "sim/core/port.hpp"
#include "sim/core/simulation.hpp"
#include "sim/world/step_order.hpp"

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

/// Registry of the outlets (typed interfaces) that a scene's objects provide, in the order in which the
/// objects are made.
class ObjectLinks final : public Links {
 public:
  /// Keeps a reference to `objects`, which must outlive this object. `now` returns the time of the current
  /// frame in seconds.
  ObjectLinks(std::span<const scene::Object> objects, std::function<double()> now);

  [[nodiscard]] const std::vector<StepNode>& order() const { return order_; }
  /// Registers an outlet that belongs to the scene rather than to an object.
  template <class T>
  void provide(T* outlet) {
    scene_[&T::port] = outlet;
  }
  /// Stores the simulation of an object and replaces an earlier one.
  void made(std::size_t object, std::unique_ptr<Simulation> simulation);
  [[nodiscard]] const std::vector<std::unique_ptr<Simulation>>& simulations() const { return simulations_; }
  /// Sets the number of steps that together() returns to the members of a group.
  void setSteps(const PortInfo& group, int steps) { groups_[&group].steps = steps; }

  [[nodiscard]] void* find(const PortInfo& port, std::string_view object) const override;
  [[nodiscard]] std::vector<void*> all(const PortInfo& port) const override;
  [[nodiscard]] GroupState together(const PortInfo& port) const override;
  [[nodiscard]] const Simulation* simulation(std::string_view object) const override;
  [[nodiscard]] const scene::Object* declared(std::string_view object) const override;
  [[nodiscard]] double now() const override { return now_(); }

 private:
  /// Returns the object's index, or the number of objects if the name is unknown.
  [[nodiscard]] std::size_t indexOf(std::string_view object) const;
  [[nodiscard]] void* outletOf(std::size_t object, const PortInfo& port) const;

  std::vector<std::string> names_;
  std::vector<const scene::Object*> declared_;
  std::function<double()> now_;
  std::vector<StepNode> order_;
  std::vector<std::unique_ptr<Simulation>> simulations_;
  std::vector<Outlets> outlets_;
  std::map<const PortInfo*, void*> scene_;
  std::map<const PortInfo*, GroupState> groups_;
};

}  // namespace simreel::sim

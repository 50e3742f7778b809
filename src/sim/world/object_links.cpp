#include "sim/world/object_links.hpp"

#include <algorithm>
#include <utility>

namespace simreel::sim {

ObjectLinks::ObjectLinks(std::span<const scene::Object> objects, std::function<double()> now)
    : now_(std::move(now)),
      order_(stepOrder(objects)),
      simulations_(objects.size()),
      outlets_(objects.size()) {
  for (const scene::Object& object : objects) {
    names_.push_back(object.name);
    declared_.push_back(&object);
  }
  for (const StepNode& node : order_)
    if (node.group != nullptr) groups_[node.group].led = true;
}

void ObjectLinks::made(std::size_t object, std::unique_ptr<Simulation> simulation) {
  simulations_[object] = std::move(simulation);
  outlets_[object] = {};
  simulations_[object]->connect(outlets_[object]);
}

void* ObjectLinks::find(const PortInfo& port, std::string_view object) const {
  if (!object.empty()) {
    const std::size_t i = indexOf(object);
    return i < names_.size() ? outletOf(i, port) : nullptr;
  }
  if (const auto own = scene_.find(&port); own != scene_.end()) return own->second;
  const std::vector<void*> found = all(port);
  return found.empty() ? nullptr : found.front();
}

std::vector<void*> ObjectLinks::all(const PortInfo& port) const {
  std::vector<void*> found;
  for (const StepNode& node : order_)
    for (const std::size_t object : node.objects)
      if (void* outlet = outletOf(object, port)) found.push_back(outlet);
  return found;
}

GroupState ObjectLinks::together(const PortInfo& port) const {
  const auto found = groups_.find(&port);
  return found == groups_.end() ? GroupState{} : found->second;
}

const Simulation* ObjectLinks::simulation(std::string_view object) const {
  const std::size_t i = indexOf(object);
  return i < names_.size() ? simulations_[i].get() : nullptr;
}

const scene::Object* ObjectLinks::declared(std::string_view object) const {
  const std::size_t i = indexOf(object);
  return i < names_.size() ? declared_[i] : nullptr;
}

std::size_t ObjectLinks::indexOf(std::string_view object) const {
  return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), object) - names_.begin());
}

void* ObjectLinks::outletOf(std::size_t object, const PortInfo& port) const {
  for (const Outlets::Outlet& outlet : outlets_[object].list)
    if (outlet.port == &port) return outlet.find();
  return nullptr;
}

}  // namespace simreel::sim

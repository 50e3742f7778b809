#include "sim/world/step_order.hpp"

#include "sim/core/kind.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::sim {

namespace {

using Objects = std::span<const scene::Object>;

/// Node and the indices of the nodes that must step before it.
struct Waiting {
  StepNode node;
  std::set<std::size_t> before;
};

/// Returns one node per object, or one node for all members of a group that has a leader.
std::vector<Waiting> nodesOf(Objects objects, const std::vector<Ports>& ports) {
  std::vector<Waiting> nodes;
  std::vector<Waiting> groups;
  const auto isLed = [&](const PortInfo* port) {
    return std::any_of(ports.begin(), ports.end(), [&](const Ports& one) {
      return std::any_of(one.joins.begin(), one.joins.end(),
                         [&](const Ports::Join& join) { return join.port == port && join.leads; });
    });
  };
  for (const bool leads : {true, false})
    for (std::size_t i = 0; i < objects.size(); ++i)
      for (const Ports::Join& join : ports[i].joins) {
        if (join.leads != leads || !isLed(join.port)) continue;
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const Waiting& one) { return one.node.group == join.port; });
        if (group == groups.end())
          groups.push_back({{{i}, join.port}, {}});
        else
          group->node.objects.push_back(i);
      }
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (std::none_of(groups.begin(), groups.end(), [&](const Waiting& group) {
          return std::count(group.node.objects.begin(), group.node.objects.end(), i) > 0;
        }))
      nodes.push_back({{{i}}, {}});
  nodes.insert(nodes.end(), groups.begin(), groups.end());
  return nodes;
}

/// Returns true if `object` reads the state that `provider` has at the end of the frame.
bool waitsFor(const Ports& object, const scene::Object& provider, const Ports& provided) {
  return std::any_of(object.wants.begin(), object.wants.end(), [&](const Ports::Want& want) {
    if (want.when != When::beforeStep) return false;
    if (!want.all) return PartName(want.name).object == provider.name;
    return std::any_of(provided.offers.begin(), provided.offers.end(),
                       [&](const Ports::Offer& offer) { return offer.given && offer.port == want.port; });
  });
}

std::vector<Waiting> waiting(Objects objects) {
  std::vector<Ports> ports;
  for (const scene::Object& object : objects) ports.push_back(portsOf(object));
  std::vector<Waiting> nodes = nodesOf(objects, ports);
  for (std::size_t here = 0; here < nodes.size(); ++here)
    for (std::size_t there = 0; there < nodes.size(); ++there) {
      if (here == there && nodes[here].node.group != nullptr) continue;
      for (const std::size_t i : nodes[here].node.objects)
        for (const std::size_t k : nodes[there].node.objects)
          if (waitsFor(ports[i], objects[k], ports[k])) nodes[here].before.insert(there);
    }
  return nodes;
}

/// Appends nodes to `order` as soon as all their predecessors are in it (topological sort). Returns the
/// nodes that cannot be sorted, because they are in a dependency cycle or depend on one.
std::vector<std::size_t> sort(const std::vector<Waiting>& nodes, std::vector<StepNode>& order) {
  std::vector<std::size_t> left(nodes.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  for (;;) {
    const auto next = std::find_if(left.begin(), left.end(), [&](std::size_t node) {
      return std::none_of(left.begin(), left.end(),
                          [&](std::size_t other) { return nodes[node].before.contains(other); });
    });
    if (next == left.end()) return left;
    order.push_back(nodes[*next].node);
    left.erase(next);
  }
}

}  // namespace

std::vector<StepNode> stepOrder(Objects objects) {
  const std::vector<Waiting> nodes = waiting(objects);
  std::vector<StepNode> order;
  for (const std::size_t node : sort(nodes, order)) order.push_back(nodes[node].node);
  return order;
}

void checkOrder(Objects objects, const scene::Report& report) {
  const std::vector<Waiting> nodes = waiting(objects);
  std::vector<StepNode> order;
  const std::vector<std::size_t> left = sort(nodes, order);
  if (left.empty()) return;
  // Each remaining node waits for another one, so following these dependencies leads back to a visited
  // node.
  std::vector<std::size_t> circle = {left.front()};
  for (;;) {
    const auto& before = nodes[circle.back()].before;
    const std::size_t next = *std::find_if(before.begin(), before.end(), [&](std::size_t node) {
      return std::find(left.begin(), left.end(), node) != left.end();
    });
    const auto seen = std::find(circle.begin(), circle.end(), next);
    if (seen != circle.end()) {
      circle.erase(circle.begin(), seen);
      break;
    }
    circle.push_back(next);
  }
  std::vector<std::string> names;
  for (const std::size_t node : circle)
    for (const std::size_t object : nodes[node].node.objects)
      names.push_back(fmt::format("\"{}\"", objects[object].name));
  report(
      objects[nodes[circle.front()].node.objects.front()], {},
      names.size() == 1
          ? fmt::format("object {} needs its own state at the end of the frame, so it cannot be stepped",
                        names.front())
          : fmt::format("objects {} depend on each other in a circle: each needs the state of the next at "
                        "the end of the frame, the last that of the first; none of them can step first",
                        fmt::join(names, ", ")));
}

}  // namespace simreel::sim

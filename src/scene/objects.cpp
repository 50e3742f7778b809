#include "scene/objects.hpp"

#include "scene/json/json_node.hpp"
#include "scene/json/words.hpp"
#include "scene/kind_hint.hpp"
#include "scene/own_colors.hpp"
#include "scene/papered.hpp"
#include "scene/sections.hpp"
#include "scene/value/reader.hpp"
#include "scene/value/value_reader.hpp"

#include <algorithm>
#include <charconv>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

/// Gives an object the default skin that its parameters name, if any.
void giveSkin(Object& object) {
  const auto* papered = dynamic_cast<const HasFieldSkin*>(object.parameters.get());
  const std::string field = papered == nullptr ? "" : papered->fieldShown(object.name);
  if (field.empty() || object.material.skin) return;
  object.material.skin.emplace();
  object.material.skin->field = field;
  object.material.skin->look = Skin::Look::map;
  object.material.skin->bump = 0;
}

/// Reads one object: exactly one member whose name is a kind, and an optional material.
Object readObject(const Node& node, ReadContext context, std::span<const Kind> kinds) {
  Object object;
  object.name = node.key;
  if (!isPlainName(node.key))
    context.diagnostics.add(node.headPlace(),
                            fmt::format("object name {} {}", inQuotes(node.key), plainNameText));
  if (!ValueReader("", context.diagnostics)
           .expect(node, Node::Kind::object, "an object, such as {\"sphere\": {}}"))
    return object;
  bool unknown = false;
  for (const Node& member : node.children) {
    if (member.key == "material") {
      for (const Node& key : member.children) object.materialKeys.insert(key.key);
      Reader::readObject(member, context, [&](Reader& fields) { object.material.describe(fields); });
      continue;
    }
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return member.key == k.name; });
    if (kind == kinds.end()) {
      context.diagnostics.add(member.headPlace(),
                              fmt::format("unknown kind of object {}; {}", inQuotes(member.key),
                                          hintForKind(member.key, kinds)));
      unknown = true;
    } else if (object.parameters != nullptr && object.kind != kind->name) {
      context.diagnostics.add(
          member.headPlace(),
          fmt::format("object \"{}\" is a \"{}\" already; an object has one kind", node.key, object.kind));
    } else {
      object.kind = kind->name;
      object.parameters = kind->makeParameters();
      Reader::readObject(member, context, [&](Reader& fields) { object.parameters->describe(fields); });
    }
  }
  remarkColors(node, object, context.diagnostics);
  giveSkin(object);
  const char* const drawnWith = object.parameters == nullptr ? nullptr : object.parameters->drawnWith();
  if (object.hasMaterial() && drawnWith != nullptr)
    context.diagnostics.remark(
        node.find("material")->headPlace(),
        fmt::format("\"{}\" is drawn with {}; here a material does nothing", node.key, drawnWith));
  if (object.parameters == nullptr && !unknown) {
    std::string names;
    for (const Kind& kind : kinds) names += fmt::format("{}{}", names.empty() ? "" : ", ", kind.name);
    context.diagnostics.add(node.headPlace(),
                            fmt::format("object \"{}\" has no kind; give it one of: {}", node.key, names));
  }
  return object;
}

/// Returns the member `key` of an object, or the list item with the zero-based index `key`. Returns null if
/// it does not exist.
const Node* memberOf(const Node& node, const std::string& key) {
  if (node.kind == Node::Kind::object) return node.find(key);
  std::size_t index = 0;
  const char* const end = key.data() + key.size();
  const auto [stop, error] = std::from_chars(key.data(), end, index);
  const bool isNumber = error == std::errc() && stop == end;
  return node.kind == Node::Kind::list && isNumber && index < node.children.size() ? &node.children[index]
                                                                                   : nullptr;
}

/// Deepest node that the scene gives on a path below an object.
struct PathEnd {
  const Node* node;
  bool whole;  ///< true if the scene gives the whole path
  [[nodiscard]] Place place() const { return whole ? node->place() : node->headPlace(); }
};
PathEnd endOf(const Node& object, const std::vector<std::string>& path) {
  const Node* node = &object;
  for (const std::string& key : path) {
    const Node* next = memberOf(*node, key);
    if (next == nullptr) return {node, false};
    node = next;
  }
  return {node, true};
}

}  // namespace

void readObjects(const Node& node, ReadContext context, const Kinds& kinds, bool hasGround,
                 std::vector<Object>& objects) {
  if (!ValueReader("", context.diagnostics)
           .expect(node, Node::Kind::object, "objects by name, such as {\"ball\": {\"sphere\": {}}}"))
    return;
  if (node.children.size() > maxObjects) {
    context.diagnostics.add(node.headPlace(), fmt::format("more than {} objects", maxObjects));
    return;
  }
  std::vector<bool> good;
  for (const Node& child : node.children) {
    const std::size_t errorsBefore = context.diagnostics.count();
    objects.push_back(readObject(child, context, kinds.list));
    good.push_back(context.diagnostics.count() == errorsBefore);
  }
  if (context.version > 1) keepStateColors(node, objects);
  if (!kinds.check) return;
  kinds.check(objects, hasGround,
              [&](const Object& object, const std::vector<std::string>& path, const std::string& message) {
                const auto i = static_cast<std::size_t>(&object - objects.data());
                const PathEnd end = endOf(node.children[i], path);
                // Some values of an object with errors are defaults. A message about such a value would be
                // misleading, so only values that were read without an error get messages.
                if (good[i] || (end.whole && !context.diagnostics.anyWithin(end.place())))
                  context.diagnostics.add(end.place(), message);
              });
}

}  // namespace simreel::scene

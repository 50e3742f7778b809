// Groups and lists that a Reader reads.
#include "scene/json/words.hpp"
#include "scene/value/group_example.hpp"
#include "scene/value/reader.hpp"
#include "scene/value/value_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

/// Returns the empty group {} that `true` stands for, at the position of `true`.
Node emptyGroup(const Node& word) {
  Node group;
  group.kind = Node::Kind::object;
  group.source = word.source;
  group.key = word.key;
  group.begin = word.begin;
  group.end = word.end;
  group.keyBegin = word.keyBegin;
  group.keyEnd = word.keyEnd;
  return group;
}

/// Returns the group {field: value} that the value stands for. `word`: node of the value, whose place
/// becomes the place of all parts of the group.
Node spelledOut(const Node& word, const std::string& field) {
  Node group = emptyGroup(word);
  group.children.push_back(word);
  group.children.front().key = field;
  group.children.front().keyBegin = group.children.front().keyEnd = 0;
  return group;
}

/// True if the node, given in place of a group, is the value of one of the group's fields.
bool isValue(const Node& node) {
  return node.kind != Node::Kind::object || node.find("keys") != nullptr;
}

}  // namespace

void Reader::section(const char* name, bool* present, const char* /*doc*/,
                     const std::function<void(Fields&)>& describe) {
  const Node* node = consume(name);
  if (present != nullptr) *present = node != nullptr;
  if (node != nullptr && switchable_.contains(name)) {
    if (const auto word = shorthands_.find(name);
        node->kind == Node::Kind::boolean && word != shorthands_.end())
      return readObject(spelledOut(*node, word->second), context_, describe);
    if (node->kind == Node::Kind::boolean) {
      *present = node->boolean;
      return node->boolean ? readObject(emptyGroup(*node), context_, describe) : void();
    }
    if (node->kind != Node::Kind::object && !shorthands_.contains(name))
      return context_.diagnostics.add(
          node->place(),
          fmt::format("expected {}, found {}",
                      std::string_view(name) == "ground" ? expectedGroup(name) : "an object or true",
                      node->kindText()));
  }
  if (const auto number = shortNumbers_.find(name); node != nullptr && number != shortNumbers_.end()) {
    if (node->kind == Node::Kind::number || node->find("keys") != nullptr)
      return readObject(spelledOut(*node, number->second), context_, describe);
    if (node->kind != Node::Kind::object)
      return context_.diagnostics.add(node->place(), fmt::format("expected an object or a {}, found {}",
                                                                 number->second, node->kindText()));
  }
  if (const auto word = shorthands_.find(name); node != nullptr && word != shorthands_.end()) {
    if (node->kind == Node::Kind::text)
      return readObject(spelledOut(*node, word->second), context_, describe);
    if (node->kind != Node::Kind::object)
      return context_.diagnostics.add(node->place(), fmt::format("expected an object or a {}, found {}",
                                                                 word->second, node->kindText()));
  }
  if (node != nullptr) return readObject(*node, context_, describe);
  if (present != nullptr) return;
  // An absent group is described as well, because its checks may involve values of other groups.
  Reader absent(nullptr, place_, context_);
  describe(absent);
}

void Reader::listOf(const char* name, const char* /*doc*/, std::size_t maxItems, std::size_t /*items*/,
                    const std::function<void(std::size_t)>& resize,
                    const std::function<void(Fields&, std::size_t)>& describe) {
  const Node* node = consume(name);
  if (node == nullptr || !ValueReader(name, context_.diagnostics)
                              .isList(*node, shorthands_.contains(name) ? "a list" : "a list of objects"))
    return;
  if (node->children.size() > maxItems) {
    context_.diagnostics.add(node->headPlace(), fmt::format("\"{}\" may have {} items, found {}", name,
                                                            maxItems, node->children.size()));
    return;
  }
  // The list starts empty, so that items of the scene do not inherit values of default items.
  resize(0);
  resize(node->children.size());
  const auto value = shorthands_.find(name);
  for (std::size_t i = 0; i < node->children.size(); ++i) {
    const Node& item = node->children[i];
    const bool isShort = value != shorthands_.end() && isValue(item);
    readObject(isShort ? spelledOut(item, value->second) : item, context_,
               [&](Reader& fields) { describe(fields, i); });
  }
}

void Reader::namedGroups(const char* name, const char* /*doc*/, const char* one, std::size_t maxItems,
                         const std::vector<std::string>& /*names*/,
                         const std::function<void(const std::vector<std::string>&)>& rename,
                         const std::function<void(Fields&, std::size_t)>& describe) {
  const Node* node = consume(name);
  if (node == nullptr) return;
  Diagnostics& diagnostics = context_.diagnostics;
  if (!ValueReader(name, diagnostics).expect(*node, Node::Kind::object, expectedGroup(name).c_str()))
    return;
  if (node->children.size() > maxItems)
    return diagnostics.add(node->headPlace(), fmt::format("a scene has at most {} {}, found {}", maxItems,
                                                          name, node->children.size()));
  std::vector<std::string> names;
  for (const Node& child : node->children) {
    names.push_back(child.key);
    if (!isPlainName(child.key))
      diagnostics.add(child.headPlace(),
                      fmt::format("{} name {} {}", one, inQuotes(child.key), plainNameText));
  }
  rename(names);
  const auto value = shorthands_.find(name);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Node& child = node->children[i];
    const bool isShort = value != shorthands_.end() && isValue(child);
    readObject(isShort ? spelledOut(child, value->second) : child, context_,
               [&](Reader& fields) { describe(fields, i); });
  }
}

}  // namespace simreel::scene

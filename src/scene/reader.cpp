#include "scene/reader.hpp"

#include "scene/value_reader.hpp"
#include "scene/words.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

/// One `[time, value]`; `readOne` reads the value.
template <class T, class ReadOne>
std::optional<typename Animated<T>::Key> readKey(const Node& node, const double* timeBefore,
                                                 Diagnostics& diagnostics, ReadOne readOne) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    diagnostics.add(node.place(), "expected a keyframe [time, value]");
    return std::nullopt;
  }
  const auto time = ValueReader("time", anyNumber, "s", diagnostics).number(node.children[0]);
  const auto value = readOne(node.children[1]);
  if (time && timeBefore != nullptr && !(*time > *timeBefore)) {
    diagnostics.add(node.children[0].place(),
                    fmt::format("keyframe times must increase; {} s follows {} s", *time, *timeBefore));
    return std::nullopt;
  }
  if (!time || !value) return std::nullopt;
  return typename Animated<T>::Key{*time, T(*value)};
}

/// A plain value, or {"keys": [[time, value], ...], "ease": "linear"}.
template <class T, class ReadOne>
void readAnimated(const Node& node, ReadContext context, Animated<T>& value, ReadOne readOne) {
  if (node.kind != Node::Kind::object) {
    if (const auto constant = readOne(node)) value = Animated<T>(T(*constant));
    return;
  }
  const std::size_t errorsBefore = context.diagnostics.count();
  std::vector<typename Animated<T>::Key> keys;
  int ease = 0;
  Reader::readObject(node, context, [&](Reader& fields) {
    const Node* list = fields.take("keys");
    fields.oneOf("ease", ease, {"linear", "smooth"}, "");
    if (list == nullptr) {
      context.diagnostics.add(node.headPlace(), "keyframes need \"keys\": [[time, value], ...]");
    } else if (list->kind != Node::Kind::list || list->children.empty()) {
      context.diagnostics.add(list->place(), "expected at least one keyframe, [[time, value], ...]");
    } else {
      for (const Node& item : list->children) {
        const double* before = keys.empty() ? nullptr : &keys.back().time;
        if (const auto key = readKey<T>(item, before, context.diagnostics, readOne)) keys.push_back(*key);
      }
    }
  });
  if (context.diagnostics.count() == errorsBefore)
    value = Animated<T>(std::move(keys), static_cast<Ease>(ease));
}

}  // namespace

Reader::Reader(const Node* object, Place place, ReadContext context)
    : object_(object), place_(place), context_(context), errorsBefore_(context.diagnostics.count()) {}

void Reader::readObject(const Node& node, ReadContext context,
                        const std::function<void(Reader&)>& describe) {
  if (!ValueReader("", context.diagnostics).expect(node, Node::Kind::object, "an object")) return;
  Reader reader(&node, node.headPlace(), context);
  describe(reader);
  reader.finish();
}

const Node* Reader::take(const char* name) {
  known_.emplace_back(name);
  return object_ == nullptr ? nullptr : object_->find(name);
}

void Reader::finish() {
  if (object_ == nullptr) return;
  for (const Node& child : object_->children) {
    if (context_.diagnostics.full()) return;
    if (std::find(known_.begin(), known_.end(), child.key) != known_.end()) continue;
    context_.diagnostics.add(child.headPlace(), fmt::format("unknown key {}; {}", inQuotes(child.key),
                                                            suggestion(child.key, known_)));
  }
}

void Reader::boolean(const char* name, bool& value, const char* /*doc*/) {
  if (const Node* node = take(name))
    if (const auto read = ValueReader(name, context_.diagnostics).boolean(*node)) value = *read;
}

void Reader::integer(const char* name, int& value, Range range, const char* unit, const char* /*doc*/) {
  if (const Node* node = take(name))
    if (const auto read = ValueReader(name, range, unit, context_.diagnostics).integer(*node))
      value = *read;
}

void Reader::number(const char* name, float& value, Range range, const char* unit, const char* /*doc*/) {
  if (const Node* node = take(name))
    if (const auto read = ValueReader(name, range, unit, context_.diagnostics).number(*node))
      value = static_cast<float>(*read);
}

void Reader::number(const char* name, double& value, Range range, const char* unit, const char* /*doc*/) {
  if (const Node* node = take(name))
    if (const auto read = ValueReader(name, range, unit, context_.diagnostics).number(*node)) value = *read;
}

void Reader::number(const char* name, Animated<float>& value, Range range, const char* unit,
                    const char* /*doc*/) {
  const ValueReader one(name, range, unit, context_.diagnostics);
  if (const Node* node = take(name))
    readAnimated(*node, context_, value, [&](const Node& part) { return one.number(part); });
}

void Reader::optionalNumber(const char* name, std::optional<double>& value, Range range, const char* unit,
                            const char* /*doc*/) {
  if (const Node* node = take(name))
    if (const auto read = ValueReader(name, range, unit, context_.diagnostics).number(*node)) value = *read;
}

void Reader::vector(const char* name, glm::vec3& value, Range range, const char* unit,
                    const char* /*doc*/) {
  if (const Node* node = take(name))
    if (const auto read = ValueReader(name, range, unit, context_.diagnostics).vector(*node)) value = *read;
}

void Reader::vector(const char* name, Animated<glm::vec3>& value, Range range, const char* unit,
                    const char* /*doc*/) {
  const ValueReader one(name, range, unit, context_.diagnostics);
  if (const Node* node = take(name))
    readAnimated(*node, context_, value, [&](const Node& part) { return one.vector(part); });
}

void Reader::pair(const char* name, glm::ivec2& value, Range range, const char* unit, const char* /*doc*/) {
  if (const Node* node = take(name))
    if (const auto read = ValueReader(name, range, unit, context_.diagnostics).pair(*node)) value = *read;
}

void Reader::pairs(const char* name, std::vector<glm::ivec2>& value, Range range, const char* unit,
                   const char* /*doc*/) {
  const ValueReader one(name, range, unit, context_.diagnostics);
  const Node* node = take(name);
  if (node == nullptr || !one.isList(*node, "a list of pairs [[a, b], ...]")) return;
  value.clear();
  for (const Node& item : node->children)
    if (const auto read = one.pair(item)) value.push_back(*read);
}

void Reader::text(const char* name, std::string& value, const char* /*doc*/) {
  if (const Node* node = take(name))
    if (auto read = ValueReader(name, context_.diagnostics).text(*node)) value = std::move(*read);
}

void Reader::integerOr(const char* name, std::optional<int>& value, const char* word, Range range,
                       const char* unit, const char* /*doc*/) {
  const Node* node = take(name);
  if (node == nullptr) return;
  if (node->kind == Node::Kind::text && node->text == word) {
    value.reset();
  } else if (node->kind != Node::Kind::number) {
    context_.diagnostics.add(
        node->place(),
        fmt::format("expected a whole number or \"{}\", found {}", word,
                    node->kind == Node::Kind::text ? inQuotes(node->text) : node->kindText()));
  } else if (const auto read = ValueReader(name, range, unit, context_.diagnostics).integer(*node)) {
    value = *read;
  }
}

void Reader::integers(const char* name, std::vector<int>& value, Range range, const char* unit,
                      const char* /*doc*/) {
  const ValueReader one(name, range, unit, context_.diagnostics);
  const Node* node = take(name);
  if (node == nullptr || !one.isList(*node, "a list of whole numbers")) return;
  value.clear();
  for (const Node& item : node->children)
    if (const auto read = one.integer(item)) value.push_back(*read);
}

void Reader::oneOf(const char* name, int& value, const std::vector<const char*>& names,
                   const char* /*doc*/) {
  if (const Node* node = take(name))
    if (const auto read = ValueReader(name, context_.diagnostics).oneOf(*node, names)) value = *read;
}

void Reader::someOf(const char* name, std::vector<int>& value, const std::vector<const char*>& names,
                    const char* /*doc*/) {
  const ValueReader one(name, context_.diagnostics);
  const Node* node = take(name);
  if (node == nullptr || !one.isList(*node, "a list of strings")) return;
  value.clear();
  for (const Node& item : node->children) {
    const auto read = one.oneOf(item, names);
    if (!read) continue;
    if (std::find(value.begin(), value.end(), *read) != value.end())
      context_.diagnostics.add(item.place(), fmt::format("{} is listed twice", inQuotes(item.text)));
    else
      value.push_back(*read);
  }
}

void Reader::asset(const char* name, std::filesystem::path& value, const char* /*doc*/) {
  const Node* node = take(name);
  if (node == nullptr) return;
  const auto read = ValueReader(name, context_.diagnostics).text(*node);
  if (!read) return;
  std::string problem;
  value = read->empty() ? std::filesystem::path() : context_.assets.find(*read, problem);
  if (!problem.empty()) context_.diagnostics.add(node->place(), problem);
}

void Reader::group(const char* name, const char* /*doc*/, const std::function<void(Fields&)>& describe) {
  if (const Node* node = take(name)) {
    readObject(*node, context_, describe);
    return;
  }
  // Described all the same: its cross checks may look at values of other groups.
  Reader absent(nullptr, place_, context_);
  describe(absent);
}

void Reader::optionalGroup(const char* name, bool& present, const char* /*doc*/,
                           const std::function<void(Fields&)>& describe) {
  const Node* node = take(name);
  present = node != nullptr;
  if (node != nullptr) readObject(*node, context_, describe);
}

void Reader::listOf(const char* name, const char* /*doc*/, std::size_t mostItems, std::size_t /*items*/,
                    const std::function<void(std::size_t)>& resize,
                    const std::function<void(Fields&, std::size_t)>& describe) {
  const Node* node = take(name);
  if (node == nullptr || !ValueReader(name, context_.diagnostics).isList(*node, "a list of objects"))
    return;
  if (node->children.size() > mostItems) {
    context_.diagnostics.add(node->headPlace(), fmt::format("\"{}\" may have {} items, found {}", name,
                                                            mostItems, node->children.size()));
    return;
  }
  // From nothing, so that no default item lends its values to a given one.
  resize(0);
  resize(node->children.size());
  for (std::size_t i = 0; i < node->children.size(); ++i)
    readObject(node->children[i], context_, [&](Reader& fields) { describe(fields, i); });
}

void Reader::error(const char* name, const std::string& message) {
  // A value that could not be read kept its default, which says nothing about the scene.
  if (context_.diagnostics.count() != errorsBefore_) return;
  const Node* node = object_ == nullptr ? nullptr : object_->find(name);
  context_.diagnostics.add(node == nullptr ? place_ : node->place(), message);
}

bool Reader::given(const char* name) const {
  return object_ != nullptr && object_->find(name) != nullptr;
}

}  // namespace simreel::scene

#include "scene/value/reader.hpp"

#include "base/log.hpp"
#include "scene/json/words.hpp"
#include "scene/value/group_example.hpp"
#include "scene/value/value_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

/// Reads one keyframe `[time, value]`. `before`: the keyframes read so far. `readOne` reads the value.
template <class T, class ReadOne>
std::optional<typename Animated<T>::Key> readKey(const Node& node,
                                                 const std::vector<typename Animated<T>::Key>& before,
                                                 Diagnostics& diagnostics, ReadOne readOne) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    diagnostics.add(node.place(), "expected a keyframe [time, value]");
    return std::nullopt;
  }
  const auto time = ValueReader("time", anyNumber, "s", diagnostics).number(node.children[0]);
  const auto value = readOne(node.children[1]);
  if (time && !before.empty() && *time < before.back().time) {
    diagnostics.add(node.children[0].place(), fmt::format("keyframe times must increase; {} s follows {} s",
                                                          *time, before.back().time));
    return std::nullopt;
  }
  if (time && before.size() > 1 && *time == before.back().time && *time == before[before.size() - 2].time) {
    diagnostics.add(node.children[0].place(),
                    fmt::format("two keyframes at one time are a jump; this is the third at {} s", *time));
    return std::nullopt;
  }
  if (!time || !value) return std::nullopt;
  return typename Animated<T>::Key{*time, T(*value)};
}

/// Reads a field's value from a node into a member of any type.
class MemberReader {
 public:
  MemberReader(const Node& node, const char* name, const Spec& spec, ReadContext context)
      : node_(node),
        one_(name, spec.range, spec.unit, context.diagnostics),
        spec_(spec),
        context_(context) {}

  void operator()(bool* value) const { set(value, one_.boolean(node_)); }
  void operator()(int* value) const { set(value, whole(node_)); }
  void operator()(float* value) const { set(value, one_.number(node_)); }
  void operator()(double* value) const { set(value, one_.number(node_)); }
  void operator()(std::string* value) const { set(value, one_.text(node_)); }
  void operator()(glm::vec3* value) const { set(value, vector(node_)); }
  void operator()(glm::ivec2* value) const { set(value, one_.pair(node_)); }
  void operator()(std::optional<double>* value) const {
    if (spec_.none != nullptr && node_.kind == Node::Kind::text && node_.text == spec_.none)
      value->reset();
    else if (spec_.none != nullptr && node_.kind != Node::Kind::number)
      context_.diagnostics.add(
          node_.place(),
          fmt::format("expected a number or \"{}\", found {}", spec_.none,
                      node_.kind == Node::Kind::text ? inQuotes(node_.text) : node_.kindText()));
    else
      set(value, one_.number(node_));
  }

  void operator()(Animated<float>* value) const {
    animated(*value, [&](const Node& part) { return one_.number(part); });
  }
  void operator()(Animated<glm::vec3>* value) const {
    animated(*value, [&](const Node& part) { return vector(part); });
  }

  void operator()(std::filesystem::path* value) const {
    const auto read = one_.text(node_);
    if (!read) return;
    std::string problem;
    *value = read->empty() ? std::filesystem::path() : context_.assets.find(*read, problem);
    if (!problem.empty()) context_.diagnostics.add(node_.place(), problem);
  }

  void operator()(std::optional<int>* value) const {
    if (node_.kind == Node::Kind::text && node_.text == spec_.none)
      value->reset();
    else if (node_.kind == Node::Kind::number)
      set(value, one_.integer(node_));
    else
      context_.diagnostics.add(
          node_.place(),
          fmt::format("expected a whole number or \"{}\", found {}", spec_.none,
                      node_.kind == Node::Kind::text ? inQuotes(node_.text) : node_.kindText()));
  }

  void operator()(std::vector<int>* values) const {
    if (!one_.isList(node_, spec_.words.empty() ? "a list of whole numbers" : "a list of strings")) return;
    values->clear();
    for (const Node& item : node_.children) {
      const auto read = whole(item);
      if (!read) continue;
      if (!spec_.words.empty() && std::find(values->begin(), values->end(), *read) != values->end())
        context_.diagnostics.add(item.place(), fmt::format("{} is listed twice", inQuotes(item.text)));
      else
        values->push_back(*read);
    }
  }

  void operator()(Formula* value) const {
    if (auto read = formula(node_)) *value = std::move(*read);
  }
  void operator()(Formulas* values) const {
    values->list.clear();
    if (node_.kind != Node::Kind::object || node_.find("keys") != nullptr) {
      if (auto read = formula(node_)) values->list.push_back({"", std::move(*read)});
      return;
    }
    for (const Node& one : node_.children)
      if (auto read = formula(one)) values->list.push_back({one.key, std::move(*read)});
  }

  void operator()(std::vector<glm::ivec2>* values) const {
    if (!one_.isList(node_, "a list of pairs [[a, b], ...]")) return;
    values->clear();
    for (const Node& item : node_.children)
      if (const auto read = one_.pair(item)) values->push_back(*read);
  }

 private:
  /// Reads a formula: a number, an expression, a list of them, or keyframes of up to four numbers.
  [[nodiscard]] std::optional<Formula> formula(const Node& node) const {
    Formula value;
    if (node.kind == Node::Kind::object) {
      Animated<glm::vec4> moving;
      const std::size_t errorsBefore = context_.diagnostics.count();
      animated(moving, node, [&](const Node& part) { return upToFour(part, value.width); });
      if (context_.diagnostics.count() != errorsBefore) return std::nullopt;
      value.moving = std::move(moving);
      return value;
    }
    if (!addParts(value, node)) return std::nullopt;
    return value;
  }
  bool addParts(Formula& value, const Node& node) const {
    if (node.kind == Node::Kind::list) {
      for (const Node& part : node.children)
        if (!addParts(value, part)) return false;
      if (node.children.empty()) context_.diagnostics.add(node.place(), "expected numbers or expressions");
      return !node.children.empty();
    }
    if (value.parts.size() == maxFormulaParts) {
      context_.diagnostics.add(
          node.place(), fmt::format("a value has at most {} numbers; a shader takes more from a buffer",
                                    maxFormulaParts));
      return false;
    }
    if (node.kind == Node::Kind::text) {
      value.parts.push_back({0, node.text});
    } else if (node.kind == Node::Kind::boolean) {
      value.parts.push_back({node.boolean ? 1.0 : 0.0});
    } else {
      if (!one_.expect(node, Node::Kind::number, "a number or an expression")) return false;
      value.parts.push_back({node.number});
    }
    return true;
  }
  /// Reads a number or a list of two to four numbers. `width`: number of components, which must be the same
  /// for all keyframes of a value.
  std::optional<glm::vec4> upToFour(const Node& node, int& width) const {
    const bool list = node.kind == Node::Kind::list;
    const std::size_t count = list ? node.children.size() : 1;
    if (count < 1 || count > 4 || (width != 0 && width != static_cast<int>(count))) {
      context_.diagnostics.add(
          node.place(), width == 0 ? "expected a number or a list of up to four numbers"
                                   : fmt::format("expected {} numbers, as in the keyframe before", width));
      return std::nullopt;
    }
    width = static_cast<int>(count);
    glm::vec4 numbers(0);
    for (std::size_t i = 0; i < count; ++i) {
      const auto read = one_.number(list ? node.children[i] : node);
      if (!read) return std::nullopt;
      numbers[static_cast<int>(i)] = static_cast<float>(*read);
    }
    return numbers;
  }

  [[nodiscard]] std::optional<glm::vec3> vector(const Node& node) const {
    return spec_.color ? one_.color(node) : one_.vector(node, spec_.flat);
  }
  [[nodiscard]] std::optional<int> whole(const Node& node) const {
    return spec_.words.empty() ? one_.integer(node) : one_.oneOf(node, spec_.words);
  }

  template <class T, class Read>
  static void set(T* value, const std::optional<Read>& read) {
    if (read) *value = static_cast<T>(*read);
  }

  /// Reads a plain value, or {"keys": [[time, value], ...], "ease": "linear"}.
  template <class T, class ReadOne>
  void animated(Animated<T>& value, ReadOne readOne) const {
    animated(value, node_, readOne);
  }
  template <class T, class ReadOne>
  void animated(Animated<T>& value, const Node& node, ReadOne readOne) const {
    if (node.kind != Node::Kind::object) {
      if (const auto constant = readOne(node)) value = Animated<T>(T(*constant));
      return;
    }
    const std::size_t errorsBefore = context_.diagnostics.count();
    std::vector<typename Animated<T>::Key> keys;
    int ease = 0;
    Reader::readObject(node, context_, [&](Reader& fields) {
      const Node* list = fields.consume("keys");
      fields.oneOf("ease", ease, {easeWords.begin(), easeWords.end()}, "");
      if (list == nullptr) {
        context_.diagnostics.add(node.headPlace(), "keyframes need \"keys\": [[time, value], ...]");
      } else if (list->kind != Node::Kind::list || list->children.empty()) {
        context_.diagnostics.add(list->place(), "expected at least one keyframe, [[time, value], ...]");
      } else {
        for (const Node& item : list->children) {
          if (const auto key = readKey<T>(item, keys, context_.diagnostics, readOne)) keys.push_back(*key);
        }
      }
    });
    if (context_.diagnostics.count() == errorsBefore)
      value = Animated<T>(std::move(keys), static_cast<Ease>(ease));
  }

  const Node& node_;
  ValueReader one_;
  const Spec& spec_;
  ReadContext context_;
};

/// Returns the list item with the zero-based index `number`. Returns the list if there is no such item.
const Node* itemOf(const Node& list, const std::string& number) {
  std::size_t at = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), at);
  const bool found =
      error == std::errc() && end == number.data() + number.size() && at < list.children.size();
  return found ? &list.children[at] : &list;
}

/// Returns the index in `written` (source text with quotes and escapes) that corresponds to byte `at` of
/// the decoded string.
std::size_t byteWritten(std::string_view written, std::size_t at) {
  std::size_t i = 1, read = 0;
  while (i + 1 < written.size() && read < at) {
    if (written[i] != '\\') {
      ++i, ++read;
    } else if (written[i + 1] != 'u') {
      i += 2, ++read;
    } else {
      const long code = std::strtol(std::string(written.substr(i + 2, 4)).c_str(), nullptr, 16);
      const bool pair = code >= 0xd800 && code < 0xdc00;
      i += pair ? 12 : 6;
      read += pair ? 4 : code < 0x80 ? 1 : code < 0x800 ? 2 : 3;
    }
  }
  return std::min(i, written.size());
}

}  // namespace

Reader::Reader(const Node* object, Place place, ReadContext context)
    : object_(object), place_(place), context_(context), errorsBefore_(context.diagnostics.count()) {}

void Reader::readObject(const Node& node, ReadContext context,
                        const std::function<void(Reader&)>& describe) {
  if (!ValueReader("", context.diagnostics)
           .expect(node, Node::Kind::object, expectedGroup(node.key).c_str()))
    return;
  Reader reader(&node, node.headPlace(), context);
  describe(reader);
  reader.finish();
}

const Node* Reader::consume(const char* name) {
  known_.emplace_back(name);
  return find(name);
}

const Node* Reader::find(const std::string& name) const {
  if (object_ == nullptr) return nullptr;
  const auto old = formerNames_.find(name);
  return object_->find(old == formerNames_.end() ? name : old->second);
}

const Node* Reader::at(const std::string& path) const {
  std::size_t end = path.find('.');
  const Node* node = find(path.substr(0, end));
  while (node != nullptr && end != std::string::npos) {
    const std::size_t begin = end + 1;
    end = path.find('.', begin);
    if (node->kind != Node::Kind::object) return nullptr;
    node = node->find(std::string_view(path).substr(begin, end - begin));
  }
  return node;
}

void Reader::formerly(const char* old, const char* name) {
  if (object_ == nullptr || object_->find(old) == nullptr) return;
  if (object_->find(name) != nullptr)
    return;  // If the scene gives both names, the former name is an unknown key.
  formerNames_[name] = old;
  known_.emplace_back(old);
  warn("{}: \"{}\" is called \"{}\" now", context_.diagnostics.where(object_->find(old)->headPlace()), old,
       name);
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

void Reader::field(const char* name, Member member, const Spec& spec) {
  if (const Node* node = consume(name)) std::visit(MemberReader(*node, name, spec, context_), member);
}

void Reader::error(const char* name, const std::string& message) {
  // After an error, some values may be defaults, so a message that compares values would be misleading.
  if (context_.diagnostics.count() != errorsBefore_) return;
  const Node* node = find(name);
  context_.diagnostics.add(node == nullptr ? place_ : node->place(), message);
}

void Reader::errorIn(const std::vector<std::string>& path, std::size_t begin, std::size_t end,
                     const std::string& message) {
  if (context_.diagnostics.count() != errorsBefore_) return;
  const Node* node = object_;
  for (const std::string& member : path) {
    if (node != nullptr && node->kind == Node::Kind::object)
      node = node->find(member);
    else if (node != nullptr && node->kind == Node::Kind::list)
      node = itemOf(*node, member);
  }
  if (node == object_ || node == nullptr) return context_.diagnostics.add(place_, message);
  Place place = node->place();
  if (node->kind == Node::Kind::text) {
    const std::string_view written = context_.diagnostics.textAt(place);
    place.end = node->begin + byteWritten(written, std::max(end, begin + 1));
    place.begin = node->begin + byteWritten(written, begin);
  }
  context_.diagnostics.add(place, message);
}

void Reader::idle(const char* name, const char* ruler, const std::string& message) {
  Diagnostics& diagnostics = context_.diagnostics;
  if (diagnostics.count() != errorsBefore_) return;
  const Node* node = at(name);
  if (node == nullptr) return;
  const Node* by = at(ruler);
  if (by != nullptr && diagnostics.isOverride(by->source) && !diagnostics.isOverride(node->source)) return;
  diagnostics.remark(node->headPlace(), message);
}

bool Reader::given(const char* name) const {
  return find(name) != nullptr;
}

}  // namespace simreel::scene

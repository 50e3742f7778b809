#include "scene/reader.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "base/file.hpp"

namespace simreel::scene {

namespace {

std::string withUnit(double value, const char* unit) {
  return *unit == '\0' ? fmt::format("{:g}", value) : fmt::format("{:g} {}", value, unit);
}

std::vector<std::string> strings(const std::vector<const char*>& names) {
  return {names.begin(), names.end()};
}

bool isInside(const std::filesystem::path& file, const std::filesystem::path& folder) {
  if (folder.empty()) return false;
  const auto [end, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() || (end->empty() && std::next(end) == folder.end());
}

}  // namespace

const Node* Reader::take(const char* name) {
  known_.emplace_back(name);
  return object_.find(name);
}

void Reader::finish() {
  for (std::size_t i = 0; i < object_.keys.size(); ++i) {
    const std::string& key = object_.keys[i];
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    context_.diagnostics.error(object_.keyPlaces[i],
                               fmt::format("unknown key \"{}\"; {}", key, suggestion(key, known_)));
  }
}

void Reader::error(const char* name, const std::string& message) {
  const Node* node = object_.find(name);
  context_.diagnostics.error(node != nullptr ? node->place : object_.place, message);
}

bool Reader::expect(const Node& node, Node::Kind kind, const char* wanted) {
  if (node.kind == kind) return true;
  context_.diagnostics.error(node.place, fmt::format("expected {}, found {}", wanted, kindName(node.kind)));
  return false;
}

bool Reader::readNumber(const Node& node, Range range, const char* unit, double& value) {
  if (!expect(node, Node::Kind::number, "a number")) return false;
  if (!(node.number >= range.least && node.number <= range.most)) {
    context_.diagnostics.error(node.place, fmt::format("{:g} is outside the range {:g} to {}", node.number, range.least,
                                                       withUnit(range.most, unit)));
    return false;
  }
  value = node.number;
  return true;
}

bool Reader::readInteger(const Node& node, Range range, const char* unit, int& value) {
  double number = 0;
  const Range held{std::max(range.least, -2147483648.0), std::min(range.most, 2147483647.0)};
  if (!readNumber(node, held, unit, number)) return false;
  if (number != std::floor(number)) {
    context_.diagnostics.error(node.place, fmt::format("expected a whole number, found {:g}", number));
    return false;
  }
  value = static_cast<int>(number);
  return true;
}

bool Reader::readVector(const Node& node, Range range, const char* unit, glm::vec3& value) {
  if (node.kind != Node::Kind::list || node.items.size() != 3) {
    context_.diagnostics.error(
        node.place, node.kind == Node::Kind::list
                        ? fmt::format("expected a list of 3 numbers, found {} items", node.items.size())
                        : fmt::format("expected a list of 3 numbers, found {}", kindName(node.kind)));
    return false;
  }
  bool good = true;
  for (int i = 0; i < 3; ++i) {
    double number = 0;
    good = readNumber(node.items[static_cast<std::size_t>(i)], range, unit, number) && good;
    if (good) value[i] = static_cast<float>(number);
  }
  return good;
}

bool Reader::readPair(const Node& node, Range range, const char* unit, glm::ivec2& value) {
  if (node.kind != Node::Kind::list || node.items.size() != 2) {
    context_.diagnostics.error(node.place, fmt::format("expected a list of 2 whole numbers, found {}",
                                                       node.kind == Node::Kind::list
                                                           ? fmt::format("{} items", node.items.size())
                                                           : kindName(node.kind)));
    return false;
  }
  glm::ivec2 read = value;
  const bool good = readInteger(node.items[0], range, unit, read.x);
  if (!readInteger(node.items[1], range, unit, read.y) || !good) return false;
  value = read;
  return true;
}

bool Reader::readName(const Node& node, const std::vector<const char*>& names, int& value) {
  if (!expect(node, Node::Kind::text, "a name")) return false;
  const auto found = std::find(names.begin(), names.end(), node.text);
  if (found == names.end()) {
    context_.diagnostics.error(node.place,
                               fmt::format("unknown name \"{}\"; {}", node.text, suggestion(node.text, strings(names))));
    return false;
  }
  value = static_cast<int>(found - names.begin());
  return true;
}

template <class T, class ReadValue>
void Reader::animated(const char* name, Animated<T>& value, ReadValue readValue) {
  const Node* node = take(name);
  if (node == nullptr) return;
  T constant{};
  if (node->kind != Node::Kind::object) {
    if (readValue(*node, constant)) value = Animated<T>(constant);
    return;
  }
  Reader inner(*node, context_);
  int ease = 0;
  inner.oneOf("ease", ease, {"linear", "smooth"}, "");
  const Node* list = inner.take("keys");
  inner.finish();
  if (list == nullptr || list->kind != Node::Kind::list || list->items.empty()) {
    context_.diagnostics.error(list == nullptr ? node->place : list->place,
                               "keyframes need \"keys\": a list of [time, value]");
    return;
  }
  std::vector<typename Animated<T>::Key> keys;
  for (const Node& item : list->items) {
    double time = 0;
    if (item.kind != Node::Kind::list || item.items.size() != 2) {
      context_.diagnostics.error(item.place, "a keyframe is [time, value]");
      return;
    }
    if (!readNumber(item.items[0], anyNumber, "s", time) || !readValue(item.items[1], constant)) return;
    if (!keys.empty() && time <= keys.back().time) {
      context_.diagnostics.error(item.items[0].place, fmt::format("keyframe times must grow: {:g} comes after {:g}",
                                                                  time, keys.back().time));
      return;
    }
    keys.push_back({time, constant});
  }
  value = Animated<T>(std::move(keys), static_cast<Ease>(ease));
}

void Reader::boolean(const char* name, bool& value, const char* /*doc*/) {
  const Node* node = take(name);
  if (node != nullptr && expect(*node, Node::Kind::boolean, "true or false")) value = node->boolean;
}

void Reader::integer(const char* name, int& value, Range range, const char* unit, const char* /*doc*/) {
  if (const Node* node = take(name)) readInteger(*node, range, unit, value);
}

void Reader::number(const char* name, float& value, Range range, const char* unit, const char* doc) {
  double wide = value;
  const bool present = given(name);
  number(name, wide, range, unit, doc);
  if (present) value = static_cast<float>(wide);
}

void Reader::number(const char* name, double& value, Range range, const char* unit, const char* /*doc*/) {
  if (const Node* node = take(name)) readNumber(*node, range, unit, value);
}

void Reader::number(const char* name, Animated<float>& value, Range range, const char* unit, const char* /*doc*/) {
  animated(name, value, [&](const Node& node, float& read) {
    double number = 0;
    if (!readNumber(node, range, unit, number)) return false;
    read = static_cast<float>(number);
    return true;
  });
}

void Reader::vector(const char* name, glm::vec3& value, Range range, const char* unit, const char* /*doc*/) {
  if (const Node* node = take(name)) readVector(*node, range, unit, value);
}

void Reader::vector(const char* name, Animated<glm::vec3>& value, Range range, const char* unit, const char* /*doc*/) {
  animated(name, value, [&](const Node& node, glm::vec3& read) { return readVector(node, range, unit, read); });
}

void Reader::pair(const char* name, glm::ivec2& value, Range range, const char* unit, const char* /*doc*/) {
  if (const Node* node = take(name)) readPair(*node, range, unit, value);
}

void Reader::pairs(const char* name, std::vector<glm::ivec2>& value, Range range, const char* unit,
                   const char* /*doc*/) {
  const Node* node = take(name);
  if (node == nullptr || !expect(*node, Node::Kind::list, "a list")) return;
  value.clear();
  for (const Node& item : node->items) {
    glm::ivec2 read{};
    if (readPair(item, range, unit, read)) value.push_back(read);
  }
}

void Reader::text(const char* name, std::string& value, const char* /*doc*/) {
  const Node* node = take(name);
  if (node != nullptr && expect(*node, Node::Kind::text, "a string")) value = node->text;
}

void Reader::integerOr(const char* name, std::optional<int>& value, const char* word, Range range, const char* unit,
                       const char* /*doc*/) {
  const Node* node = take(name);
  if (node == nullptr) return;
  int read = 0;
  if (node->kind == Node::Kind::text && node->text == word)
    value.reset();
  else if (node->kind == Node::Kind::text)
    context_.diagnostics.error(node->place, fmt::format("expected a whole number or \"{}\", found \"{}\"", word, node->text));
  else if (readInteger(*node, range, unit, read))
    value = read;
}

void Reader::integers(const char* name, std::vector<int>& value, Range range, const char* unit, const char* /*doc*/) {
  const Node* node = take(name);
  if (node == nullptr || !expect(*node, Node::Kind::list, "a list of whole numbers")) return;
  value.clear();
  for (const Node& item : node->items) {
    int read = 0;
    if (readInteger(item, range, unit, read)) value.push_back(read);
  }
}

void Reader::oneOf(const char* name, int& value, const std::vector<const char*>& names, const char* /*doc*/) {
  if (const Node* node = take(name)) readName(*node, names, value);
}

void Reader::someOf(const char* name, std::vector<int>& value, const std::vector<const char*>& names,
                    const char* /*doc*/) {
  const Node* node = take(name);
  if (node == nullptr || !expect(*node, Node::Kind::list, "a list of names")) return;
  value.clear();
  for (const Node& item : node->items) {
    int read = 0;
    if (readName(item, names, read)) value.push_back(read);
  }
}

void Reader::asset(const char* name, std::filesystem::path& value, const char* /*doc*/) {
  const Node* node = take(name);
  if (node == nullptr || !expect(*node, Node::Kind::text, "a file name")) return;
  if (node->text.empty()) return value.clear();
  if (node->text.find('\0') != std::string::npos)
    return context_.diagnostics.error(node->place, "a file name holds no zero character");
  std::error_code code;
  const auto folders = {std::filesystem::weakly_canonical(context_.sceneFolder, code),
                        std::filesystem::weakly_canonical(assetFolder(), code)};
  bool outside = false;
  for (const auto& folder : folders) {
    if (folder.empty()) continue;
    const auto file = std::filesystem::weakly_canonical(folder / node->text, code);
    if (code) continue;
    const bool allowed = std::any_of(folders.begin(), folders.end(), [&](const auto& f) { return isInside(file, f); });
    outside = outside || !allowed;
    if (!allowed || !std::filesystem::is_regular_file(file, code)) continue;
    value = file;
    return;
  }
  if (outside)
    return context_.diagnostics.error(
        node->place, fmt::format("\"{}\" leaves the scene's folder and the asset folder; copy the file there", node->text));
  const auto assets = assetFolder();
  context_.diagnostics.error(
      node->place, fmt::format("there is no file \"{}\" in {}{}", node->text,
                               context_.sceneFolder.empty() ? "." : context_.sceneFolder.string(),
                               assets.empty() ? "" : " or " + assets.string()));
}

void Reader::inside(const Node& node, const std::function<void(Fields&)>& describe) {
  if (!expect(node, Node::Kind::object, "an object")) return;
  Reader inner(node, context_);
  describe(inner);
  inner.finish();
}

void Reader::group(const char* name, const char* /*doc*/, const std::function<void(Fields&)>& describe) {
  if (const Node* node = take(name)) inside(*node, describe);
}

void Reader::optionalGroup(const char* name, bool& present, const char* /*doc*/,
                           const std::function<void(Fields&)>& describe) {
  const Node* node = take(name);
  present = node != nullptr;
  if (present) inside(*node, describe);
}

void Reader::listOf(const char* name, const char* /*doc*/, std::size_t mostItems,
                    const std::function<void(std::size_t)>& resize,
                    const std::function<void(Fields&, std::size_t)>& describe) {
  const Node* node = take(name);
  if (node == nullptr || !expect(*node, Node::Kind::list, "a list")) return;
  if (node->items.size() > mostItems)
    return context_.diagnostics.error(node->place,
                                      fmt::format("at most {} items, found {}", mostItems, node->items.size()));
  resize(node->items.size());
  for (std::size_t i = 0; i < node->items.size(); ++i)
    inside(node->items[i], [&](Fields& fields) { describe(fields, i); });
}

}  // namespace simreel::scene

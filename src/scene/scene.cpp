#include "scene/scene.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "scene/asset_path.hpp"
#include "scene/json_node.hpp"
#include "scene/override.hpp"
#include "scene/reader.hpp"
#include "scene/sections.hpp"
#include "scene/value_reader.hpp"
#include "scene/words.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

std::vector<std::string> kindNames(std::span<const Kind> kinds) {
  std::vector<std::string> names;
  for (const Kind& kind : kinds) names.emplace_back(kind.name);
  return names;
}

/// Names appear in file names and in -D paths, so they are kept plain.
bool isPlainName(std::string_view name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), plain);
}

/// One object: exactly one member that names a kind, and perhaps a material.
Object readObject(const Node& node, ReadContext context, std::span<const Kind> kinds) {
  Object object;
  object.name = node.key;
  if (!isPlainName(node.key))
    context.diagnostics.add(
        node.headPlace(),
        fmt::format("object name {} must be 1 to 64 letters, digits, '-' or '_'", inQuotes(node.key)));
  if (!ValueReader("", context.diagnostics).expect(node, Node::Kind::object, "an object")) return object;
  bool unknown = false;
  for (const Node& member : node.children) {
    if (member.key == "material") {
      Reader::readObject(member, context, [&](Reader& fields) { object.material.describe(fields); });
      continue;
    }
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return member.key == k.name; });
    if (kind == kinds.end()) {
      std::vector<std::string> names = kindNames(kinds);
      names.emplace_back("material");
      context.diagnostics.add(member.headPlace(),
                              fmt::format("unknown kind of object {}; {}", inQuotes(member.key),
                                          suggestion(member.key, names)));
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
  if (object.parameters == nullptr && !unknown) {
    std::string names;
    for (const Kind& kind : kinds) names += fmt::format("{}{}", names.empty() ? "" : ", ", kind.name);
    context.diagnostics.add(node.headPlace(),
                            fmt::format("object \"{}\" has no kind; give it one of: {}", node.key, names));
  }
  return object;
}

void readObjects(const Node& node, ReadContext context, std::span<const Kind> kinds,
                 std::vector<Object>& objects) {
  if (!ValueReader("", context.diagnostics).expect(node, Node::Kind::object, "an object")) return;
  if (node.children.size() > mostObjects) {
    context.diagnostics.add(node.headPlace(), fmt::format("more than {} objects", mostObjects));
    return;
  }
  for (const Node& child : node.children) objects.push_back(readObject(child, context, kinds));
}

/// Whether this program can read the scene's version; reports otherwise.
bool checkVersion(const Node* version, const Node& root, Diagnostics& diagnostics) {
  if (version == nullptr) {
    diagnostics.add(root.headPlace(),
                    fmt::format("the scene has no version; add \"version\": {}", sceneVersion));
    return true;
  }
  const auto number = ValueReader("version", diagnostics).integer(*version);
  if (!number || *number == sceneVersion) return true;
  diagnostics.add(version->place(),
                  fmt::format("unknown version {}; this program reads version {}", *number, sceneVersion));
  return false;
}

void readScene(const Node& root, ReadContext context, std::span<const Kind> kinds, Scene& scene) {
  if (!ValueReader("", context.diagnostics).expect(root, Node::Kind::object, "a scene in { }")) return;
  Reader fields(&root, root.headPlace(), context);
  // What another version means by the rest is anyone's guess.
  if (!checkVersion(fields.take("version"), root, context.diagnostics)) return;
  describeScene(fields, scene);
  if (const Node* objects = fields.take("objects")) readObjects(*objects, context, kinds, scene.objects);
  std::string schemaAddress;  // for editors
  fields.text("$schema", schemaAddress, "");
  fields.finish();
}

}  // namespace

Scene parseScene(std::string_view text, const std::filesystem::path& file,
                 std::span<const Override> overrides, std::span<const Kind> kinds) {
  Diagnostics diagnostics(file.string(), text);
  const AssetFolders assets(file, assetFolder());
  Scene scene;
  if (std::optional<Node> root = parseJson(text, 0, 0, diagnostics)) {
    for (const Override& change : overrides) applyOverride(*root, change, diagnostics);
    readScene(*root, {diagnostics, assets}, kinds, scene);
  }
  if (!diagnostics.empty()) throw UserError(ExitCode::usage, diagnostics.report(), UserError::Form::report);

  std::string hashed(text);
  for (const Override& change : overrides) hashed += "\n" + change.path + "=" + change.value;
  scene.hash = hashHex(hashed);
  return scene;
}

Scene loadScene(const std::filesystem::path& file, std::span<const Override> overrides,
                std::span<const Kind> kinds) {
  return parseScene(readFile(file, "scene", mostSceneBytes), file, overrides, kinds);
}

}  // namespace simreel::scene

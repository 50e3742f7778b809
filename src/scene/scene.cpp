#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "scene/describe.hpp"
#include "scene/overrides.hpp"
#include "scene/reader.hpp"

namespace simreel::scene {

namespace {

constexpr std::size_t mostBytes = std::size_t{4} << 20;
constexpr std::size_t mostObjects = 1000;

/// "material" beside exactly one name of a kind.
void readObject(const Node& node, Place namePlace, Object& object, std::span<const Kind> kinds, ReadContext& context) {
  if (node.kind != Node::Kind::object)
    return context.diagnostics.error(node.place, fmt::format("expected an object, found {}", kindName(node.kind)));
  std::vector<std::string> names;
  for (const Kind& kind : kinds) names.emplace_back(kind.name);
  for (std::size_t i = 0; i < node.keys.size(); ++i) {
    const std::string& key = node.keys[i];
    if (key == "material") continue;
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return key == k.name; });
    if (kind == kinds.end()) {
      std::vector<std::string> known = names;
      known.emplace_back("material");
      context.diagnostics.error(node.keyPlaces[i], fmt::format("unknown kind of object \"{}\"; {}", key,
                                                               suggestion(key, known)));
      object.kind = key;  // so that the object is not reported as empty as well
      continue;
    }
    if (object.parameters != nullptr) {
      context.diagnostics.error(node.keyPlaces[i], fmt::format("the object \"{}\" is a {} already; one kind an object",
                                                               object.name, object.kind));
      continue;
    }
    object.kind = key;
    object.parameters = kind->makeParameters();
  }
  if (object.kind.empty())
    return context.diagnostics.error(namePlace, fmt::format("the object \"{}\" needs a kind; {}", object.name,
                                                            suggestion("", names)));
  Reader reader(node, context);
  if (object.parameters != nullptr)
    reader.group(object.kind.c_str(), "", [&](Fields& f) { object.parameters->describe(f); });
  reader.group("material", "", [&](Fields& f) { object.material.describe(f); });
}

void readObjects(const Node& list, Scene& scene, std::span<const Kind> kinds, ReadContext& context) {
  if (list.kind != Node::Kind::object)
    return context.diagnostics.error(list.place, fmt::format("expected an object of named objects, found {}",
                                                             kindName(list.kind)));
  if (list.keys.size() > mostObjects)
    return context.diagnostics.error(list.place,
                                     fmt::format("at most {} objects, found {}", mostObjects, list.keys.size()));
  for (std::size_t i = 0; i < list.keys.size(); ++i) {
    Object object;
    object.name = list.keys[i];
    readObject(list.items[i], list.keyPlaces[i], object, kinds, context);
    scene.objects.push_back(std::move(object));
  }
}

void readVersion(const Node& root, Reader& reader, ReadContext& context) {
  const Node* version = reader.take("version");
  if (version == nullptr)
    return context.diagnostics.error({root.place.source, root.place.begin, root.place.begin + 1},
                                     fmt::format("the scene needs \"version\": {}", sceneVersion));
  if (version->kind != Node::Kind::number || version->number != sceneVersion)
    context.diagnostics.error(version->place, fmt::format("this program reads scenes of version {}", sceneVersion));
}

}  // namespace

int Scene::frameCount() const {
  return std::max(1, static_cast<int>(std::lround(time.duration * time.fps)));
}

Scene parseScene(std::string_view text, const std::filesystem::path& file, std::span<const Override> overrides,
                 std::span<const Kind> kinds) {
  std::vector<std::string> texts;
  Scene scene;
  std::string identity(text);
  for (const Override& o : overrides) {
    texts.push_back(overrideText(o));
    identity += "\n" + texts.back();
  }
  scene.hash = hashHex(identity);
  Diagnostics diagnostics(file.string(), text, texts);
  const auto stop = [&] {
    if (!diagnostics.empty()) throw UserError(ExitCode::usage, diagnostics.text());
  };

  Node root;
  JsonError syntax;
  if (!parseJson(text, 0, root, syntax)) diagnostics.error(syntax.place, syntax.message);
  stop();
  if (root.kind != Node::Kind::object)
    diagnostics.error(root.place, fmt::format("a scene is an object in braces, found {}", kindName(root.kind)));
  stop();
  applyOverrides(root, overrides, diagnostics);

  // A bare name has no parent path; its folder is the working folder.
  ReadContext context{diagnostics, file.has_parent_path() ? file.parent_path() : std::filesystem::path(".")};
  Reader reader(root, context);
  std::string unused;
  reader.text("$schema", unused, "");
  readVersion(root, reader, context);
  describeScene(reader, scene);
  if (const Node* list = reader.take("objects")) readObjects(*list, scene, kinds, context);
  reader.finish();
  stop();
  return scene;
}

Scene loadScene(const std::filesystem::path& file, std::span<const Override> overrides, std::span<const Kind> kinds) {
  return parseScene(readFile(file, "scene", mostBytes), file, overrides, kinds);
}

}  // namespace simreel::scene

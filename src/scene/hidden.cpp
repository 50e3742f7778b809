#include "scene/hidden.hpp"

#include "scene/covering.hpp"
#include "scene/drawn_on.hpp"
#include "scene/falling.hpp"
#include "scene/stage.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

/// Returns the first object whose field has this extent, or nullptr.
const Object* covers(const Scene& scene, Covering::Extent extent) {
  const auto found = std::find_if(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
    const auto* covering = dynamic_cast<const Covering*>(object.parameters.get());
    return covering != nullptr && covering->covering() == extent;
  });
  return found == scene.objects.end() ? nullptr : &*found;
}

/// Warns if the scene's own ground hides most of a field that is drawn behind all objects.
void warnHiddenBehind(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  const Object* field = covers(scene, Covering::Extent::behind);
  if (field == nullptr || !scene.ground || !scene.ground->visible || scene.stage.leaves("ground")) return;
  diagnostics.remark(
      root.find("ground")->headPlace(),
      fmt::format("the ground hides the picture of \"{}\", which is behind all objects; leave out "
                  "\"ground\", or give it \"visible\": false",
                  field->name));
}

/// Returns the object whose field a colour bar explains. Returns nullptr for other objects and sources.
const Object* explainedBy(const Node& root, const Scene& scene, const Object& bar) {
  if (bar.kind != "colorBar") return nullptr;
  const Node* of = root.find("objects")->find(bar.name)->find(bar.kind)->find("of");
  if (of == nullptr) return nullptr;
  const std::string source = of->text.substr(0, of->text.find('.'));
  const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [&](const Object& object) { return object.name == source; });
  if (found == scene.objects.end()) return nullptr;
  return dynamic_cast<const Covering*>(found->parameters.get()) == nullptr ? nullptr : &*found;
}

/// True if a text within `node` is the name of the object or of one of its parts, NAME.PART.
bool names(const Node& node, const std::string& object) {
  if (node.kind == Node::Kind::text && node.text.substr(0, node.text.find('.')) == object) return true;
  return std::any_of(node.children.begin(), node.children.end(),
                     [&](const Node& child) { return names(child, object); });
}

/// Warns about each colour bar that explains a field which nothing in the scene shows.
void warnIdleBars(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  for (const Object& bar : scene.objects) {
    const Object* const field = explainedBy(root, scene, bar);
    if (field == nullptr) continue;
    // Water never has the colours of a bar. A surface in the world that shows another kind of field may
    // have them.
    const bool water = field->kind == "water";
    if (!water && field->parameters->framed()) continue;
    if (dynamic_cast<const Covering&>(*field->parameters).covering() != Covering::Extent::none) continue;
    const bool shown = std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& other) {
      return &other != field && other.kind != bar.kind &&
             names(*root.find("objects")->find(other.name), field->name);
    });
    if (shown) continue;
    const std::string of = root.find("objects")->find(bar.name)->find(bar.kind)->find("of")->text;
    if (water && of != field->name) {
      diagnostics.remark(root.find("objects")->find(bar.name)->headPlace(),
                         fmt::format("{} \"{}\" explains the colours of \"{}\", which nothing shows; leave "
                                     "it out",
                                     bar.kind, bar.name, of));
      continue;
    }
    diagnostics.remark(
        root.find("objects")->find(bar.name)->headPlace(),
        fmt::format("{} \"{}\" explains the colours of \"{}\", whose \"layer\" is \"none\", so nothing "
                    "has them; leave it out, or give \"{}\" \"display\": {{\"layer\": \"over\"}}",
                    bar.kind, bar.name, field->name, field->name));
  }
}

/// Returns the object's "display": {"layer": ...}, or nullptr if the scene does not give it.
const Node* layerOf(const Node& root, const Object& object) {
  const Node* node = root.find("objects");
  for (const std::string& key : {object.name, object.kind, std::string("display"), std::string("layer")})
    node = node == nullptr || node->kind != Node::Kind::object ? nullptr : node->find(key);
  return node;
}

bool hasChart(const Node& root, const Object& object) {
  return root.find("objects")->find(object.name)->find(object.kind)->find("chart") != nullptr;
}

/// Warns if the scene consists of fields that are not drawn.
void warnEmpty(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  if (scene.objects.empty()) return;
  for (const Object& object : scene.objects) {
    const auto* field = dynamic_cast<const Covering*>(object.parameters.get());
    if (field == nullptr || field->covering() != Covering::Extent::none) return;
    if (object.parameters->framed() || layerOf(root, object) == nullptr || hasChart(root, object)) return;
  }
  const Object& first = scene.objects.front();
  diagnostics.remark(
      layerOf(root, first)->place(),
      fmt::format("nothing is drawn: the layer of \"{0}\" is \"none\", and no other object shows its "
                  "field; leave out \"layer\", or add an object with \"material\": {{\"skin\": "
                  "{{\"field\": \"{0}\"}}}}",
                  first.name));
}

/// Warns about each object on the rectangle of `cover`, which covers the whole picture.
void warnHiddenOn(const Node& root, const Scene& scene, const Object& cover, Diagnostics& diagnostics) {
  for (const Object& object : scene.objects) {
    const auto* drawn = dynamic_cast<const DrawnOn*>(object.parameters.get());
    if (drawn == nullptr || drawn->source() != cover.name) continue;
    diagnostics.remark(
        root.find("objects")->find(object.name)->headPlace(),
        fmt::format("\"{}\" is drawn over the whole picture and hides \"{}\"; give it \"display\": "
                    "{{\"layer\": \"none\"}}, and \"{}\" \"sheet\": true, which draws it in the world",
                    cover.name, object.name, object.name));
  }
}

/// Warns about the first section for light and surroundings if the whole picture is the field of `cover`,
/// and the scene has nothing in the world.
void warnUnlit(const Node& root, const Object& cover, Diagnostics& diagnostics) {
  for (const char* section : {"stage", "sun", "sky", "haze", "ground", "lights"}) {
    const Node* const given = root.find(section);
    if (given == nullptr || given->kind == Node::Kind::boolean) continue;
    diagnostics.remark(given->headPlace(),
                       fmt::format("the picture of \"{}\" has colours of its own and fills the whole "
                                   "picture; here \"{}\" does nothing",
                                   cover.name, section));
    return;
  }
}

/// Warns about each object that falls through the ground and so out of view.
void warnFalling(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  if (!scene.ground || !scene.ground->solid || !scene.ground->visible) return;
  for (const Object& object : scene.objects) {
    const auto* falling = dynamic_cast<const Falling*>(object.parameters.get());
    const double height = scene.ground->height;
    if (falling == nullptr || falling->fallsTo(scene.time.start + scene.time.duration, height) >= height)
      continue;
    diagnostics.remark(root.find("objects")->find(object.name)->headPlace(),
                       fmt::format("\"{}\" falls through the ground, which hides it; give it "
                                   "\"collides\": true",
                                   object.name));
  }
}

}  // namespace

bool explainsBehind(const Node& root, const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& bar) {
    const Object* const field = explainedBy(root, scene, bar);
    return field != nullptr &&
           dynamic_cast<const Covering&>(*field->parameters).covering() == Covering::Extent::behind;
  });
}

void warnHidden(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  if (const std::string advice = groundAdvice(scene); !advice.empty())
    diagnostics.remark(root.find("ground")->headPlace(), advice);
  warnHiddenBehind(root, scene, diagnostics);
  warnEmpty(root, scene, diagnostics);
  warnIdleBars(root, scene, diagnostics);
  warnFalling(root, scene, diagnostics);
  const Object* const cover = covers(scene, Covering::Extent::whole);
  if (cover == nullptr) return;
  if (scene.panels.empty()) warnHiddenOn(root, scene, *cover, diagnostics);
  const auto hidden = std::find_if(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
    return &object != cover && object.parameters->framed();
  });
  if (!scene.panels.empty()) return;  // a panel may show each of them
  if (hidden == scene.objects.end()) return warnUnlit(root, *cover, diagnostics);
  const bool writes = hidden->kind == "text";
  diagnostics.remark(
      root.find("objects")->find(hidden->name)->headPlace(),
      fmt::format("\"{}\" is in the world and hidden behind the picture of \"{}\"; {}give the \"display\" "
                  "of \"{}\" \"layer\": \"behind\", or a smaller \"extent\"",
                  hidden->name, cover->name, writes ? "give it \"screen\": {}, or " : "", cover->name));
}

}  // namespace simreel::scene

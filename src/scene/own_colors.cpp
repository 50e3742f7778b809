#include "scene/own_colors.hpp"

#include "scene/covering.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace simreel::scene {

void remarkColors(const Node& node, const Object& object, Diagnostics& diagnostics) {
  const auto* colored = dynamic_cast<const HasOwnColors*>(object.parameters.get());
  const char* const by = colored == nullptr ? nullptr : colored->coloredBy();
  if (by == nullptr) return;
  const bool all = colored->replacesTextures();
  if (object.material.skin && !all) return;
  for (const char* key : {"color", "texture", "skin"}) {
    if (!all && std::string_view(key) != "color") return;
    if (!object.materialKeys.contains(key)) continue;
    diagnostics.remark(node.find("material")->find(key)->headPlace(),
                       fmt::format("\"{}\" has the colours of {}; here \"{}\" of the material does nothing",
                                   object.name, by, key));
  }
}

void keepStateColors(const Node& node, std::span<Object> objects) {
  for (Object& object : objects) {
    if (!object.material.skin) continue;
    const Node* owner = node.find(object.name);
    const Node* material = owner == nullptr ? nullptr : owner->find("material");
    const Node* skin = material == nullptr ? nullptr : material->find("skin");
    if (skin == nullptr) continue;
    const auto given = [&](const char* key) {
      return skin->kind == Node::Kind::object && skin->find(key) != nullptr;
    };
    if (given("look") || given("low") || given("high") || given("threshold")) continue;
    const auto source = std::find_if(objects.begin(), objects.end(), [&](const Object& other) {
      return other.name == object.material.skin->field;
    });
    const auto* field =
        source == objects.end() ? nullptr : dynamic_cast<const Covering*>(source->parameters.get());
    if (field == nullptr || !field->hasStates()) continue;
    object.material.skin->look = Skin::Look::map;
    if (!given("bump")) object.material.skin->bump = 0;
  }
}

}  // namespace simreel::scene

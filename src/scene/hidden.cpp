#include "scene/hidden.hpp"

#include "scene/covering.hpp"
#include "scene/stage.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace simreel::scene {

void warnHidden(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  if (const std::string advice = groundAdvice(scene); !advice.empty())
    diagnostics.remark(root.find("ground")->headPlace(), advice);
  const auto cover = std::find_if(scene.objects.begin(), scene.objects.end(), [](const Object& object) {
    const auto* covering = dynamic_cast<const Covering*>(object.parameters.get());
    return covering != nullptr && covering->covers();
  });
  if (cover == scene.objects.end()) return;
  const auto hidden = std::find_if(scene.objects.begin(), scene.objects.end(),
                                   [](const Object& object) { return object.parameters->framed(); });
  if (hidden == scene.objects.end()) return;
  if (!scene.panels.empty()) return;  // a panel may show each of them
  const bool writes = hidden->kind == "text";
  diagnostics.remark(
      root.find("objects")->find(hidden->name)->headPlace(),
      fmt::format("\"{}\" is in the world and hidden behind the picture of \"{}\"; {}give the \"display\" "
                  "of \"{}\" \"layer\": \"behind\", or a smaller \"extent\"",
                  hidden->name, cover->name, writes ? "give it \"screen\": {}, or " : "", cover->name));
}

}  // namespace simreel::scene

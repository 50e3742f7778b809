// Checks "test" and "checks" against the scene that they belong to.
#include "scene/json/words.hpp"
#include "scene/scene.hpp"
#include "scene/sections.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::scene {

namespace {

void checkLength(Fields& fields, const std::vector<int>& frames, int frameCount) {
  if (!frames.empty() && frames.back() >= frameCount)
    fields.error("frames", fmt::format("frame {} is beyond the scene's last frame, {}", frames.back(),
                                       frameCount - 1));
}

/// Checks that exactly one object measures the quantity that `check` names.
void checkQuantity(Fields& fields, const Check& check, const Scene& scene) {
  std::vector<std::string> known;
  for (const Object& object : scene.objects) {
    // The object itself has an error, so the check is skipped.
    if (object.parameters == nullptr) return;
    if (object.parameters->measures() && (check.object.empty() || object.name == check.object))
      for (const Quantity& quantity : object.parameters->quantities())
        if (std::find(known.begin(), known.end(), quantity.name) == known.end())
          known.emplace_back(quantity.name);
  }
  const std::vector<std::size_t> owners = scene.owners(check);
  std::vector<std::string> names;
  names.reserve(owners.size());
  for (const std::size_t i : owners) names.push_back(scene.objects[i].name);
  if (owners.size() > 1)
    fields.error("what", fmt::format("several objects have {}: {}; name one of them with \"object\"",
                                     inQuotes(check.what), fmt::join(names, ", ")));
  if (!owners.empty()) return;
  const auto named = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [&](const Object& object) { return object.name == check.object; });
  if (named != scene.objects.end())
    fields.error("what", fmt::format("object \"{}\" is a {} and has no quantity {}; {}", named->name,
                                     named->kind, inQuotes(check.what), suggestion(check.what, known)));
  else if (check.object.empty())
    fields.error("what", fmt::format("no object of the scene has a quantity {}; {}", inQuotes(check.what),
                                     suggestion(check.what, known)));
}

/// Reports errors of a check that depend on other parts of the scene.
void checkAgainstScene(Fields& fields, const Check& check, const Scene& scene,
                       std::optional<int> frameCount) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  if (!check.object.empty() && std::find(names.begin(), names.end(), check.object) == names.end())
    fields.error("object", fmt::format("no object is named {}; {}", inQuotes(check.object),
                                       suggestion(check.object, names)));
  if (check.isQuantity() && (check.min || check.max || check.drift)) checkQuantity(fields, check, scene);
  if (!frameCount) return;
  checkLength(fields, check.frames, *frameCount);
  const std::vector<int> tested = scene.testFrames();
  if (check.drift && check.frames.empty() && tested.size() < 2)
    fields.error("drift", "\"drift\" compares frames with the first, and the scene tests one frame only");
  if (check.what != "not-blank") return;
  for (const int frame : check.frames)
    if (!std::binary_search(tested.begin(), tested.end(), frame))
      fields.error("frames", fmt::format("\"not-blank\" needs a picture, and frame {} is not a tested "
                                         "frame; add it to \"frames\" of \"test\"",
                                         frame));
}

}  // namespace

void describeTests(Fields& fields, Scene& scene, std::optional<int> frameCount) {
  fields.group("test", testDoc, [&](Fields& inner) {
    scene.test.describe(inner);
    if (frameCount) checkLength(inner, scene.test.frames, *frameCount);
  });
  fields.list("checks", scene.checks, checksDoc, [&](Fields& inner, Check& check) {
    check.describe(inner);
    checkAgainstScene(inner, check, scene, frameCount);
  });
}

std::vector<std::size_t> Scene::owners(const Check& check) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i].parameters->measures()) continue;
    if (!check.object.empty() && objects[i].name != check.object) continue;
    const auto table = objects[i].parameters->quantities();
    if (std::any_of(table.begin(), table.end(), [&](const Quantity& q) { return check.what == q.name; }))
      found.push_back(i);
  }
  return found;
}

std::vector<int> Scene::testFrames() const {
  if (!test.frames.empty()) return test.frames;
  const int last = frameCount() - 1;
  std::vector<int> frames = {0, last / 2, last};
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

}  // namespace simreel::scene

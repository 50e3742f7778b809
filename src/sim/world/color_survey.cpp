#include "sim/world/color_survey.hpp"

#include "scene/value/value_writer.hpp"
#include "sim/core/auto_range.hpp"
#include "sim/core/drawable.hpp"
#include "sim/flow/speed_range.hpp"
#include "sim/grid/field_values.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/vec4.hpp>

namespace simreel::sim {

namespace {

std::vector<MeasuredRange> rangesOf(const scene::Object& object) {
  auto* colored = dynamic_cast<HasColorRange*>(object.parameters.get());
  return colored == nullptr ? std::vector<MeasuredRange>() : colored->measuredRanges();
}

/// True if the object shows the speeds of a flow that does not change, whose maximum is known before the
/// run.
bool showsStillFlow(const scene::Scene& scene, const scene::Object& object) {
  const auto* shows = dynamic_cast<const ShowsSpeedsOf*>(object.parameters.get());
  return shows != nullptr &&
         std::any_of(scene.objects.begin(), scene.objects.end(), [&](const scene::Object& other) {
           return other.name == shows->source() && other.kind == "flow";
         });
}

void see(float value, SeenRange& range) {
  if (!std::isfinite(value)) return;
  range.low = range.seen ? std::min(range.low, value) : value;
  range.high = range.seen ? std::max(range.high, value) : value;
  range.seen = true;
}

/// Returns the component with the index `at` of each of the first `count` texels of a buffer texture.
std::vector<float> component(const gl::Texture& texels, int count, int at) {
  Field field;
  field.words = &texels;
  field.size = {count, 1};
  field.rowWords = 4 * count;
  field.cellWords = 4;
  field.firstWord = at;
  return fieldValues(field);
}

/// Extends the range by the values that colour the live particles.
void seeInstances(const Instances& instances, SeenRange& range) {
  if (instances.colorBy == Instances::ColorBy::material || instances.capacity < 1) return;
  const auto of = [&](const gl::Texture& texels, int at) {
    return component(texels, instances.capacity, at);
  };
  const std::vector<float> age = of(*instances.velocities, 3);
  std::vector<float> values = age;
  if (instances.colorBy == Instances::ColorBy::mass) values = of(*instances.positions, 3);
  if (instances.colorBy == Instances::ColorBy::speed) {
    const auto x = of(*instances.velocities, 0), y = of(*instances.velocities, 1),
               z = of(*instances.velocities, 2);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const glm::dvec3 v(x[i], y[i], z[i]);
      values[i] = static_cast<float>(std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    if (age[i] >= 0) see(values[i], range);
}

/// Extends the range by the values that colour a surface's vertices.
void seeSurface(const Surface& surface, SeenRange& range) {
  if (surface.stops == nullptr) return;
  for (const float value : component(*surface.colors, surface.vertexCount, 3)) see(value, range);
}

/// Returns the field that the object displays; otherwise the field with the object's name; null if there is
/// none.
const Field* shownField(const Drawables& drawables, const std::string& object) {
  const Field* named = nullptr;
  for (const Field& field : drawables.fields) {
    if (field.decoration || field.categories) continue;
    if (field.display != nullptr) return &field;
    if (*field.name == object) named = &field;
  }
  return named;
}

/// Moves the measured ends apart if both ends are equal, or if they are in the wrong order because one end
/// is fixed.
void separate(const AutoEnds& ends, double& low, double& high) {
  if (low < high) return;
  const double span = std::max(1e-6, std::abs(low));
  if (ends.low && ends.high) {
    const double middle = low;
    low = middle - 0.5 * span;
    high = middle + 0.5 * span;
  } else if (ends.high) {
    high = low + span;
  } else {
    low = high - std::max(1e-6, std::abs(high));
  }
}

}  // namespace

std::vector<SeenRange> rangesToSee(scene::Scene& scene) {
  std::vector<SeenRange> all;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (!showsStillFlow(scene, scene.objects[i]))
      for (std::size_t k = 0; k < rangesOf(scene.objects[i]).size(); ++k) all.push_back({i, k});
  return all;
}

bool needsRanges(scene::Scene& scene) {
  return !rangesToSee(scene).empty();
}

void seeValues(const World& world, std::vector<SeenRange>& ranges) {
  for (SeenRange& range : ranges) {
    if (const auto* shown = dynamic_cast<const HasShownSpeeds*>(&world.object(range.object))) {
      for (const float speed : shown->shownSpeeds()) see(speed, range);
      continue;
    }
    Drawables drawables;
    world.object(range.object).publish(world.time(), drawables);
    const Field* field = shownField(drawables, world.objectName(range.object));
    // A kernels object may have both a field and instances; its first range belongs to the field.
    if (field != nullptr && range.range == 0) {
      for (const float value : fieldValues(*field)) see(value, range);
      continue;
    }
    for (const Instances& instances : drawables.instances) seeInstances(instances, range);
    for (const Surface& surface : drawables.surfaces) seeSurface(surface, range);
  }
}

std::vector<std::string> setRanges(scene::Scene& scene, const std::vector<SeenRange>& ranges) {
  std::vector<std::string> given;
  // The loop runs from the last to the first entry, because a range that is set is removed from the list of
  // its object.
  for (auto seen = ranges.rbegin(); seen != ranges.rend(); ++seen) {
    const scene::Object& object = scene.objects.at(seen->object);
    const std::vector<MeasuredRange> all = rangesOf(object);
    if (seen->range >= all.size()) continue;
    const MeasuredRange& range = all[seen->range];
    double low = range.low, high = range.high;
    if (seen->seen && range.ends.low) low = static_cast<double>(seen->low);
    if (seen->seen && range.ends.high) high = static_cast<double>(seen->high);
    separate(range.ends, low, high);
    range.set(low, high);
    const std::string path = fmt::format("objects.{}.{}.{}{}", object.name, object.kind, range.path,
                                         range.path.empty() ? "" : ".");
    const auto value = [](double end) { return scene::shortest(static_cast<float>(end)).dump(); };
    if (range.ends.high) given.insert(given.begin(), path + range.highKey + "=" + value(high));
    if (range.ends.low) given.insert(given.begin(), path + range.lowKey + "=" + value(low));
  }
  return given;
}

}  // namespace simreel::sim

// The part of KernelPlan that plans drawings and measures.
#include "scene/json/words.hpp"
#include "sim/grid/sheet_mesh.hpp"
#include "sim/kernels/plan.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Returns the slots of a named buffer's element, or the channels of a named texture.
std::vector<KernelSlot> slotsNamed(const KernelPlan& plan, const std::string& of) {
  if (const int buffer = plan.bufferNamed(of); buffer >= 0)
    return plan.buffers()[static_cast<std::size_t>(buffer)].element;
  const int texture = plan.textureNamed(of);
  if (texture < 0) return {};
  const std::string& format = plan.textures()[static_cast<std::size_t>(texture)].format;
  const auto number = format.ends_with("ui")  ? KernelSlot::Number::unsignedInteger
                      : format.ends_with("i") ? KernelSlot::Number::signedInteger
                                              : KernelSlot::Number::real;
  std::vector<KernelSlot> slots;
  for (std::size_t c = 0; c < 4; ++c)
    slots.push_back({std::string(1, "rgba"[c]), "channel", number, true, {4 * c}});
  return slots;
}

bool isPosition(const KernelSlot& slot, const std::string& buffer) {
  std::string lower = slot.path.empty() ? buffer : slot.path;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return slot.number == KernelSlot::Number::real && slot.offsets.size() >= 2 && slot.offsets.size() <= 4 &&
         (lower.find("pos") != std::string::npos || lower.find("vert") != std::string::npos ||
          lower.find("point") != std::string::npos || lower == "p" || lower == "x");
}

}  // namespace

void KernelPlan::planDrawing(const KernelDescription& parameters) {
  drawn_ = {parameters.surface, parameters.points, parameters.field,
            parameters.terrain, parameters.volume, parameters.wind};
  if (!drawn_.inSpace() && !drawn_.field && !drawn_.wind) chooseDrawing(parameters.defaultFit);
  planGrids();
  if (drawn_.surface && checkBufferSize("surface", drawn_.surface->of)) planSurface(*drawn_.surface);
  if (drawn_.points && checkBufferSize("points", drawn_.points->of)) planPoints(*drawn_.points);
  if (drawn_.field) planField(*drawn_.field);
}

/// Returns the names of all buffers of elements, which excludes counters.
std::vector<std::string> KernelPlan::bufferNames() const {
  std::vector<std::string> names;
  for (const PlannedBuffer& buffer : buffers_)
    if (buffer.counterOf.empty()) names.push_back(buffer.name);
  return names;
}

/// Returns true if the group names a buffer that exists.
bool KernelPlan::checkBufferSize(const char* group, const std::string& of) {
  if (of.empty())
    mistake({group},
            fmt::format("\"{}\" needs \"of\", a buffer: {}", group, scene::suggestion("", bufferNames())));
  else if (bufferNamed(of) < 0)
    unknown({group, "of"}, of, bufferNames(), "buffer");
  return bufferNamed(of) >= 0;
}

void KernelPlan::planSurface(KernelSurface& surface) {
  holdMember("surface", "position", surface.of, surface.position, true, 3);
  holdMember("surface", "normal", surface.of, surface.normal, false, 3);
  const PlannedBuffer& buffer = buffers_[static_cast<std::size_t>(bufferNamed(surface.of))];
  if (surface.mesh.empty() && surface.indices.empty() && surface.grid.x == 0)
    surface.grid = {buffer.size.x, buffer.size.y};
  if (surface.mesh.empty() && surface.indices.empty()) {
    if (surface.grid.x < 2 || surface.grid.y < 2)
      mistake({"surface"}, fmt::format("the {} vertices of {} do not form a grid; set \"grid\": [width, "
                                       "height], \"indices\" or \"mesh\"",
                                       buffer.count(), scene::inQuotes(surface.of)));
    else if (static_cast<std::size_t>(surface.grid.x) * static_cast<std::size_t>(surface.grid.y) >
             buffer.count())
      mistake({"surface", "grid"},
              fmt::format("{} x {} vertices are more than the {} of {}", surface.grid.x, surface.grid.y,
                          buffer.count(), scene::inQuotes(surface.of)));
  }
  if (!surface.indices.empty() && bufferNamed(surface.indices) < 0)
    unknown({"surface", "indices"}, surface.indices, bufferNames(), "buffer");
}

void KernelPlan::planPoints(const KernelPoints& points) {
  holdMember("points", "position", points.of, points.position, true, 2);
  holdMember("points", "velocity", points.of, points.velocity, false, 2);
  holdMember("points", "mass", points.of, points.mass, false, 1);
  holdMember("points", "alive", points.of, points.alive, false, 1);
  holdMember("points", "rotation", points.of, points.rotation, false, 3);
  if (points.alongVelocity && !points.rotation.empty())
    mistake({"points", "rotation"}, "give \"rotation\" or \"alongVelocity\", not both");
  if (points.colorBy == Instances::ColorBy::speed && points.velocity.empty())
    mistake({"points", "colorBy"}, "colours by speed need \"velocity\", a member");
  if (points.colorBy == Instances::ColorBy::mass && points.mass.empty())
    mistake({"points", "colorBy"}, "colours by mass need \"mass\", a member");
}

void KernelPlan::planField(const KernelField& field) {
  std::vector<std::string> all = bufferNames();
  for (const PlannedTexture& texture : textures_) all.push_back(texture.name);
  const std::string& of = field.of;
  if (of.empty()) {
    mistake({"field"},
            fmt::format("\"field\" needs \"of\", a texture or buffer: {}", scene::suggestion("", all)));
  } else if (std::find(all.begin(), all.end(), of) == all.end()) {
    unknown({"field", "of"}, of, all, "texture or buffer");
  } else {
    holdMember("field", "show", of, field.show, false, 1);
  }
}

void KernelPlan::setColorRanges(const KernelDescription& description) {
  if (drawn_.field && description.field) {
    drawn_.field->display.low = description.field->display.low;
    drawn_.field->display.high = description.field->display.high;
  }
  if (drawn_.points && description.points) drawn_.points->colorRange = description.points->colorRange;
}

/// Chooses the default drawing: a 2-D texture that the kernels write, otherwise a buffer with positions,
/// which is drawn as a surface if it is a grid.
void KernelPlan::chooseDrawing(FieldDisplay::Fit fit) {
  for (std::size_t i = textures_.size(); i-- > 0;) {
    const PlannedTexture& texture = textures_[i];
    if (!texture.written || texture.type != "2D") continue;
    KernelField field;
    field.of = texture.name;
    field.display.fit = fit;
    drawn_.field = field;
    return;
  }
  for (const PlannedBuffer& buffer : buffers_) {
    const auto position =
        std::find_if(buffer.element.begin(), buffer.element.end(),
                     [&](const KernelSlot& slot) { return isPosition(slot, buffer.name); });
    if (position == buffer.element.end()) continue;
    if (buffer.size.y > 1 && buffer.size.z == 1 && position->offsets.size() >= 3) {
      KernelSurface& surface = drawn_.surface.emplace();
      surface.of = buffer.name;
      surface.position = position->path;
    } else {
      KernelPoints& points = drawn_.points.emplace();
      points.of = buffer.name;
      points.position = position->path;
    }
    return;
  }
  for (const PlannedBuffer& buffer : buffers_) {
    if (!buffer.written || buffer.size.y < 2 || buffer.element.empty()) continue;
    KernelField field;
    field.of = buffer.name;
    field.display.fit = fit;
    drawn_.field = field;
    return;
  }
}

bool KernelPlan::holdMember(const char* group, const char* key, const std::string& of,
                            const std::string& member, bool needed, std::size_t minimum) {
  if (member.empty() && !needed) return true;
  const std::vector<KernelSlot> slots = slotsNamed(*this, of);
  const KernelSlot* slot = slotNamed(slots, member);
  // An element that is itself a vector is a single unnamed slot.
  if (slot == nullptr && needed && slots.size() == 1) slot = slots.data();
  if (slot == nullptr) {
    const std::vector<std::string> known = pathsOf(slots);
    mistake({group, key}, fmt::format("{} has no member {}; {}", scene::inQuotes(of),
                                      scene::inQuotes(member), scene::suggestion(member, known)));
    return false;
  }
  if (slot->offsets.size() < minimum || slot->offsets.size() > 4) {
    mistake({group, key}, fmt::format("{} is a {}; expected {} to 4 numbers", scene::inQuotes(slot->path),
                                      slot->type, minimum));
    return false;
  }
  return true;
}

void KernelPlan::planMeasures(const KernelDescription& parameters) {
  std::vector<std::string> all;
  for (const PlannedBuffer& buffer : buffers_) all.push_back(buffer.name);
  for (const PlannedTexture& texture : textures_) all.push_back(texture.name);
  for (const KernelMeasure& measure : parameters.measured) {
    const std::vector<KernelSlot> slots = slotsNamed(*this, measure.of);
    if (std::find(all.begin(), all.end(), measure.of) == all.end()) {
      unknown({"measures", measure.name, "of"}, measure.of, all, "buffer or texture");
    } else if (slotNamed(slots, measure.member) == nullptr) {
      const std::vector<std::string> known = pathsOf(slots);
      mistake({"measures", measure.name, "member"},
              fmt::format("{} has no member {}; {}", scene::inQuotes(measure.of),
                          scene::inQuotes(measure.member), scene::suggestion(measure.member, known)));
    }
  }
}

std::vector<KernelSlot> KernelPlan::slots(const std::string& memory) const {
  return slotsNamed(*this, memory);
}

std::optional<scene::Box> KernelPlan::box() const {
  if (drawn_.volume) return boxOfVolume();
  if (drawn_.terrain && !drawn_.surface && !drawn_.points) return boxOfTerrain();
  const std::string of = drawn_.surface  ? drawn_.surface->of
                         : drawn_.points ? drawn_.points->of
                                         : std::string();
  if (of.empty()) return std::nullopt;
  const PlannedBuffer& buffer = buffers_[static_cast<std::size_t>(bufferNamed(of))];
  const std::string& member = drawn_.surface ? drawn_.surface->position : drawn_.points->position;
  const KernelSlot* slot = slotNamed(buffer.element, member);
  if (slot == nullptr) slot = buffer.element.data();
  const std::vector<std::byte> bytes = firstBytes(buffer, 1);
  std::optional<scene::Box> box;
  for (std::size_t i = 0; i < buffer.count(); ++i) {
    glm::vec3 at(0);
    for (std::size_t c = 0; c < std::min<std::size_t>(3, slot->offsets.size()); ++c)
      at[static_cast<int>(c)] =
          static_cast<float>(loadSlot(bytes.data() + buffer.header + i * buffer.stride, *slot, c));
    if (std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z)) scene::include(box, at);
  }
  if (box && box->min == box->max) box = scene::Box{box->min - 1.0F, box->max + 1.0F};
  return box;
}

}  // namespace simreel::sim

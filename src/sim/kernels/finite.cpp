#include "sim/kernels/finite.hpp"

#include "scene/json/words.hpp"

#include <vector>

#include <climits>
#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Memory and member that a part draws, and the scene's key of the part.
struct Drawn {
  const char* key;
  std::string of, member;
};

Drawn drawnBy(const PlannedDrawing& drawn, KernelFinite::Part part) {
  using Part = KernelFinite::Part;
  switch (part) {
    case Part::surface:
      return {"surface", drawn.surface->of, drawn.surface->position};
    case Part::normals:
      return {"surface", drawn.surface->of, drawn.surface->normal};
    case Part::points:
      return {"points", drawn.points->of, drawn.points->position};
    case Part::velocities:
      return {"points", drawn.points->of, drawn.points->velocity};
    case Part::field:
      return {"field", drawn.field->of, drawn.field->show};
    case Part::terrain:
      return {"terrain", drawn.terrain->of, drawn.terrain->height};
    case Part::volume:
      return {"volume", drawn.volume->of, drawn.volume->show};
    case Part::wind:
      break;
  }
  return {"wind", drawn.wind->of, drawn.wind->velocity};
}

std::string placeOf(unsigned index, glm::ivec3 size) {
  const auto i = static_cast<int>(index);
  if (size.z > 1) return fmt::format("({}, {}, {})", i % size.x, i / size.x % size.y, i / size.x / size.y);
  if (size.y > 1) return fmt::format("({}, {})", i % size.x, i / size.x);
  return std::to_string(i);
}

}  // namespace

KernelFinite::KernelFinite(const std::string& name, const KernelPlan& plan,
                           KernelDescription::NonFinite reaction)
    : name_(name), plan_(plan), reaction_(reaction) {
  const std::vector<glm::uvec4> none(parts, glm::uvec4(0, UINT_MAX, 0, 0));
  reports_ = gl::Buffer::of(name + " reports of numbers", std::span<const glm::uvec4>(none));
}

KernelWatch KernelFinite::watch(Part part) const {
  if (!watches()) return {};
  return {&reports_, static_cast<int>(part)};
}

std::string KernelFinite::message(int part, const glm::uvec4& words, unsigned frame) const {
  const Drawn drawn = drawnBy(plan_.drawn(), static_cast<Part>(part));
  // An element without members is a single slot, which any name selects.
  const std::vector<KernelSlot> slots = plan_.slots(drawn.of);
  const bool named = !drawn.member.empty() && slotNamed(slots, drawn.member) != nullptr;
  const int buffer = plan_.bufferNamed(drawn.of);
  const glm::ivec3 size =
      buffer >= 0 ? plan_.buffers()[static_cast<std::size_t>(buffer)].size
                  : plan_.textures()[static_cast<std::size_t>(plan_.textureNamed(drawn.of))].size;
  return fmt::format(
      "kernels {}, frame {}: {} is NaN or infinite in {} of {} {} (the first is {}), which \"{}\" {}; look "
      "for "
      "divisions by zero, roots and logarithms of negative numbers and time steps that are too long, or "
      "give "
      "\"nonFinite\": \"ignore\"",
      scene::inQuotes(name_), frame, scene::inQuotes(named ? drawn.of + "." + drawn.member : drawn.of),
      words.x, static_cast<long>(size.x) * size.y * size.z, buffer >= 0 ? "elements" : "texels",
      placeOf(words.y, size), drawn.key, static_cast<Part>(part) == Part::wind ? "blows" : "draws");
}

}  // namespace simreel::sim

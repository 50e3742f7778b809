#include "sim/kernels/gather.hpp"

#include <algorithm>

namespace simreel::sim {

struct GatherKernel {
  static constexpr auto file = "kernels/run/gather.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"threads", int> threads;
  gl::Uniform<"start", int> start;
  gl::Uniform<"stride", int> stride;
  gl::Uniform<"places", glm::ivec4> places;
  gl::Uniform<"fill", glm::vec4> fill;
  gl::Uniform<"number", int> number;
  gl::Uniform<"alive", int> alive;
  gl::Uniform<"aliveNumber", int> aliveNumber;
  gl::Uniform<"marked", bool> marked;
  gl::Uniform<"watched", int> watched;
  gl::Uniform<"encoded", bool> encoded;
  gl::In<"words"> words;
  gl::Out<"drawn"> drawn;
  gl::InOut<"noted"> noted;
};

namespace {

int typeOf(const KernelSlot& slot) {
  return slot.number == KernelSlot::Number::signedInteger     ? 1
         : slot.number == KernelSlot::Number::unsignedInteger ? 2
                                                              : 0;
}

const KernelSlot* slotOf(const std::vector<KernelSlot>& slots, const std::string& name) {
  const KernelSlot* found = slotNamed(slots, name);
  return found == nullptr && slots.size() == 1 ? slots.data() : found;
}

}  // namespace

KernelNumbers numbersOf(const KernelStore& store, const std::string& of) {
  const KernelPlan& plan = store.plan();
  const std::vector<KernelSlot> slots = plan.slots(of);
  if (const int place = plan.bufferNamed(of); place >= 0) {
    const PlannedBuffer& buffer = plan.buffers()[static_cast<std::size_t>(place)];
    return {&store.buffer(place),
            static_cast<int>(buffer.header / 4),
            static_cast<int>(buffer.stride / 4),
            static_cast<int>(buffer.count()),
            buffer.size,
            slots};
  }
  const int place = plan.textureNamed(of);
  const PlannedTexture& texture = plan.textures()[static_cast<std::size_t>(place)];
  return {&store.words(place), 0, 4, static_cast<int>(texture.count()), texture.size, slots};
}

KernelNumbers numbersOf(const KernelStore& store, const std::string& of, const std::string& member,
                        std::size_t components) {
  KernelNumbers numbers = numbersOf(store, of);
  const KernelSlot* found = member.empty() ? nullptr : slotNamed(numbers.slots, member);
  KernelSlot slot = found != nullptr ? *found : numbers.slots.front();
  if (found == nullptr && store.plan().bufferNamed(of) < 0) slot.offsets = {0, 4, 8, 12};
  slot.path = KernelNumbers::chosen;
  slot.offsets.resize(std::min(slot.offsets.size(), components));
  numbers.slots = {slot};
  return numbers;
}

KernelGather::KernelGather() : kernel_(gl::kernelDefines(false)), unwatched_("reports of nothing", 16) {}
KernelGather::~KernelGather() = default;

void KernelGather::run(const KernelNumbers& from, const Chosen& chosen, const gl::Vec4Array& to) const {
  glm::ivec4 places(-1);
  int number = 0;
  if (const KernelSlot* slot = slotOf(from.slots, chosen.member); slot != nullptr) {
    const int components = std::min(static_cast<int>(slot->offsets.size()), chosen.components);
    for (int c = 0; c < components; ++c)
      places[c] = static_cast<int>(slot->offsets[static_cast<std::size_t>(c)] / 4);
    number = typeOf(*slot);
  }
  const KernelSlot* last = chosen.fourth.empty() ? nullptr : slotNamed(from.slots, chosen.fourth);
  const KernelSlot* living = chosen.alive.empty() ? nullptr : slotNamed(from.slots, chosen.alive);
  const KernelWatch& watch = chosen.watch;
  if (last != nullptr) places.w = static_cast<int>(last->offsets[0] / 4);
  const int threads = std::min(from.count, maxThreads);
  kernel_.dispatch(threads, {.count = from.count,
                             .threads = threads,
                             .start = from.start,
                             .stride = from.stride,
                             .places = places,
                             .fill = chosen.fill,
                             .number = number,
                             .alive = living == nullptr ? -1 : static_cast<int>(living->offsets[0] / 4),
                             .aliveNumber = living == nullptr ? 0 : typeOf(*living),
                             .marked = chosen.marked,
                             .watched = watch.reports == nullptr ? -1 : watch.place,
                             .encoded = chosen.encoded,
                             .words = *from.words,
                             .drawn = to,
                             .noted = watch.reports == nullptr ? unwatched_ : *watch.reports});
}

}  // namespace simreel::sim

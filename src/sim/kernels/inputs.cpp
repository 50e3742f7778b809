#include "sim/kernels/inputs.hpp"

#include "base/error.hpp"
#include "sim/core/port.hpp"
#include "sim/grid/field_part.hpp"
#include "sim/ports/field_source.hpp"

#include <algorithm>

namespace simreel::sim {

struct TakeKernel {
  static constexpr auto file = "kernels/run/fields.comp";
  struct Variant {
    FieldCells cells;
    gl::Choice<"TEXELS", 0, 1, 2> texels;
  };
  FieldPart field;
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"threads", int> threads;
  gl::Uniform<"upward", bool> upward;
  gl::Uniform<"separate", bool> separate;
  gl::Out<"texels"> words;
};

namespace {

constexpr int sideLimit = 32768;  // maximum side in cells for betweenCells() in glsl/reaction/sampling.glsl

}  // namespace

KernelInputs::KernelInputs(const KernelPlan& plan, const scene::Object& object, const Links* links)
    : plan_(plan), links_(links), reader_(links, object), quantities_(plan.quantities().size()) {
  any_ = links != nullptr &&
         (!plan.quantities().empty() ||
          std::any_of(plan.textures().begin(), plan.textures().end(), [](const PlannedTexture& texture) {
            return texture.given != nullptr && !texture.given->field.empty();
          }));
}

KernelInputs::~KernelInputs() = default;

void KernelInputs::update(KernelStore& store, bool first) {
  if (!any_) return;
  for (std::size_t i = 0; i < quantities_.size(); ++i) {
    const PartName name(plan_.quantities()[i].name);
    quantities_[i] = reader_(name.object, name.part);
  }
  for (std::size_t i = 0; i < plan_.textures().size(); ++i) {
    const KernelMemory* given = plan_.textures()[i].given;
    if (given == nullptr || given->field.empty()) continue;
    if (first || given->readTime == KernelMemory::FieldReadTime::everyFrame)
      fill(store, i, fieldNamed(*links_, given->field));
  }
}

void KernelInputs::fill(KernelStore& store, std::size_t texture, const Field& field) {
  const PlannedTexture& planned = plan_.textures()[texture];
  if (std::max(field.size.x, field.size.y) > sideLimit)
    fail(ExitCode::usage, "the field \"{}\" has {} x {} cells; a texture takes at most {} along a side",
         *field.name, field.size.x, field.size.y, sideLimit);
  const int texels = planned.values == "int" ? 1 : planned.values == "uint" ? 2 : 0;
  const std::pair key(field.cells, texels);
  if (!kernels_.contains(key))
    kernels_.emplace(
        key, gl::Kernel<TakeKernel>(gl::kernelDefines(false), {.cells = field.cells, .texels = texels}));
  gl::barrier();
  const int threads = std::min(static_cast<int>(planned.count()), maxThreads);
  kernels_.at(key).dispatch(threads, {.field = partOf(field),
                                      .size = glm::ivec2(planned.size),
                                      .threads = threads,
                                      .upward = planned.given->upward,
                                      .separate = field.categories,
                                      .words = store.texels(texture)});
  store.putBackOne(texture);
}

}  // namespace simreel::sim

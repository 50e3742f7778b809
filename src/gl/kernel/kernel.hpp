#pragma once
#include "gl/kernel/fields.hpp"
#include "gl/kernel/kernel_base.hpp"
#include "gl/kernel/visit.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::gl {

struct NoVariant {};
template <class Interface>
struct VariantOf {
  using Type = NoVariant;
};
template <class Interface>
  requires requires {
    typename Interface::Variant;
  }
struct VariantOf<Interface> {
  using Type = typename Interface::Variant;
};

/// Returns `defines` with the defines of a variant added.
template <class Variant>
Defines with(Defines defines, const Variant& variant) {
  visitFields(variant, [&](const auto& field) { field.addTo(defines); });
  return defines;
}

/// Returns the defines of every combination of values that a Variant can have.
template <class Variant>
std::vector<Defines> variantsOf() {
  std::vector<Defines> all = {{}};
  const Variant none{};
  visitFields(none, [&](const auto& field) {
    std::vector<Defines> more;
    for (const Defines& before : all)
      for (const Defines& one : std::remove_cvref_t<decltype(field)>::all()) {
        more.push_back(before);
        more.back().insert(more.back().end(), one.begin(), one.end());
      }
    all = std::move(more);
  });
  return all;
}

template <class Interface>
const KernelNames& namesOf() {
  static const KernelNames names = [] {
    KernelNames all;
    all.file = Interface::file;
    const Interface given{};
    visitFields(given, [&](const auto& field) {
      using Field = std::remove_cvref_t<decltype(field)>;
      if constexpr (std::is_base_of_v<Resource, Field>)
        all.memories.push_back({Field::name, Field::access, Field::blockBytes, Field::ambient});
      else
        all.numbers.push_back({Field::name, Field::type, typename Field::Value{}});
    });
    using Variant = typename VariantOf<Interface>::Type;
    const Variant variant{};
    visitFields(variant, [&](const auto& field) { all.defines.push_back(field.name); });
    all.variants = &variantsOf<Variant>;
    return all;
  }();
  return names;
}

/// Registers an interface in kernelInterfaces() during static initialisation, before main().
template <class Interface>
inline const bool listedKernel = (kernelInterfaces().push_back(&namesOf<Interface>()), true);

/// A compute shader with a typed interface. `Interface` is a plain struct next to the code that runs the
/// kernel:
///
///     struct BlurKernel {
///       static constexpr auto file = "lenia/pad.comp";
///       struct Variant {                        // optional: values that become #define
///         gl::Flag<"DOWN"> down;
///         gl::Choice<"RADIUS", 1, 2, 4> radius;
///       };
///       gl::Uniform<"size", glm::ivec2> size;
///       gl::In<"cells"> cells;  // the name of a block, a block's member, a sampler or an image
///       gl::Out<"nextCells"> next;
///       gl::In<"weights"> weights = {};  // may be omitted if the variant does not read it
///     };
///     gl::Kernel<BlurKernel> blur(gl::kernelDefines(fast), {.down = true, .radius = 2});
///     blur.dispatch(size, {.size = size, .cells = now, .next = next});
///
/// Every dispatch takes all values; an unchanged uniform costs only a comparison. A member of an interface
/// may itself be a struct of fields that several interfaces share. The first use checks two rules and
/// throws UserError(device) with file and name: the shader or its includes declare each name, in any branch
/// of #if; each name that the driver kept gets a value of its type. A value for a name that the driver
/// optimised away is ignored.
///
/// A dispatch waits for earlier kernels that wrote its inputs or outputs, and for earlier kernels that read
/// its outputs (AccessLog). An explicit gl::barrier() is needed only between a Kernel and other readers or
/// writers: a gl::Program, draws, copies.
template <class Interface>
class Kernel {
 public:
  Kernel() = default;
  template <class I = Interface>
  explicit Kernel(const Defines& common, const typename VariantOf<I>::Type& variant = {})
      : base_(std::make_unique<KernelBase>(namesOf<I>(), with(common, variant))) {
    static_cast<void>(listedKernel<I>);
  }
  /// Creates a kernel from a text instead of a file, for tests.
  static Kernel ofText(const char* text) {
    Kernel kernel;
    kernel.base_ = std::make_unique<KernelBase>(namesOf<Interface>(), Defines{}, text);
    return kernel;
  }

  /// Creates a kernel from generated GLSL text. The `file` of the interface is used only in messages. The
  /// text may declare fewer names than the interface has.
  static Kernel generated(const std::string& text, const Defines& defines) {
    Kernel kernel;
    kernel.base_ = std::make_unique<KernelBase>(namesOf<Interface>(), defines, text.c_str(), true);
    return kernel;
  }

  explicit operator bool() const { return base_ != nullptr; }

  /// Runs at least `items` (or x by y) invocations, like Program::dispatch.
  template <class I = Interface>
  void dispatch(int items, const std::type_identity_t<I>& given) const {
    run(given, [&](const KernelBase::Given& all) { base_->dispatch(items, 1, all); });
  }
  template <class I = Interface>
  void dispatch(glm::ivec2 items, const std::type_identity_t<I>& given) const {
    run(given, [&](const KernelBase::Given& all) { base_->dispatch(items.x, items.y, all); });
  }
  template <class I = Interface>
  void dispatchGroups(glm::uvec3 groups, const std::type_identity_t<I>& given) const {
    run(given,
        [&](const KernelBase::Given& all) { base_->dispatchGroups(groups.x, groups.y, groups.z, all); });
  }
  /// Runs as many workgroups as the indirect command at byte `offset` of `commands` says.
  template <class I = Interface>
  void dispatchIndirect(const Buffer& commands, std::size_t offset,
                        const std::type_identity_t<I>& given) const {
    run(given, [&](const KernelBase::Given& all) { base_->dispatchIndirect(commands, offset, all); });
  }

 private:
  template <class Run>
  static void run(const Interface& given, const Run& dispatch) {
    constexpr std::size_t maximum = 128;
    std::array<GivenNumber, maximum> numbers;       // NOLINT(*-member-init): only the filled part is read
    std::array<const Resource*, maximum> memories;  // NOLINT(*-member-init)
    std::size_t numberCount = 0, memoryCount = 0;
    visitFields(given, [&](const auto& field) {
      if constexpr (std::is_base_of_v<Resource, std::remove_cvref_t<decltype(field)>>)
        memories.at(memoryCount++) = &field;
      else
        numbers.at(numberCount++) = {&field.value, field.given};
    });
    dispatch({{numbers.data(), numberCount}, {memories.data(), memoryCount}});
  }

  std::unique_ptr<KernelBase> base_;
};

/// True if 64-bit keys can give every combination of the variant's values a different key.
template <class Variant>
consteval bool distinctKeys(const Variant& variant) {
  std::uint64_t keys = 1;
  bool distinct = true;
  visitFields(variant, [&](const auto& field) {
    constexpr std::uint64_t maximum = ~std::uint64_t{0}, more = std::remove_cvref_t<decltype(field)>::keys;
    distinct = distinct && keys <= maximum / more;
    keys *= more;
  });
  return distinct;
}

/// Owns the kernels of one interface, one per variant. A kernel is created at the first use of its variant.
template <class Interface>
class Kernels {
 public:
  explicit Kernels(Defines common = {}) : common_(std::move(common)) {}
  template <class I = Interface>
  const Kernel<I>& of(const typename VariantOf<I>::Type& variant) {
    static_assert(distinctKeys(typename VariantOf<I>::Type{}));
    std::uint64_t key = 0;
    visitFields(variant, [&](const auto& field) {
      key = key * std::remove_cvref_t<decltype(field)>::keys + field.key();
    });
    const auto found = made_.find(key);
    if (found != made_.end()) return found->second;
    return made_.emplace(key, Kernel<Interface>(common_, variant)).first->second;
  }

 private:
  Defines common_;
  std::map<std::uint64_t, Kernel<Interface>> made_;
};

}  // namespace simreel::gl

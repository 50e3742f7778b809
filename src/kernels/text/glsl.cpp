#include "kernels/text/glsl.hpp"

#include "kernels/spirv/resource.hpp"
#include "kernels/text/loops.hpp"
#include "kernels/text/reflect.hpp"

#include <memory>
#include <spirv_cross_c.h>
#include <stdexcept>
#include <string>
#include <string_view>

namespace simreel::kernels {

namespace {

/// Wraps the C interface of SPIRV-Cross. Error messages come from its context.
class Cross {
 public:
  explicit Cross(const Words& words) {
    spvc_context made = nullptr;
    if (spvc_context_create(&made) != SPVC_SUCCESS)
      throw std::runtime_error("SPIRV-Cross cannot be started");
    context_.reset(made);
    spvc_parsed_ir parsed = nullptr;
    check(spvc_context_parse_spirv(made, words.data(), words.size(), &parsed));
    check(spvc_context_create_compiler(made, SPVC_BACKEND_GLSL, parsed, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP,
                                       &compiler));
  }

  void check(spvc_result result) const {
    if (result != SPVC_SUCCESS)
      throw std::runtime_error(spvc_context_get_last_error_string(context_.get()));
  }

  spvc_compiler compiler = nullptr;

 private:
  struct Destroy {
    void operator()(spvc_context context) const { spvc_context_destroy(context); }
  };
  std::unique_ptr<spvc_context_s, Destroy> context_;
};

void setOptions(const Cross& cross) {
  spvc_compiler_options options = nullptr;
  cross.check(spvc_compiler_create_compiler_options(cross.compiler, &options));
  cross.check(spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_GLSL_VERSION, 450));
  cross.check(spvc_compiler_options_set_bool(options, SPVC_COMPILER_OPTION_GLSL_ES, SPVC_FALSE));
  cross.check(
      spvc_compiler_options_set_bool(options, SPVC_COMPILER_OPTION_GLSL_VULKAN_SEMANTICS, SPVC_FALSE));
  cross.check(spvc_compiler_install_compiler_options(cross.compiler, options));
}

Texture texture(const Module& module, Id variable) {
  Texture made;
  made.name = module.name(variable);
  made.reads = true;
  const Instruction* type = module.global(module.global(module.typeOf(variable))->operands[1]);
  std::string lengths;
  for (; type->op == SpvOpTypeArray; type = module.global(type->operands[0]))
    lengths += fmt::format("[{}]", module.constant(type->operands[1]).value_or(0));
  if (type->op == SpvOpTypeSampledImage) type = module.global(type->operands[0]);
  if (type->op == SpvOpTypeImage) describeImage(module, *type, made);
  made.type += lengths;
  return made;
}

/// Adds explicit memory barriers for shared memory, because Mesa moves reads of it past a bare barrier().
void orderShared(std::string& text) {
  constexpr std::string_view bare = " barrier();",
                             ordered = " memoryBarrierShared(); barrier(); memoryBarrierShared();";
  for (auto at = text.find(bare); at != std::string::npos; at = text.find(bare, at + ordered.size()))
    text.replace(at, bare.size(), ordered);
}

/// Replaces the result of the library's xFused() by a macro. The text has two such functions if both the
/// kernel and its texture filters use the library. Returns false if it has none.
bool chooseFused(std::string& text) {
  constexpr std::string_view name = "bool xFused", result = "return true;";
  bool found = false;
  for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const auto body = text.find(result, at);
    if (body == std::string::npos) continue;
    text.replace(body, result.size(), "return simreel_fused;");
    found = true;
  }
  return found;
}

/// Definition that the runtime may change (sim/kernels/arithmetic.hpp).
constexpr const char* fusedMacro =
    "#ifndef simreel_fused\n"
    "#define simreel_fused true\n"
    "#endif\n";

/// Collects the textures: combined GLSL samplers, and pairs of separate textures and samplers, which this
/// function combines.
void joinSamplers(const Module& module, const Cross& cross, Kernel& kernel) {
  const auto bind = [&](Id id, Texture made, const std::string& name) {
    made.uniform = name;
    made.binding = 0;
    for (const Texture& other : kernel.textures)
      made.binding += other.format.empty() && !other.writes ? 1 : 0;
    spvc_compiler_set_name(cross.compiler, id, name.c_str());
    spvc_compiler_set_decoration(cross.compiler, id, SpvDecorationBinding,
                                 static_cast<unsigned>(made.binding));
    kernel.textures.push_back(std::move(made));
  };
  spvc_variable_id dummy = 0;
  cross.check(spvc_compiler_build_dummy_sampler_for_combined_images(cross.compiler, &dummy));
  cross.check(spvc_compiler_build_combined_image_samplers(cross.compiler));
  const spvc_combined_image_sampler* pairs = nullptr;
  std::size_t count = 0;
  cross.check(spvc_compiler_get_combined_image_samplers(cross.compiler, &pairs, &count));
  for (std::size_t i = 0; i < count; ++i) {
    Texture made = texture(module, pairs[i].image_id);
    if (pairs[i].sampler_id != dummy) made.sampler = module.name(pairs[i].sampler_id);
    const std::string name = made.name + (made.sampler.empty() ? "_texels" : "_" + made.sampler);
    bind(pairs[i].combined_id, std::move(made), name);
  }
  for (const Instruction& one : module.globals) {
    if (resourceOf(module, one) != Resource::texture ||
        resourceType(module, one).op != SpvOpTypeSampledImage)
      continue;
    Texture made = texture(module, one.result);
    made.sampler = made.name;
    const std::string name = made.name;
    bind(one.result, std::move(made), name);
  }
}

}  // namespace

void writeGlsl(const Module& module, Kernel& kernel, bool exact) {
  const Cross cross(module.words());
  setOptions(cross);
  joinSamplers(module, cross, kernel);
  const char* text = nullptr;
  cross.check(spvc_compiler_compile(cross.compiler, &text));
  kernel.glsl = text;
  orderShared(kernel.glsl);
  moveIncrements(kernel.glsl);
  if (!exact || !chooseFused(kernel.glsl)) return;
  std::size_t behind = 0;  // the first line that is not a directive
  while (kernel.glsl[behind] == '#') behind = kernel.glsl.find('\n', behind) + 1;
  kernel.glsl.insert(behind, fusedMacro);
}

}  // namespace simreel::kernels

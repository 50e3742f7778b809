#include "kernels/compile/front_end.hpp"

#include "gl/shader_source.hpp"
#include "kernels/compile/learn.hpp"
#include "kernels/compile/messages.hpp"
#include "kernels/spirv/module.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <memory>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

void initialize() {
  static const bool done = glslang::InitializeProcess();
  if (!done) throw std::runtime_error("glslang cannot be started");
}

/// Passes included files to glslang. glslang knows each file by its index in Files.
class Includer : public glslang::TShader::Includer {
 public:
  explicit Includer(Files& files) : files_(files) {}

  IncludeResult* includeLocal(const char* name, const char* from, std::size_t depth) override {
    return find(name, from, depth, true);
  }
  IncludeResult* includeSystem(const char* name, const char* from, std::size_t depth) override {
    return find(name, from, depth, false);
  }
  void releaseInclude(IncludeResult* result) override {
    // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): glslang returns the object from find()
    delete result;
  }
  /// Returns the names of includes that failed, with the reasons.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& failed() const { return failed_; }

 private:
  IncludeResult* find(const char* name, const char* from, std::size_t depth, bool beside) {
    std::string reason;
    std::optional<std::size_t> found;
    if (depth > maxIncludeDepth)
      reason = fmt::format("{} is included more than {} deep", name, maxIncludeDepth);
    else
      found = files_.include(name, beside, fileNumber(from, files_.count()), reason);
    if (!found) {
      // For #include "name", glslang calls includeLocal() and, if that fails, includeSystem(). Only the
      // first reason is stored, because includeLocal() has also searched the include folders.
      if (std::none_of(failed_.begin(), failed_.end(), [&](const auto& one) { return one.first == name; }))
        failed_.emplace_back(name, reason);
      return nullptr;
    }
    const std::string& text = files_.remediedText(*found);
    // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): deleted by releaseInclude()
    return new IncludeResult(std::to_string(*found), text.data(), text.size(), nullptr);
  }

  Files& files_;
  std::vector<std::pair<std::string, std::string>> failed_;
};

/// Unity's macros for the platform. In Unity they come from its include files.
constexpr const char* unityNames = R"(#define SHADER_API_D3D11 1
#define SHADER_STAGE_COMPUTE 1
#define SHADER_TARGET 50
#define UNITY_VERSION 202230
#define UNITY_UV_STARTS_AT_TOP 1
#define UNITY_REVERSED_Z 1
#define UNITY_NEAR_CLIP_VALUE 1.0
#define UNITY_RAW_FAR_CLIP_VALUE 0.0
#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };
#define GROUPSHARED groupshared
#define UNITY_LOOP [loop]
#define UNITY_UNROLL [unroll]
#define UNITY_UNROLLX(n) [unroll(n)]
#define UNITY_BRANCH [branch]
#define UNITY_FLATTEN [flatten]
#define UNITY_INITIALIZE_OUTPUT(type, name) name = (type)0;
#define fixed float
#define fixed2 float2
#define fixed3 float3
#define fixed4 float4
#define sampler2D_float sampler2D
#define TEXTURE2D(name) Texture2D name
#define TEXTURE3D(name) Texture3D name
#define TEXTURE2D_ARRAY(name) Texture2DArray name
#define SAMPLER(name) SamplerState name
#define RW_TEXTURE2D(type, name) RWTexture2D<type> name
#define RW_TEXTURE3D(type, name) RWTexture3D<type> name
#define LOAD_TEXTURE2D(name, at) name.Load(int3(at, 0))
#define SAMPLE_TEXTURE2D_LOD(name, state, at, lod) name.SampleLevel(state, at, lod)
#define SAMPLE_TEXTURE3D_LOD(name, state, at, lod) name.SampleLevel(state, at, lod)
)";

std::string preamble(const Unit& unit, const Remedies& remedies) {
  std::string text =
      unit.language == Language::hlsl ? unityNames : "#extension GL_GOOGLE_include_directive : enable\n";
  text += functionMacros(remedies);
  for (const auto& [name, value] : unit.defines) text += fmt::format("#define {} {}\n", name, value);
  return text + unit.before;
}

/// A shader and its program. The program is the last member, because glslang requires that it is destroyed
/// first.
struct Compiled {
  glslang::TShader shader{EShLangCompute};
  std::unique_ptr<glslang::TProgram> program;
};

std::vector<std::uint32_t> words(Compiled& compiled, bool lines) {
  glslang::SpvOptions options;
  options.generateDebugInfo = lines;
  options.disableOptimizer = true;
  std::vector<std::uint32_t> made;
  spv::SpvBuildLogger logger;
  glslang::GlslangToSpv(*compiled.program->getIntermediate(EShLangCompute), made, &logger, &options);
  return made;
}

/// Returns true if a kernel has inputs or outputs that are not built-in variables. In this case glslang has
/// used a function of the same name in an included file as the entry point.
bool takesOthers(const std::vector<std::uint32_t>& words) {
  const Module module(words);
  return std::any_of(module.globals.begin(), module.globals.end(), [&](const Instruction& one) {
    if (one.op != SpvOpVariable) return false;
    return one.operands[0] == SpvStorageClassOutput ||
           (one.operands[0] == SpvStorageClassInput &&
            !module.decoration(one.result, SpvDecorationBuiltIn));
  });
}

/// Compiles once. If glslang rejects the code, returns nullopt if a new remedy may fix the code, and
/// otherwise throws the errors.
std::optional<std::vector<std::uint32_t>> attempt(Files& files, const Unit& unit, bool renamed) {
  Compiled compiled;
  glslang::TShader& shader = compiled.shader;
  const std::string before = preamble(unit, files.remedies);
  const std::string name = "0";
  const bool hlsl = unit.language == Language::hlsl;
  std::string whole = files.remediedText(0) + unit.behind;
  const std::string entry = hlsl ? entryName(whole, unit.entry, renamed) : "main";
  const char* text = whole.data();
  const int length = static_cast<int>(whole.size());
  const char* names = name.c_str();
  shader.setStringsWithLengthsAndNames(&text, &length, &names, 1);
  shader.setPreamble(before.c_str());
  shader.setEnvInput(hlsl ? glslang::EShSourceHlsl : glslang::EShSourceGlsl, EShLangCompute,
                     glslang::EShClientVulkan, 110);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  if (!hlsl) shader.setEnvInputVulkanRulesRelaxed();
  shader.setEntryPoint(entry.c_str());
  if (hlsl) shader.setSourceEntryPoint(entry.c_str());
  shader.setAutoMapBindings(true);
  shader.setAutoMapLocations(true);
  auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgSuppressWarnings |
                                           EShMsgDebugInfo);
  if (hlsl) messages = static_cast<EShMessages>(messages | EShMsgReadHlsl);
  Includer includer(files);
  const bool parsed = shader.parse(GetDefaultResources(), hlsl ? 500 : 450, false, messages, includer);
  const bool learned = hlsl && ((!parsed && addRemedies(files, shader.getInfoLog())) ||
                                moveStaticInitializers(files, unit.entry));
  if (learned) return std::nullopt;
  if (!parsed) files.fail(rewordedErrors(shader.getInfoLog(), files, includer.failed(), unit));
  compiled.program = std::make_unique<glslang::TProgram>();
  compiled.program->addShader(&shader);
  const bool linked = compiled.program->link(messages);
  const std::string log = compiled.program->getInfoLog();
  if (!linked || log.find(noEntry) != std::string::npos)
    files.fail(rewordedErrors(log, files, includer.failed(), unit));
  return words(compiled, true);
}

/// Returns the SPIR-V in which constants that a remedy renamed have their original names.
std::vector<std::uint32_t> withOwnNames(const std::vector<std::uint32_t>& words) {
  constexpr std::size_t header = 5;
  std::vector<std::uint32_t> result(words.begin(), words.begin() + header);
  for (std::size_t at = header; at < words.size();) {
    const std::size_t length = std::max(words[at] >> 16U, 1U);
    const auto begin = words.begin() + static_cast<std::ptrdiff_t>(at);
    std::vector<std::uint32_t> one(begin, begin + static_cast<std::ptrdiff_t>(length));
    at += length;
    if ((one[0] & 0xFFFFU) == SpvOpMemberName && one.size() > 3) {
      std::string name(reinterpret_cast<const char*>(&one[3]), (one.size() - 3) * sizeof one[0]);
      if (name.starts_with(constantPrefix)) {
        name.erase(0, constantPrefix.size());
        name.resize(name.find('\0'));
        one.resize(3 + name.size() / sizeof one[0] + 1);
        std::fill(one.begin() + 3, one.end(), 0U);
        std::memcpy(&one[3], name.data(), name.size());
        one[0] = static_cast<std::uint32_t>(one.size()) << 16U | SpvOpMemberName;
      }
    }
    result.insert(result.end(), one.begin(), one.end());
  }
  return result;
}

std::vector<std::uint32_t> compiledAs(Files& files, const Unit& unit, bool renamed) {
  for (;;)
    if (auto made = attempt(files, unit, renamed); made)
      return files.remedies.assigned.empty() ? *made : withOwnNames(*made);
}

}  // namespace

std::vector<std::uint32_t> compile(Files& files, const Unit& unit) {
  initialize();
  std::vector<std::uint32_t> made = compiledAs(files, unit, false);
  if (unit.language == Language::hlsl && takesOthers(made)) {
    made = compiledAs(files, unit, true);
    if (takesOthers(made))
      files.fail(
          {{0, unit.line, unit.entry,
            fmt::format("{} is not a kernel; a kernel must return void, and each of its parameters needs a "
                        "semantic such as SV_DispatchThreadID",
                        scene::inQuotes(unit.entry))}});
  }
  return made;
}

std::vector<std::uint32_t> compileLibrary(const std::string& text) {
  initialize();
  Compiled compiled;
  glslang::TShader& shader = compiled.shader;
  const char* whole = text.c_str();
  shader.setStrings(&whole, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 110);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgKeepUncalled);
  const bool parsed = shader.parse(GetDefaultResources(), 450, false, messages);
  compiled.program = std::make_unique<glslang::TProgram>();
  compiled.program->addShader(&shader);
  if (!parsed || !compiled.program->link(messages))
    throw std::runtime_error(fmt::format("the library of exact functions does not compile: {}{}",
                                         shader.getInfoLog(), compiled.program->getInfoLog()));
  return words(compiled, false);
}

}  // namespace simreel::kernels

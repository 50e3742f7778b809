#include "kernels/shader/shader.hpp"

#include <nlohmann/json.hpp>

namespace simreel::kernels {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Member, name, type, offset, bytes, array, stride, members, used)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Buffer, name, binding, reads, writes, counterOf, previousOf, shadowOf,
                                   shadowWords, guards, members)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Texture, name, type, values, format, sampler, uniform, binding, reads,
                                   writes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Block, name, binding, bytes, members)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Place, kind, what, part, file, line)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Kernel, name, line, threads, axes, buffers, textures, blocks, report,
                                   places, glsl)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Shader, language, keywords, kernels, files)

std::string Kernel::body() const {
  std::string text = glsl;
  if (text.starts_with("#version")) text.replace(0, text.find('\n'), "");
  return text;
}

std::string toJson(const Shader& shader, int indent) {
  return nlohmann::json(shader).dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

Shader fromJson(const std::string& text) {
  return nlohmann::json::parse(text).get<Shader>();
}

}  // namespace simreel::kernels

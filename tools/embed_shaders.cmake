# Writes OUT: a C++ table of (path below glsl/, text) of FILES, which are relative to ROOT.
# A string literal has a length limit, so the texts are written as byte arrays.
set(ARRAYS "")
set(TABLE "")
set(COUNT 0)
foreach(FILE IN LISTS FILES)
  file(READ ${ROOT}/${FILE} HEX HEX)
  string(REGEX REPLACE "(..)" "0x\\1," BYTES "${HEX}")
  string(REGEX REPLACE "^glsl/" "" NAME ${FILE})
  string(APPEND ARRAYS "const unsigned char text${COUNT}[] = {${BYTES}0};\n")
  string(APPEND TABLE "    {\"${NAME}\", reinterpret_cast<const char*>(text${COUNT})},\n")
  math(EXPR COUNT "${COUNT} + 1")
endforeach()
file(WRITE ${OUT} "#include \"gl/shader_source.hpp\"\n\nnamespace {\n${ARRAYS}}  // namespace\n
namespace simreel::gl {\nstd::span<const EmbeddedShader> embeddedShaders() {
  static const EmbeddedShader table[] = {\n${TABLE}  };\n  return table;\n}\n}  // namespace simreel::gl\n")

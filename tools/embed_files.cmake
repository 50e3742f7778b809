# Writes OUT: a C++ table of (path below PREFIX, text) of FILES, which are relative to ROOT. HEADER declares
# the function FUNCTION, which returns a span of ENTRY, a struct {const char* path; const char* text;}.
# A string literal has a length limit, so the texts are written as byte arrays.
set(ARRAYS "")
set(TABLE "")
set(COUNT 0)
string(LENGTH "${PREFIX}" PREFIX_LENGTH)
foreach(FILE IN LISTS FILES)
  file(READ ${ROOT}/${FILE} HEX HEX)
  string(REGEX REPLACE "(..)" "0x\\1," BYTES "${HEX}")
  string(SUBSTRING ${FILE} ${PREFIX_LENGTH} -1 NAME)
  string(APPEND ARRAYS "const unsigned char text${COUNT}[] = {${BYTES}0};\n")
  string(APPEND TABLE "    {\"${NAME}\", reinterpret_cast<const char*>(text${COUNT})},\n")
  math(EXPR COUNT "${COUNT} + 1")
endforeach()
file(WRITE ${OUT} "#include \"${HEADER}\"\n\nnamespace {\n${ARRAYS}}  // namespace\n
std::span<const ${ENTRY}> ${FUNCTION}() {
  static const ${ENTRY} table[] = {\n${TABLE}  };\n  return table;\n}\n")

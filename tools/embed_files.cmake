# Writes the C++ file OUT with a table that contains the path below PREFIX and the text of each file in FILES. The paths
# in FILES are relative to ROOT. The file includes HEADER, which declares FUNCTION. FUNCTION returns the table as a span
# of ENTRY, a struct {const char* path; const char* text;}. The texts are string literals, because they compile a
# hundred times faster than arrays of numbers.
set(TABLE "")
string(LENGTH "${PREFIX}" PREFIX_LENGTH)
foreach(FILE IN LISTS FILES)
  file(READ ${ROOT}/${FILE} TEXT)
  if(TEXT MATCHES "[)]embedded\"")
    message(FATAL_ERROR "${FILE} holds what ends a literal here")
  endif()
  string(SUBSTRING ${FILE} ${PREFIX_LENGTH} -1 NAME)
  string(APPEND TABLE "    {\"${NAME}\", R\"embedded(${TEXT})embedded\"},\n")
endforeach()
file(WRITE ${OUT} "#include \"${HEADER}\"\n
#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n
std::span<const ${ENTRY}> ${FUNCTION}() {
  static const ${ENTRY} table[] = {\n${TABLE}  };\n  return table;\n}\n")

# Defines the target simreel_shader_compilers, which links glslang, SPIRV-Tools and SPIRV-Cross, as packaged in Debian
# 12 and 13 and Ubuntu 24.04. Archives are searched by name, because the list of glslang's archives depends on its
# version (later versions contain HLSL, OGLCompiler and OSDependent in other archives), and because glslang's CMake
# package requires programs that other packages contain.
add_library(simreel_shader_compilers INTERFACE)
find_path(GLSLANG_INCLUDE glslang/Public/ShaderLang.h REQUIRED)
find_path(SPIRV_TOOLS_INCLUDE spirv-tools/optimizer.hpp REQUIRED)
target_include_directories(simreel_shader_compilers SYSTEM INTERFACE ${GLSLANG_INCLUDE} ${SPIRV_TOOLS_INCLUDE})
find_library(GLSLANG_MAIN glslang REQUIRED)
find_library(SPIRV_TOOLS_OPT SPIRV-Tools-opt REQUIRED)
find_library(SPIRV_TOOLS SPIRV-Tools REQUIRED)
set(COMPILER_ARCHIVES ${GLSLANG_MAIN})
foreach(name SPIRV HLSL MachineIndependent GenericCodeGen OGLCompiler OSDependent glslang-default-resource-limits)
  find_library(GLSLANG_${name} ${name})
  mark_as_advanced(GLSLANG_${name})
  if(GLSLANG_${name})
    list(APPEND COMPILER_ARCHIVES ${GLSLANG_${name}})
  endif()
endforeach()
find_package(Threads REQUIRED)
# The archives depend on one another in a cycle.
target_link_libraries(simreel_shader_compilers INTERFACE
  -Wl,--start-group ${COMPILER_ARCHIVES} ${SPIRV_TOOLS_OPT} ${SPIRV_TOOLS} -Wl,--end-group Threads::Threads)
pkg_check_modules(SPIRV_CROSS REQUIRED IMPORTED_TARGET spirv-cross-c-shared)
target_link_libraries(simreel_shader_compilers INTERFACE PkgConfig::SPIRV_CROSS)

# simreel_shader_compilers: glslang, SPIRV-Tools and SPIRV-Cross, as Debian 12 and 13 and Ubuntu 24.04 have them. glslang's archives
# have other names and numbers from version to version (HLSL, OGLCompiler and OSDependent went into others), and its CMake package
# asks for programs of other packages, so that each archive is taken where it is.
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
# They use each other in a circle.
target_link_libraries(simreel_shader_compilers INTERFACE
  -Wl,--start-group ${COMPILER_ARCHIVES} ${SPIRV_TOOLS_OPT} ${SPIRV_TOOLS} -Wl,--end-group Threads::Threads)
pkg_check_modules(SPIRV_CROSS REQUIRED IMPORTED_TARGET spirv-cross-c-shared)
target_link_libraries(simreel_shader_compilers INTERFACE PkgConfig::SPIRV_CROSS)

#include "cli/list/environment.hpp"

#include <array>

namespace simreel::cli {

std::span<const Variable> variables() {
  static constexpr std::array<Variable, 21> all = {{
      {"COLUMNS", "Width of help and lists in characters, instead of the terminal's."},
      {"SIMREEL_ASSETS",
       "Folder of the shipped assets (scenes, fonts, meshes, textures), instead of the installed one."},
      {"SIMREEL_CAREFUL",
       "1: users' kernels divide and take roots in integers, as on drivers whose arithmetic differs. The "
       "results are the same."},
      {"SIMREEL_GLSL", "Folder of shaders to use instead of those built into the program."},
      {"SIMREEL_JOIN_SURFACES",
       "yes or no: whether the exact rasterizer draws surfaces together. The pixels are the same; left "
       "out: "
       "yes on GPUs, no on software drivers."},
      {"SIMREEL_LARGE_PAGES",
       "no: do not take large buffers through Vulkan, which gives them large pages. The default is yes, "
       "where the driver can."},
      {"SIMREEL_SAMPLE_LAYOUT",
       "apart, pairs or wholes: how the exact rasterizer stores samples. The pixels are the same; the "
       "driver decides if it is left out."},
      {"SIMREEL_STACK_TAKEN", "The program sets it when it starts itself again with a larger stack."},
      {"LP_NUM_THREADS", "Threads of Mesa's software driver. The program sets it where it is not set."},
      {"GALLIUM_OVERRIDE_CPU_CAPS, LP_NATIVE_VECTOR_WIDTH, GALLIVM_PERF, LP_PERF",
       "Settings of Mesa's software driver. Reports name those that are set."},
      {"LIBGL_ALWAYS_SOFTWARE, GALLIUM_DRIVER, MESA_LOADER_DRIVER_OVERRIDE",
       "Choose Mesa's driver. `simreel doctor` names those that are set."},
      {"MESA_GL_VERSION_OVERRIDE, MESA_GLSL_VERSION_OVERRIDE, MESA_EXTENSION_OVERRIDE",
       "Change what Mesa's driver offers. `simreel doctor` names those that are set."},
      {"LIBGL_DRIVERS_PATH, EGL_PLATFORM, DRI_PRIME, __EGL_VENDOR_LIBRARY_FILENAMES, "
       "__EGL_VENDOR_LIBRARY_DIRS, VK_ICD_FILENAMES, VK_DRIVER_FILES",
       "Choose the drivers of EGL and Vulkan. `simreel doctor` names those that are set."},
      {"MESA_SHADER_CACHE_DIR, MESA_SHADER_CACHE_DISABLE, MESA_GLSL_CACHE_DIR, MESA_GLSL_CACHE_DISABLE",
       "Mesa's cache of compiled shaders. With the cache off, every run compiles its shaders again."},
      {"XDG_CACHE_HOME, HOME", "Where Mesa keeps that cache, if its own variables do not say."},
      {"WORKSPACE, CI_PROJECT_DIR",
       "Project folder in Jenkins and GitLab: JUnit files name pictures relative to it."},
      {"GITHUB_STEP_SUMMARY", "File to which `simreel test --github` adds a summary of the run."},
      {"SIMREEL_SCENE", "Set for the command of `simreel test --run`: the scene's file."},
      {"SIMREEL_BASE", "Set for the command of `simreel test --run`: the name of the scene's baselines."},
      {"SIMREEL_OUTPUT", "Set for the command of `simreel test --run`: where it writes its pictures."},
      {"any name in --scratch", "`--scratch '$TMPDIR/x'` reads the variable on the machine that renders."},
  }};
  return all;
}

}  // namespace simreel::cli

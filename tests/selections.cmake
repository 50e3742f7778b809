# Contents of the selections of tools/test. Without an argument, tools/test checks in two minutes that this build works
# on this machine, and compiles only the test sources in QUICK_SOURCES. `tools/test ci` runs the tests of CI, and
# `tools/test all` runs all tests.

# Unit tests of reading, planning and writing, and tests of the kernels of each simulation by comparison with CPU twins.
# quick_cases.txt lists the cases.
set(QUICK_UNIT base batch draw frame gl scene)
set(QUICK_KERNELS automata body cave cloth collide contact deform epidemic fluid fluid_tracers garment gravity_tree gray_scott isosurface
    lenia life particles reaction solid walls water wildfire)
list(JOIN QUICK_UNIT "|" units)
list(JOIN QUICK_KERNELS "|" kernels)
set(QUICK_SOURCES "/tests/(unit/(${units})/[^/]+|gpu/sim/(${kernels}))[.]cpp$")

# A dozen shipped scenes that cover most simulations and most methods of drawing.
set(QUICK_SCENES cape cascade cave_map contour crystal epidemic flag life ripple smoke sparks waves)

# Modules of command-line tests about success, errors, killing and resuming.
set(QUICK_CLI success usage resume reproduce)

# Groups of tests on a device. A group has a name, a pattern of sources, and optionally "nopt", which turns off LLVM's
# optimizer. Each group is one process, so it compiles a shader once. In tests of pictures and of many kernels,
# llvmpipe's compiler takes most of the time. Without optimization it must produce the same bits, in less time. "golden:
# shipped scenes" and "cli: storage_path" run shaders with optimization, as users do. Most simulation kernels have
# barriers, and their coroutines run half as fast without optimization, so they are optimized.
set(GPU_GROUPS
  "draw @ ^gpu/draw/[^/]+$ @ nopt"
  "draw/exact a to k @ ^gpu/draw/exact/[a-k] @ nopt"
  "draw/exact l to z @ ^gpu/draw/exact/ @ nopt"
  "sim: fluids @ ^gpu/sim/fluid @ nopt"
  "sim: cloth, reactions and automata @ ^gpu/sim/(automata|cloth|collide|reaction) @ nopt"
  "sim: all else @ ^gpu/sim/ @ "
  "device, functions, states @ . @ ")

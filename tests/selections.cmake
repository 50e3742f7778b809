# Contents of the selections of tools/test. Without an argument, it tells in two minutes if this build works on this machine: it
# compiles only the sources of QUICK_SOURCES. `tools/test ci` runs CI's tests, `tools/test all` runs everything.

# Unit tests of reading, planning and writing. Kernels of each simulation beside their twins; quick_cases.txt names the cases.
set(QUICK_UNIT base batch draw frame gl scene)
set(QUICK_KERNELS automata body cave cloth collide contact deform epidemic fluid fluid_tracers garment gravity_tree gray_scott isosurface
    lenia life particles reaction solid walls water wildfire)
list(JOIN QUICK_UNIT "|" units)
list(JOIN QUICK_KERNELS "|" kernels)
set(QUICK_SOURCES "/tests/(unit/(${units})/[^/]+|gpu/sim/(${kernels}))[.]cpp$")

# A dozen shipped scenes: one of most simulations, and most ways to draw.
set(QUICK_SCENES cape cascade cave_map contour crystal epidemic flag life ripple smoke sparks waves)

# Modules of the command line: success, mistakes, kill and resume.
set(QUICK_CLI success usage resume reproduce)

# Groups of tests on a device: a name, the sources, and nopt where LLVM does not optimize. A group is one process, so it compiles a
# shader once. Most time of pictures and kernels of many kinds is llvmpipe's compiler. Without optimizing, it has to produce the same
# bits, sooner. "golden: shipped scenes" and "cli: storage_path" run shaders as users do. Most kernels that step have barriers: their
# coroutines take twice as long without optimizing.
set(GPU_GROUPS
  "draw @ ^gpu/draw/[^/]+$ @ nopt"
  "draw/exact a to k @ ^gpu/draw/exact/[a-k] @ nopt"
  "draw/exact l to z @ ^gpu/draw/exact/ @ nopt"
  "sim: fluids @ ^gpu/sim/fluid @ nopt"
  "sim: cloth, reactions and automata @ ^gpu/sim/(automata|cloth|collide|reaction) @ nopt"
  "sim: all else @ ^gpu/sim/ @ "
  "device, functions, states @ . @ ")

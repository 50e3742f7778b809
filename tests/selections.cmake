# What each selection of tools/test has. `tools/test`: whether this build works on this machine, in two minutes; it compiles what
# QUICK_SOURCES names alone. `tools/test ci`: what CI runs. `tools/test all`: everything.

# Tests of what reads, plans and writes; each simulation's kernels beside their twins (quick_cases.txt says which cases of those).
set(QUICK_UNIT base batch draw frame gl scene)
set(QUICK_KERNELS automata body cave cloth collide contact deform epidemic fluid fluid_tracers garment gravity_tree gray_scott isosurface
    lenia life particles reaction solid walls water wildfire)
list(JOIN QUICK_UNIT "|" units)
list(JOIN QUICK_KERNELS "|" kernels)
set(QUICK_SOURCES "/tests/(unit/(${units})/[^/]+|gpu/sim/(${kernels}))[.]cpp$")

# Shipped scenes of a dozen simulations, with what is drawn in most ways.
set(QUICK_SCENES cape cascade cave_map contour crystal epidemic flag life ripple smoke sparks waves)

# The command line: what works, what is refused, kills and resumes, a report.
set(QUICK_CLI success usage resume reproduce)

# Groups of tests on a device: a name, the sources, and whether LLVM leaves out optimizing. A process each, or it would compile again
# what another has compiled; two at a time take the same shaders from none. Most of what pictures and kernels of many kinds take is
# the compiler of llvmpipe. Without optimizing it has to come to the same bits sooner; what it makes of the shaders as users run them:
# "golden: shipped scenes", "cli: storage_path". Most kernels that step have barriers, whose coroutines take it twice as long so.
set(GPU_GROUPS
  "draw @ ^gpu/draw/[^/]+$ @ nopt"
  "draw/exact a to k @ ^gpu/draw/exact/[a-k] @ nopt"
  "draw/exact l to z @ ^gpu/draw/exact/ @ nopt"
  "sim: fluids @ ^gpu/sim/fluid @ nopt"
  "sim: cloth, reactions and automata @ ^gpu/sim/(automata|cloth|collide|reaction) @ nopt"
  "sim: all else @ ^gpu/sim/ @ "
  "device, functions, states @ . @ ")

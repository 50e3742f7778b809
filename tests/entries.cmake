# Entries of ctest. Label quick: tools/test runs the entry. Label long: only `tools/test all` runs it. CI runs every
# entry that is not long.

# Seconds until ctest treats a test as hung; tests usually take less than a tenth of it.
set(PATIENCE 3600)

# Cases that take seconds and resemble other cases.
file(STRINGS long_cases.txt LONG_CASES)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS long_cases.txt)
list(JOIN LONG_CASES "," LONG_CASES)
file(STRINGS quick_cases.txt QUICK_CASES)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS quick_cases.txt)
list(JOIN QUICK_CASES "," QUICK_CASES)
# Adds an entry that runs some cases of a doctest program. `label` is added to the suite's label: quick, long or empty.
function(suite_test label suite name program)
  add_test(NAME "${suite}: ${name}" COMMAND ${program} ${ARGN})
  set_tests_properties("${suite}: ${name}" PROPERTIES LABELS "${suite};${label}" TIMEOUT ${PATIENCE}
                       # the entry fails if no test case matches, for example because a source was renamed
                       FAIL_REGULAR_EXPRESSION "test cases: +0 ")
endfunction()
function(without_optimizing)
  set_property(TEST ${ARGN} APPEND PROPERTY ENVIRONMENT GALLIVM_PERF=nopt)
endfunction()

# One process runs many sources, because starting a process takes longer than most tests, and creating a context takes a
# quarter of a second.
file(GLOB_RECURSE SOURCES RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS unit/*.cpp gpu/*.cpp)
suite_test(quick unit "what reads, plans and writes" test_quick "--source-file=*/tests/unit/*" "--test-case-exclude=${LONG_CASES}")
suite_test(quick gpu "kernels and their twins" test_quick "--source-file=*/tests/gpu/*" "--test-case=${QUICK_CASES}")
foreach(source ${SOURCES} example/heat.cpp)
  file(STRINGS ${source} CASES REGEX "^TEST_CASE")
  if(CASES AND source MATCHES "^unit/" AND NOT "/tests/${source}" MATCHES "${QUICK_SOURCES}")
    list(APPEND patterns "*/tests/${source}")
  elseif(CASES AND NOT source MATCHES "^unit/")
    list(APPEND ON_DEVICE ${source})
  endif()
endforeach()
foreach(group "sim, a to f=sim/[a-f]" "sim, g to z=sim/" "comparing, command line, hostile files=.")
  string(REGEX MATCH "^(.*)=(.*)$" all "${group}")
  set(name ${CMAKE_MATCH_1})
  set(chosen ${patterns})
  list(FILTER chosen INCLUDE REGEX "/unit/${CMAKE_MATCH_2}")
  list(REMOVE_ITEM patterns ${chosen})
  list(JOIN chosen "," chosen)
  suite_test("" unit "${name}" test_unit "--source-file=${chosen}" "--test-case-exclude=${LONG_CASES}")
endforeach()
set(GPU_PICTURES "")
foreach(group ${GPU_GROUPS})
  string(REGEX MATCH "^(.*) @ (.*) @ (.*)$" all "${group}")
  set(name ${CMAKE_MATCH_1})
  set(optimizing "${CMAKE_MATCH_3}")
  set(chosen ${ON_DEVICE})
  list(FILTER chosen INCLUDE REGEX "${CMAKE_MATCH_2}")
  list(REMOVE_ITEM ON_DEVICE ${chosen})
  list(TRANSFORM chosen PREPEND "*/tests/")
  list(JOIN chosen "," chosen)
  suite_test("" gpu "${name}" test_gpu "--source-file=${chosen}" "--test-case-exclude=${LONG_CASES},${QUICK_CASES}")
  if(optimizing STREQUAL nopt)
    without_optimizing("gpu: ${name}")
  endif()
  if(name MATCHES "^draw")
    list(APPEND GPU_PICTURES "gpu: ${name}")
  endif()
endforeach()

add_test(NAME "layers: each includes only from layers below it" COMMAND ${CMAKE_SOURCE_DIR}/tools/check-layers)
add_test(NAME "comments: files and symbols that they name exist" COMMAND ${CMAKE_SOURCE_DIR}/tools/check-comments)
add_test(NAME "gallery: each picture is of today's scene" COMMAND Python3::Interpreter ${CMAKE_SOURCE_DIR}/tools/gallery --check)
add_test(NAME "shaders: arithmetic is precise, blocks are as in C++" COMMAND ${CMAKE_SOURCE_DIR}/tools/check-shaders)
set_tests_properties("layers: each includes only from layers below it" "comments: files and symbols that they name exist"
                     "gallery: each picture is of today's scene" "shaders: arithmetic is precise, blocks are as in C++"
                     PROPERTIES LABELS "unit;quick")

# Tests on the memory path that the driver does not use by default: those that compare bit for bit with CPU twins or the
# expression evaluator. Tests of the meaning of the same bits (closed forms, counts) run on the default path only. "cli:
# storage_path" runs one scene of each simulation.
set(SAME_STATE "--source-file=*/gpu/sim/*"
  "--test-case=*twin*,*evaluator*,*every cut*,*every run*,field values*,radix sort*,tallies*,the state hash*")
# Picture tests that compare bytes with a twin or with another way of drawing.
set(OTHER_PICTURES "--source-file=*/gpu/draw/*" "--source-file-exclude=*/draw/exact/limits.cpp")
# Triangles, textures and ambient occlusion are left out here, because "cli: storage_path" compares scenes that contain
# them with their baselines byte for byte.
suite_test("" gpu "pictures on the other memory path" test_gpu ${OTHER_PICTURES} "--test-case=*twin*,*bytes*,*bits*"
  "--test-case-exclude=*charts*,exact: on a large*,*ambient occlusion*,*drawn in bands*,exact parts*,exact: whole*,exact: t*,exact: what triangles*")
suite_test("" gpu "a fluid on the other memory path" test_gpu "--test-case=fluid equals its CPU twin where*")
# Divisions and roots of users' kernels in integers, which no driver of this machine needs.
suite_test("" gpu "user kernels in integers" test_gpu "--test-case=user kernels: *")
# Tests of the driver's rasterizer, which serves as reference for the exact rasterizer; in CI only its surfaces and
# glows. "cli: exact" covers whole scenes.
set(DRIVERS_PICTURES "--source-file=*/gpu/draw/*" "--source-file-exclude=*/draw/exact/*")
suite_test("" gpu "the driver's surfaces and glows on the texel memory path" test_gpu "--source-file=*/gpu/draw/picture.cpp,*/gpu/draw/instances.cpp")
suite_test("" long "the driver's pictures on the texel memory path" test_gpu ${DRIVERS_PICTURES})
suite_test("" long "state on the other memory path" test_gpu ${SAME_STATE})
suite_test("" long "pictures on the other memory path" test_gpu ${OTHER_PICTURES})
suite_test("" long "the driver's pictures on the storage memory path" test_gpu ${DRIVERS_PICTURES})
add_test(NAME "long: unit tests" COMMAND test_unit "--test-case=${LONG_CASES}")
set_tests_properties("long: unit tests" PROPERTIES LABELS long)
add_test(NAME "long: tests on a device" COMMAND test_gpu "--test-case=${LONG_CASES}")
set_tests_properties("long: tests on a device" PROPERTIES LABELS long TIMEOUT ${PATIENCE})
if(SIMREEL_BENCH)  # takes minutes on two processors for programs that users do not run
  add_test(NAME "long: benches build" COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target bench)
  set_tests_properties("long: benches build" PROPERTIES LABELS long TIMEOUT ${PATIENCE})
endif()
set_property(TEST "gpu: pictures on the other memory path" "gpu: a fluid on the other memory path" "long: state on the other memory path"
             "long: pictures on the other memory path" APPEND PROPERTY ENVIRONMENT SIMREEL_TEST_MEMORY_PATH=other)
set_property(TEST "gpu: user kernels in integers" APPEND PROPERTY ENVIRONMENT SIMREEL_CAREFUL=1)
set_property(TEST "gpu: the driver's surfaces and glows on the texel memory path" "long: the driver's pictures on the texel memory path" APPEND PROPERTY ENVIRONMENT SIMREEL_TEST_RASTERIZER=driver
             SIMREEL_TEST_MEMORY_PATH=texel)
set_property(TEST "long: the driver's pictures on the storage memory path" APPEND PROPERTY ENVIRONMENT SIMREEL_TEST_RASTERIZER=driver
             SIMREEL_TEST_MEMORY_PATH=storage)
# These entries run without LLVM's optimizer, like the groups of pictures that they depend on. Mesa's cache keeps optimized
# shaders apart from others, so these entries find the shaders of those groups only if they run in the same way.
without_optimizing("gpu: pictures on the other memory path" "gpu: the driver's surfaces and glows on the texel memory path")
set_tests_properties("gpu: pictures on the other memory path" "gpu: the driver's surfaces and glows on the texel memory path"
                     PROPERTIES DEPENDS "${GPU_PICTURES}")

# Tests of the command line from the outside: one ctest entry per module, standard library only.
if(Python3_FOUND AND TARGET simreel)
  file(GLOB_RECURSE CLI_TESTS CONFIGURE_DEPENDS cli/test_*.py)
  set(CLI_ENVIRONMENT "SIMREEL=$<TARGET_FILE:simreel>" "PYTHONPATH=${CMAKE_CURRENT_SOURCE_DIR}/cli" PYTHONDONTWRITEBYTECODE=1)
  foreach(file ${CLI_TESTS})
    string(REGEX REPLACE "^.*/test_|[.]py$" "" module ${file})
    add_test(NAME "cli: ${module}" COMMAND Python3::Interpreter ${file})
    set_tests_properties("cli: ${module}" PROPERTIES LABELS cli TIMEOUT ${PATIENCE} ENVIRONMENT "${CLI_ENVIRONMENT}")
    if(module IN_LIST QUICK_CLI)
      set_property(TEST "cli: ${module}" APPEND PROPERTY LABELS quick)
    endif()
    # many small pictures, so compiling shaders takes most of the time, as in gpu/draw above
    if(module MATCHES "^(serve.*|data_pictures|film|framing|materials|over_picture|passes|views)$")
      without_optimizing("cli: ${module}")
    endif()
  endforeach()
  foreach(module exact mutation)  # tests of all shipped scenes
    add_test(NAME "long: ${module}" COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/cli/golden/test_${module}.py)
    set_tests_properties("long: ${module}" PROPERTIES LABELS long TIMEOUT ${PATIENCE} ENVIRONMENT "${CLI_ENVIRONMENT};SIMREEL_LONG=1")
  endforeach()
  add_test(NAME "long: stage" COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/cli/scenes/test_stage.py Stage.test_pictures_of_scenes_of_one_line)
  set_tests_properties("long: stage" PROPERTIES LABELS long TIMEOUT ${PATIENCE} ENVIRONMENT "${CLI_ENVIRONMENT};SIMREEL_LONG=1")
  # this test runs Blender
  add_test(NAME "long: cycles" COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/cli/scenes/test_cycles.py)
  set_tests_properties("long: cycles" PROPERTIES LABELS long TIMEOUT ${PATIENCE} ENVIRONMENT "${CLI_ENVIRONMENT};SIMREEL_LONG=1")
endif()
if(Python3_FOUND AND TARGET simreel)
  add_subdirectory(faults)
endif()
# Random programs in both languages of kernels, executed on the device and by Python.
if(Python3_FOUND AND TARGET simreel)
  foreach(language hlsl glsl)
    add_test(NAME "kernels: random programs of ${language}"
             COMMAND Python3::Interpreter ${CMAKE_SOURCE_DIR}/tools/programs --count 60 --seed 12 --language ${language})
    set_tests_properties("kernels: random programs of ${language}" PROPERTIES LABELS gpu TIMEOUT ${PATIENCE} ENVIRONMENT "SIMREEL=$<TARGET_FILE:simreel>")
  endforeach()
endif()

# Tests of the report's page in Chromium and Firefox; skipped with a message if a browser or Selenium is not installed.
# Debian's own Python is tried first, because python3-selenium belongs to it.
find_program(SYSTEM_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NOT SYSTEM_PYTHON AND Python3_FOUND)
  set(SYSTEM_PYTHON ${Python3_EXECUTABLE})
endif()
if(TARGET simreel)
  set(SIMREEL_PROGRAM $<TARGET_FILE:simreel>)
endif()
if(SYSTEM_PYTHON)
  add_test(NAME "browser: report" COMMAND ${SYSTEM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/browser/test_report.py)
  set_tests_properties("browser: report" PROPERTIES LABELS browser TIMEOUT ${PATIENCE} SKIP_RETURN_CODE 77
                       ENVIRONMENT "MAKE_REPORT=$<TARGET_FILE:make_report>;SIMREEL=${SIMREEL_PROGRAM};PYTHONDONTWRITEBYTECODE=1")
  if(TARGET simreel)
    add_test(NAME "browser: serve" COMMAND ${SYSTEM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/browser/test_serve.py)
    set_tests_properties("browser: serve" PROPERTIES LABELS browser TIMEOUT ${PATIENCE} SKIP_RETURN_CODE 77
                         ENVIRONMENT "SIMREEL=${SIMREEL_PROGRAM};PYTHONDONTWRITEBYTECODE=1;GALLIVM_PERF=nopt")
    add_test(NAME "browser: serve in Firefox" COMMAND ${SYSTEM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/browser/test_serve_firefox.py)
    set_tests_properties("browser: serve in Firefox" PROPERTIES LABELS browser TIMEOUT ${PATIENCE} SKIP_RETURN_CODE 77
                         ENVIRONMENT "SIMREEL=${SIMREEL_PROGRAM};PYTHONDONTWRITEBYTECODE=1;GALLIVM_PERF=nopt")
  endif()
endif()

# Sweeps and pieces on a real Slurm with three nodes on this machine; skipped with a message if Slurm is not installed,
# never skipped in CI.
if(Python3_FOUND AND TARGET simreel)
  add_test(NAME "slurm: sweep and pieces" COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/slurm/test_slurm.py)
  set_tests_properties("slurm: sweep and pieces" PROPERTIES LABELS cli TIMEOUT ${PATIENCE} SKIP_RETURN_CODE 77 COST 60
                       ENVIRONMENT "SIMREEL=$<TARGET_FILE:simreel>;PYTHONDONTWRITEBYTECODE=1")
endif()

# Compares contours of the program with those of scikit-image; skipped with a message if scikit-image is not installed.
if(SYSTEM_PYTHON AND TARGET simreel)
  add_test(NAME "oracle: contours" COMMAND ${SYSTEM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/oracle/test_contours.py)
  set_tests_properties("oracle: contours" PROPERTIES LABELS cli TIMEOUT ${PATIENCE} SKIP_RETURN_CODE 77
                       ENVIRONMENT "SIMREEL=$<TARGET_FILE:simreel>;PYTHONDONTWRITEBYTECODE=1")
endif()

# The Python module; skipped with a message if it was not built, never in CI.
if(SYSTEM_PYTHON AND TARGET simreel)
  set(PYTHON_ENVIRONMENT "SIMREEL=$<TARGET_FILE:simreel>;PYTHONPATH=${CMAKE_BINARY_DIR}/python;PYTHONDONTWRITEBYTECODE=1")
  foreach(module module processes state tools)
    add_test(NAME "python: ${module}" COMMAND ${SYSTEM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/python/test_${module}.py)
    set_tests_properties("python: ${module}" PROPERTIES LABELS python TIMEOUT ${PATIENCE} SKIP_RETURN_CODE 77 ENVIRONMENT "${PYTHON_ENVIRONMENT}")
  endforeach()
  add_test(NAME "long: a thousand scenes" COMMAND ${SYSTEM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/python/test_processes.py
           Processes.test_opened_and_closed_scenes_leave_no_memory)
  add_test(NAME "long: every kind from Python" COMMAND ${SYSTEM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/python/test_module.py
           State.test_every_kind_goes_on_from_what_was_read_and_written)
  set_tests_properties("long: a thousand scenes" "long: every kind from Python" PROPERTIES LABELS long TIMEOUT ${PATIENCE} SKIP_RETURN_CODE 77 ENVIRONMENT "${PYTHON_ENVIRONMENT};SIMREEL_LONG=1")
endif()

# Compares every shipped scene with its baselines; the long scenes have an entry of their own.
if(TARGET simreel)
  file(GLOB SCENES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/assets/scenes/*.json)
  file(STRINGS long_scenes.txt LONG_SCENES)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS long_scenes.txt)
  list(TRANSFORM LONG_SCENES REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/assets/scenes/\\1.json")
  list(REMOVE_ITEM SCENES ${LONG_SCENES})
  # The slowest of the long scenes; other scenes cover the same kinds and ways of drawing.
  set(LONGEST_SCENES drape press)
  list(TRANSFORM LONGEST_SCENES REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/assets/scenes/\\1.json")
  list(REMOVE_ITEM LONG_SCENES ${LONGEST_SCENES})
  # One repetition is enough: both memory paths, with many threads and with one, must reproduce the baselines' state.
  list(TRANSFORM QUICK_SCENES REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/assets/scenes/\\1.json")
  list(REMOVE_ITEM SCENES ${QUICK_SCENES})
  add_test(NAME "golden: a dozen scenes" COMMAND simreel test ${QUICK_SCENES} --repeat 1 --report ${CMAKE_CURRENT_BINARY_DIR}/report)
  set_tests_properties("golden: a dozen scenes" PROPERTIES LABELS "golden;quick" TIMEOUT ${PATIENCE} COST 100)
  add_test(NAME "golden: shipped scenes" COMMAND simreel test ${SCENES} --repeat 1)
  add_test(NAME "golden: long scenes" COMMAND simreel test ${LONG_SCENES} --repeat 1)
  add_test(NAME "long: longest scenes" COMMAND simreel test ${LONGEST_SCENES} --repeat 1)
  set_tests_properties("golden: shipped scenes" "golden: long scenes" PROPERTIES LABELS golden TIMEOUT ${PATIENCE})
  set_tests_properties("long: longest scenes" PROPERTIES LABELS long TIMEOUT ${PATIENCE})
endif()

# A software driver with many threads in each of many processes takes up to twice the processor time, so tests run with
# one thread. The exceptions keep the usual number of threads, in order to detect races between workgroups: whole
# scenes, and the state of all simulations.
get_property(TESTS DIRECTORY PROPERTY TESTS)
list(REMOVE_ITEM TESTS "golden: a dozen scenes" "golden: shipped scenes" "long: state on the other memory path")
# These modules also keep their threads, because they interrupt a run midway, and with one thread small scenes would
# finish too early.
foreach(module bisect suite_runs checkpoint resume two_runs bake_sequence spread bench)
  list(REMOVE_ITEM TESTS "cli: ${module}")
endforeach()
set_property(TEST ${TESTS} APPEND PROPERTY ENVIRONMENT LP_NUM_THREADS=1)

# glibc uses huge pages: fewer page faults cut the processor time of a tiny scene's run by a fifth. Left out for tests
# that limit or count memory.
get_property(TESTS DIRECTORY PROPERTY TESTS)
list(FILTER TESTS INCLUDE REGEX "^(cli|gpu|golden|oracle): ")
list(REMOVE_ITEM TESTS "cli: failures" "cli: bake_sequence" "cli: terminal")
set_property(TEST ${TESTS} APPEND PROPERTY ENVIRONMENT GLIBC_TUNABLES=glibc.malloc.hugetlb=1)

# All tests share Mesa's shader cache, so tests that use the same shaders run after the test that compiles them.
if(TARGET simreel)
  set(OF_SCENES "golden: long scenes")
  if(Python3_FOUND)
    list(APPEND OF_SCENES "cli: storage_path" "cli: mutation" "cli: exact" "cli: guide")
  endif()
  set_tests_properties(${OF_SCENES} "long: longest scenes" PROPERTIES DEPENDS "golden: shipped scenes")
  set_tests_properties("golden: shipped scenes" PROPERTIES DEPENDS "golden: a dozen scenes")
endif()

# The longest tests start first, because otherwise one would run alone at the end. ctest uses these costs until it has
# measured its own.
set_tests_properties("long: state on the other memory path" PROPERTIES COST 60)
set_tests_properties(${GPU_PICTURES} PROPERTIES COST 50)
if(TARGET simreel)
  set_tests_properties("golden: shipped scenes" "golden: long scenes" PROPERTIES COST 100)
  if(Python3_FOUND)
    set_tests_properties("cli: storage_path" "cli: mutation" "cli: checkpoint" "cli: resume" "cli: guide" PROPERTIES COST 80)
  endif()
endif()
if(SYSTEM_PYTHON)
  set_tests_properties("browser: report" PROPERTIES COST 80)
endif()

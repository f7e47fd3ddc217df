include(GoogleTest)

# beadswim_library(NAME SOURCES file... [DEPENDS target...] [PRIVATE target...])
# Target Beadswim::NAME of the folder's src/ files, with its public headers under include/beadswim/NAME; installed, and
# found by find_package(Beadswim), but for those of the programs in tools/.
function(beadswim_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  add_library(beadswim_${name} STATIC ${arg_SOURCES})
  add_library(Beadswim::${name} ALIAS beadswim_${name})
  target_include_directories(beadswim_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
                                                     $<INSTALL_INTERFACE:include>)
  target_link_libraries(beadswim_${name} PUBLIC ${arg_DEPENDS} PRIVATE ${arg_PRIVATE})
  target_compile_features(beadswim_${name} PUBLIC cxx_std_20)
  string(FIND ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/libs/ place)
  if(place EQUAL 0)
    set_target_properties(beadswim_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS beadswim_${name} EXPORT BeadswimTargets ARCHIVE COMPONENT development)
    install(DIRECTORY include/ DESTINATION include COMPONENT development)
  endif()
endfunction()

# beadswim_kernels(TARGET SOURCE...): compiles files of kernels of a library or program once for each instruction set, with
# BEADSWIM_INSTRUCTION_SET naming the namespace; a function of the target chooses at run time. -fopenmp-simd lets
# loops be cut into lanes where the source says so; nothing of OpenMP runs. -Wno-psabi: vectors pass between functions
# that are always inlined, never through an ABI. Clang knows no `#pragma GCC ivdep`, and some of the names of processors.
function(beadswim_kernels target)
  set(sets baseline)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    list(APPEND sets x86_64_v3 x86_64_v4)
  endif()
  set(flags_of_x86_64_v3 -march=x86-64-v3)
  set(flags_of_x86_64_v4 -march=x86-64-v4 -mprefer-vector-width=512)
  foreach(set ${sets})
    set(kernels ${target}_kernels_${set})
    add_library(${kernels} OBJECT ${ARGN})
    target_include_directories(${kernels} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    target_compile_definitions(${kernels} PRIVATE BEADSWIM_INSTRUCTION_SET=${set})
    target_compile_options(${kernels} PRIVATE -O3 -fopenmp-simd -Wno-psabi
                           $<$<CXX_COMPILER_ID:Clang>:-Wno-unknown-pragmas;-Wno-pass-failed> ${flags_of_${set}})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
  endforeach()
endfunction()

# beadswim_program(NAME SOURCES file... DEPENDS target... [TESTED]): the executable beadswim-NAME. TESTED: all but its
# main.cpp is a library, beadswim_NAME_program, that tests link too.
function(beadswim_program name)
  cmake_parse_arguments(arg "TESTED" "" "SOURCES;DEPENDS" ${ARGN})
  if(arg_TESTED)
    list(REMOVE_ITEM arg_SOURCES main.cpp)
    set(library beadswim_${name}_program)
    add_library(${library} STATIC ${arg_SOURCES})
    target_include_directories(${library} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${library} PUBLIC ${arg_DEPENDS})
    set(arg_SOURCES main.cpp)
    set(arg_DEPENDS ${library})
  endif()
  add_executable(beadswim-${name} ${arg_SOURCES})
  target_link_libraries(beadswim-${name} PRIVATE ${arg_DEPENDS})
endfunction()

# Seconds that one test may take; the sanitizers slow it by some five times.
set(BEADSWIM_TEST_TIMEOUT 300)
if(BEADSWIM_SANITIZE)
  set(BEADSWIM_TEST_TIMEOUT 900)
endif()

# beadswim_test(NAME SOURCES file... DEPENDS target... LABELS label...): GoogleTest cases of one process.
function(beadswim_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} GTest::gtest_main GTest::gmock)
  gtest_discover_tests(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${BEADSWIM_TEST_TIMEOUT})
endfunction()

# What mpirun needs as root in a container and with more ranks than cores.
set(BEADSWIM_MPI_ENVIRONMENT
    "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMPI_MCA_rmaps_base_oversubscribe=1;OMPI_MCA_btl_vader_single_copy_mechanism=none;OMPI_MCA_hwloc_base_binding_policy=none;OMPI_MCA_mpi_yield_when_idle=1")

# beadswim_mpi_test(NAME RANKS n... SOURCES file... DEPENDS target... LABELS label...)
# One executable whose main starts MPI (tests/mpi_main.cpp), run as a whole on each rank count.
function(beadswim_mpi_test name)
  cmake_parse_arguments(arg "" "" "RANKS;SOURCES;DEPENDS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES} ${PROJECT_SOURCE_DIR}/tests/mpi_main.cpp)
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} MPI::MPI_C GTest::gtest GTest::gmock)
  foreach(ranks ${arg_RANKS})
    add_test(NAME ${name}.np${ranks}
             COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:${name}>)
    set_tests_properties(${name}.np${ranks} PROPERTIES PROCESSORS ${ranks} TIMEOUT ${BEADSWIM_TEST_TIMEOUT}
                         LABELS "mpi;${arg_LABELS}" ENVIRONMENT "${BEADSWIM_MPI_ENVIRONMENT}")
  endforeach()
endfunction()

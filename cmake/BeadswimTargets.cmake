include(GoogleTest)

# Two methods shorten the build. First, a small file spends most of its compile time on headers. Targets of one family
# therefore share a precompiled header (numerics: Eigen and the standard library; documents: also nlohmann-json and CLI11;
# tests: also GoogleTest). Second, each file would compile the templates and virtual classes of nlohmann-json, CLI11 and
# GoogleTest again. The files of a target of the last two families are therefore compiled together. With OFF every file is
# compiled separately, which is useful for work on single files and to find missing includes.
option(BEADSWIM_SHARED_HEADERS "Precompile shared headers, and compile the files of programs and tests together" ON)

# beadswim_header_family(NAME HEADERS header... DEPENDS target... [OPTIONS option...]): precompiles the headers that the
# targets of the family NAME share.
function(beadswim_header_family name)
  cmake_parse_arguments(arg "" "" "HEADERS;DEPENDS;OPTIONS" ${ARGN})
  if(NOT BEADSWIM_SHARED_HEADERS)
    return()
  endif()
  set(source ${CMAKE_BINARY_DIR}/headers_of_${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Its precompiled headers are shared by the family of ${name}.\n")
  add_library(beadswim_headers_of_${name} OBJECT ${source})
  target_link_libraries(beadswim_headers_of_${name} PRIVATE ${arg_DEPENDS})
  target_precompile_headers(beadswim_headers_of_${name} PRIVATE ${arg_HEADERS})
  target_compile_options(beadswim_headers_of_${name} PRIVATE ${arg_OPTIONS})
endfunction()

# Compiler options for documents and tests. With precompiled headers GCC 12 warns that "literal" + std::string copies 2^63 bytes, which is
# false (GCC bug 105651).
set(BEADSWIM_FALSE_WARNINGS_OFF -Wno-stringop-overflow -Wno-array-bounds)

# Templates and virtual classes of these headers compile faster at -O1. The speed of this code does not matter.
set(BEADSWIM_COLD_CODE $<$<NOT:$<CONFIG:Debug>>:-O1>)
set(BEADSWIM_OPTIONS_OF_tests ${BEADSWIM_COLD_CODE})
set(BEADSWIM_OPTIONS_OF_documents ${BEADSWIM_COLD_CODE})
if(BEADSWIM_SANITIZE AND NOT BEADSWIM_FUZZ)
  list(APPEND BEADSWIM_OPTIONS_OF_documents -O0)  # compiles in two thirds of the time
endif()
# For tests with loops over cells, also in builds whose other code is compiled at -O1.
set(BEADSWIM_HOT_CODE $<$<NOT:$<CONFIG:Debug>>:-O2>)

# beadswim_share_headers(TARGET numerics|documents|tests): lets a target use the precompiled header of a family.
function(beadswim_share_headers target family)
  if(NOT BEADSWIM_SHARED_HEADERS)
    return()
  endif()
  target_precompile_headers(${target} REUSE_FROM beadswim_headers_of_${family})
  if(NOT family STREQUAL numerics)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
    target_compile_options(${target} PRIVATE ${BEADSWIM_OPTIONS_OF_${family}} ${BEADSWIM_FALSE_WARNINGS_OFF})
  endif()
endfunction()

set(numerics_headers <algorithm> <array> <cmath> <complex> <functional> <map> <memory> <optional> <span> <string>
    <variant> <vector> <fmt/core.h> <Eigen/Dense>)
beadswim_header_family(numerics HEADERS ${numerics_headers} DEPENDS Eigen3::Eigen fmt::fmt)
beadswim_header_family(documents HEADERS ${numerics_headers} <nlohmann/json.hpp> <CLI/CLI.hpp>
  DEPENDS Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json CLI11::CLI11 OPTIONS ${BEADSWIM_OPTIONS_OF_documents})
if(BUILD_TESTING)
  beadswim_header_family(tests HEADERS ${numerics_headers} <random> <gtest/gtest.h> <gmock/gmock.h>
    DEPENDS Eigen3::Eigen fmt::fmt GTest::gtest GTest::gmock OPTIONS ${BEADSWIM_OPTIONS_OF_tests})
endif()

# beadswim_library(NAME SOURCES file... [DEPENDS target...] [PRIVATE target...] [HEADERS numerics|documents])
# Defines the library Beadswim::NAME. Its public headers are in include/beadswim/NAME. The libraries in libs/ are installed
# for find_package(Beadswim); the libraries in tools/ are not.
function(beadswim_library name)
  cmake_parse_arguments(arg "" "HEADERS" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  if(NOT arg_HEADERS)
    set(arg_HEADERS numerics)
  endif()
  add_library(beadswim_${name} STATIC ${arg_SOURCES})
  beadswim_share_headers(beadswim_${name} ${arg_HEADERS})
  add_library(Beadswim::${name} ALIAS beadswim_${name})
  target_include_directories(beadswim_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
                                                     $<INSTALL_INTERFACE:include>)
  target_link_libraries(beadswim_${name} PUBLIC ${arg_DEPENDS} PRIVATE ${arg_PRIVATE})
  target_compile_features(beadswim_${name} PUBLIC cxx_std_20)
  string(FIND ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/libs/ position)
  if(position EQUAL 0)
    set_target_properties(beadswim_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS beadswim_${name} EXPORT BeadswimTargets ARCHIVE COMPONENT development)
    install(DIRECTORY include/ DESTINATION include COMPONENT development)
  endif()
endfunction()

# beadswim_kernels(TARGET SOURCE...): compiles the kernels of a library or program once per instruction set. The namespace of
# the kernels is BEADSWIM_INSTRUCTION_SET. A function of the target chooses the instruction set at run time.
# -fopenmp-simd enables `#pragma omp simd`; the OpenMP runtime is not used.
# -Wno-psabi: vectors are passed only between inlined functions, so the calling convention for vectors does not matter.
# Clang does not know `#pragma GCC ivdep` and some of the processor names; with Clang only the baseline is compiled. So it is
# with the sanitizers: the kernels access the same memory with every instruction set, and take a minute each to compile.
set(BEADSWIM_INSTRUCTION_SETS baseline)
set(BEADSWIM_KERNEL_OPTIMISATION -O3)
if(BEADSWIM_SANITIZE)
  set(BEADSWIM_KERNEL_OPTIMISATION -O2)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  list(APPEND BEADSWIM_INSTRUCTION_SETS x86_64_v3 x86_64_v4)
endif()
function(beadswim_kernels target)
  set(flags_of_x86_64_v3 -march=x86-64-v3)
  set(flags_of_x86_64_v4 -march=x86-64-v4 -mprefer-vector-width=512)
  if(x86_64_v4 IN_LIST BEADSWIM_INSTRUCTION_SETS)
    target_compile_definitions(${target} PRIVATE BEADSWIM_ALL_INSTRUCTION_SETS) # core/kernel.hpp
  endif()
  foreach(set ${BEADSWIM_INSTRUCTION_SETS})
    set(kernels ${target}_kernels_${set})
    add_library(${kernels} OBJECT ${ARGN})
    target_include_directories(${kernels} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    target_compile_definitions(${kernels} PRIVATE BEADSWIM_INSTRUCTION_SET=${set})
    target_compile_options(${kernels} PRIVATE ${BEADSWIM_KERNEL_OPTIMISATION} -fopenmp-simd -Wno-psabi
                           $<$<CXX_COMPILER_ID:Clang>:-Wno-unknown-pragmas;-Wno-pass-failed> ${flags_of_${set}})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
  endforeach()
endfunction()

# Keeps the plug-ins of MPI loaded in the executable, for reports of the leak sanitizer (tests/sanitizers/keep_libraries.cpp).
function(beadswim_keep_libraries target)
  if(BEADSWIM_SANITIZE)
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests/sanitizers/keep_libraries.cpp)
    target_link_options(${target} PRIVATE LINKER:--export-dynamic-symbol=dlclose)
  endif()
endfunction()

# beadswim_program(NAME SOURCES file... DEPENDS target... [TESTED]): defines the executable beadswim-NAME. With TESTED all
# sources except main.cpp form the library beadswim_NAME_program, so that tests can link it.
function(beadswim_program name)
  cmake_parse_arguments(arg "TESTED" "" "SOURCES;DEPENDS" ${ARGN})
  if(arg_TESTED)
    list(REMOVE_ITEM arg_SOURCES main.cpp)
    set(library beadswim_${name}_program)
    add_library(${library} STATIC ${arg_SOURCES})
    target_include_directories(${library} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${library} PUBLIC ${arg_DEPENDS})
    beadswim_share_headers(${library} documents)
    set(arg_SOURCES main.cpp)
    set(arg_DEPENDS ${library})
  endif()
  add_executable(beadswim-${name} ${arg_SOURCES})
  target_link_libraries(beadswim-${name} PRIVATE ${arg_DEPENDS})
  beadswim_keep_libraries(beadswim-${name})
  beadswim_share_headers(beadswim-${name} documents)
endfunction()

# Time limits of one test [s]: in general, and if it is labelled slow. The sanitizers slow a test by a factor of about five.
set(BEADSWIM_TEST_TIMEOUT 300)
set(BEADSWIM_SLOW_TEST_TIMEOUT 1200)
if(BEADSWIM_SANITIZE)
  set(BEADSWIM_TEST_TIMEOUT 900)
endif()

# read_variables(RESULT FILE [PATTERN]): sets RESULT to the list of the lines NAME=VALUE of FILE whose names begin with PATTERN.
function(read_variables result file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} variables REGEX "^${ARGN}[A-Z]")
  set(${result} "${variables}" PARENT_SCOPE)
endfunction()
read_variables(BEADSWIM_MPI_ENVIRONMENT ${PROJECT_SOURCE_DIR}/tests/mpi.env)
read_variables(BEADSWIM_MPI_SANITIZER_ENVIRONMENT ${PROJECT_SOURCE_DIR}/tests/sanitizers/sanitizers.env)
# Tests without MPI do not need LSAN_OPTIONS.
read_variables(BEADSWIM_SANITIZER_ENVIRONMENT ${PROJECT_SOURCE_DIR}/tests/sanitizers/sanitizers.env "(ASAN|UBSAN)_")

# Builds all executables of the tests labelled `unit`.
add_custom_target(unit_tests)

# beadswim_test(NAME SOURCES file... DEPENDS target... LABELS label... [SEPARATE]): defines a GoogleTest executable without MPI.
# ctest runs each test case in its own process. With the sanitizers a process takes longer to start than most cases take to
# run; ctest then runs all cases in one process. SEPARATE compiles each file separately, for files that define constants with
# equal names.
function(beadswim_test name)
  cmake_parse_arguments(arg "SEPARATE" "" "SOURCES;DEPENDS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} GTest::gtest_main GTest::gmock)
  beadswim_share_headers(${name} tests)
  if(arg_SEPARATE)
    set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  endif()
  if(BEADSWIM_SANITIZE)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${BEADSWIM_TEST_TIMEOUT}
                         ENVIRONMENT "${BEADSWIM_SANITIZER_ENVIRONMENT}")
  else()
    gtest_discover_tests(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${BEADSWIM_TEST_TIMEOUT})
  endif()
  if(unit IN_LIST arg_LABELS)
    add_dependencies(unit_tests ${name})
  endif()
endfunction()

# beadswim_mpi_test(NAME RANKS n... SOURCES file... DEPENDS target... LABELS label... [OPTIMISED])
# Defines a GoogleTest executable whose main starts MPI (tests/mpi_main.cpp). ctest runs all its cases together, once for each
# number of ranks. A test labelled `unit` runs on 3 ranks only with the sanitizers; if it is not defined for 3, it runs on 1 with
# them. OPTIMISED: for tests with loops over cells, which take four times as long at -O1.
function(beadswim_mpi_test name)
  cmake_parse_arguments(arg "OPTIMISED" "" "RANKS;SOURCES;DEPENDS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES} ${PROJECT_SOURCE_DIR}/tests/mpi_main.cpp)
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} MPI::MPI_C GTest::gtest GTest::gmock)
  beadswim_keep_libraries(${name})
  if(arg_OPTIMISED)
    beadswim_share_headers(${name} numerics)
    target_compile_options(${name} PRIVATE ${BEADSWIM_HOT_CODE} ${BEADSWIM_FALSE_WARNINGS_OFF})
  else()
    beadswim_share_headers(${name} tests)
  endif()
  if(BEADSWIM_SANITIZE)
    list(FILTER arg_RANKS INCLUDE REGEX "[13]")
    list(POP_BACK arg_RANKS arg_RANKS)
  elseif(unit IN_LIST arg_LABELS)
    list(REMOVE_ITEM arg_RANKS 3)
  endif()
  foreach(ranks ${arg_RANKS})
    add_test(NAME ${name}.np${ranks}
             COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:${name}>)
    set_tests_properties(${name}.np${ranks} PROPERTIES PROCESSORS ${ranks} TIMEOUT ${BEADSWIM_TEST_TIMEOUT}
                         LABELS "mpi;${arg_LABELS}"
                         ENVIRONMENT "${BEADSWIM_MPI_ENVIRONMENT};${BEADSWIM_MPI_SANITIZER_ENVIRONMENT}")
  endforeach()
  if(unit IN_LIST arg_LABELS)
    add_dependencies(unit_tests ${name})
  endif()
endfunction()

include(GoogleTest)

# beadswim_library(NAME SOURCES file... [DEPENDS target...] [PRIVATE target...])
# Target Beadswim::NAME of the folder's src/ files, with its public headers under include/beadswim/NAME.
function(beadswim_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  add_library(beadswim_${name} STATIC ${arg_SOURCES})
  add_library(Beadswim::${name} ALIAS beadswim_${name})
  target_include_directories(beadswim_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/include)
  target_link_libraries(beadswim_${name} PUBLIC ${arg_DEPENDS} PRIVATE ${arg_PRIVATE})
endfunction()

# beadswim_program(NAME SOURCES file... DEPENDS target...): the executable beadswim-NAME.
function(beadswim_program name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(beadswim-${name} ${arg_SOURCES})
  target_link_libraries(beadswim-${name} PRIVATE ${arg_DEPENDS})
endfunction()

# beadswim_test(NAME SOURCES file... DEPENDS target... LABELS label...): GoogleTest cases of one process.
function(beadswim_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} GTest::gtest_main GTest::gmock)
  gtest_discover_tests(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT 300)
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
    set_tests_properties(${name}.np${ranks} PROPERTIES PROCESSORS ${ranks} TIMEOUT 300
                         LABELS "mpi;${arg_LABELS}" ENVIRONMENT "${BEADSWIM_MPI_ENVIRONMENT}")
  endforeach()
endfunction()

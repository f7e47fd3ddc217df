# find_package(Beadswim) reads this file. It defines the libraries as targets Beadswim::theory, Beadswim::mobility,
# Beadswim::coupling and others (docs/architecture.md).
include(CMakeFindDependencyMacro)
include(${CMAKE_CURRENT_LIST_DIR}/BeadswimDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/BeadswimTargets.cmake)

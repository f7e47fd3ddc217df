# find_package(Beadswim) defines the libraries as targets Beadswim::theory, Beadswim::mobility, Beadswim::coupling ... (docs/architecture.md).
include(CMakeFindDependencyMacro)
include(${CMAKE_CURRENT_LIST_DIR}/BeadswimDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/BeadswimTargets.cmake)

# Finds the external libraries that Beadswim needs, both when Beadswim is built and when another project calls
# find_package(Beadswim).
find_package(MPI REQUIRED COMPONENTS C)
add_compile_definitions(OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)  # Beadswim uses only the C interface of MPI

set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 1.10.7 REQUIRED COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "Beadswim needs parallel HDF5; on Debian: apt install libhdf5-openmpi-dev")
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(CLI11 2.1 REQUIRED CONFIG)
find_package(nlohmann_json 3.11 REQUIRED CONFIG)
find_package(valijson REQUIRED CONFIG)
find_package(fmt 9 REQUIRED CONFIG)
find_package(Boost 1.74 REQUIRED)  # headers only: Boost.Math, Boost.Preprocessor
find_package(PkgConfig REQUIRED)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3)
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)

option(BEADSWIM_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
option(BEADSWIM_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
option(BEADSWIM_FUZZ "Build the fuzz targets for libFuzzer (clang), with the sanitizers" OFF)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
# Release builds compile at -O2. The kernels alone are compiled at -O3 (beadswim_kernels).
string(REPLACE "-O3" "-O2" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

# -ffp-contract=off: the compiler may not fuse multiplications and additions. The results then have the same bits in the
# vectorised body and in the remainder of a loop, and with every instruction set.
# -Wno-restrict: GCC 12 warns of an overlap in every "literal" + std::string, which is false (GCC bug 105651).
add_compile_options(-Wall -Wextra -Wno-restrict -ffp-contract=off -fno-math-errno)
if(BEADSWIM_WARNINGS_AS_ERRORS)
  add_compile_options(-Werror)
endif()
if(BEADSWIM_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
  set(BEADSWIM_SANITIZE ON)
endif()
if(BEADSWIM_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  # These checks take more than a third of the compile time. The address sanitizer reports null pointers, freed objects and
  # access beyond objects too.
  add_compile_options(-fno-sanitize=null,alignment,vptr,pointer-overflow,object-size)
  add_compile_options(-Wno-maybe-uninitialized -Wno-unknown-warning-option)  # false warnings of GCC 12 in std::regex under sanitizers
  add_link_options(-fsanitize=address,undefined)
endif()

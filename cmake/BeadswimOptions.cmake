option(BEADSWIM_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
option(BEADSWIM_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
option(BEADSWIM_FUZZ "Build the fuzz targets for libFuzzer (clang), with the sanitizers" OFF)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

# No fused multiply-add by the compiler's choice: the same source gives the same bits in the vector
# body and in the remainder of a loop, and on every instruction set.
# -Wno-restrict: GCC 12 sees an overlap in every "literal" + std::string (GCC bug 105651).
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
  add_compile_options(-Wno-maybe-uninitialized -Wno-unknown-warning-option)  # GCC 12 warns falsely of std::regex under sanitizers
  add_link_options(-fsanitize=address,undefined)
endif()

#!/usr/bin/env python3
"""Checks that the Spack recipe can be loaded (with substitutes for Spack's functions) and depends on all packages that CMake looks for.

    spack_recipe.py SOURCE-FOLDER
"""

import pathlib
import re
import runpy
import sys
import types

# Names of packages in Spack, by their names in CMake.
PACKAGES = {
    "MPI": "mpi", "HDF5": "hdf5", "Eigen3": "eigen", "CLI11": "cli11", "nlohmann_json": "nlohmann-json", "valijson": "valijson",
    "fmt": "fmt", "PkgConfig": "pkgconfig", "OpenSSL": "openssl", "GTest": "googletest",
    "SUNDIALS": "sundials", "FFTW": "fftw", "Boost": "boost", "NLOPT": "nlopt",
}


def recipe(path):
    """Returns the class of the recipe and the arguments of its directives."""
    said = []
    spack = types.ModuleType("spack.package")
    for word in ["license", "version", "variant", "depends_on", "generator", "conflicts"]:
        setattr(spack, word, lambda *words, word=word, **_: said.append((word, words[0])))
    spack.CMakePackage = type("CMakePackage", (), {"define_from_variant": lambda _, name, variant: f"-D{name}={variant}"})
    sys.modules |= {"spack": types.ModuleType("spack"), "spack.package": spack}
    return runpy.run_path(str(path))["Beadswim"], said


def main():
    root = pathlib.Path(sys.argv[1])
    package, said = recipe(root / "packaging/spack/package.py")
    needed = {re.split(r"[@+% ]", spec)[0] for word, spec in said if word == "depends_on"}
    cmake = (root / "CMakeLists.txt").read_text() + (root / "cmake/BeadswimDependencies.cmake").read_text()
    cmake = re.sub(r"#.*", "", cmake)
    looked_for = set(re.findall(r"find_package\((\w+)", cmake)) | set(re.findall(r"pkg_check_modules\((\w+)", cmake))
    release = re.search(r"project\(Beadswim VERSION ([\d.]+)", cmake).group(1)
    faults = [f"lacks what is {name} to CMake" for name in sorted(looked_for) if PACKAGES.get(name) not in needed]
    if ("version", release) not in said:
        faults.append(f"lacks the version {release}")
    if package().cmake_args() != ["-DBUILD_TESTING=tests"]:
        faults.append("says something else to CMake than whether to build tests")
    print("\n".join([f"packaging/spack/package.py: {fault}" for fault in faults] + [f"{len(needed)} dependencies, {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

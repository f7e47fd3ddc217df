# SPDX-License-Identifier: GPL-3.0-or-later
"""Spack recipe that builds Beadswim from a source tree:

    spack repo create beadswim-repo && mkdir -p beadswim-repo/packages/beadswim
    cp packaging/spack/package.py beadswim-repo/packages/beadswim/ && spack repo add beadswim-repo
    spack dev-build beadswim@0.1.0             # in the source folder
"""

from spack.package import *


class Beadswim(CMakePackage):
    """Force-driven bead-spring microswimmers: layouts, resolved and mobility runs, theory, comparison."""

    license("GPL-3.0-or-later")

    version("0.1.0")

    variant("tests", default=False, description="Build the tests")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")

    depends_on("mpi@3:")
    depends_on("hdf5@1.10.7:+mpi")
    depends_on("fftw@3.3: precision=double")
    depends_on("openssl")
    depends_on("fmt@9:")
    depends_on("eigen@3.4:")
    depends_on("boost@1.74:+math")
    depends_on("nlopt")
    depends_on("cli11@2.1:")
    depends_on("nlohmann-json@3.11:")
    depends_on("valijson")

    depends_on("googletest+gmock", when="+tests")
    depends_on("sundials@6.4:", when="+tests")

    generator("ninja")

    conflicts("%gcc@:11", msg="Beadswim is C++20: GCC 12 or Clang 14")

    def cmake_args(self):
        return [self.define_from_variant("BUILD_TESTING", "tests")]

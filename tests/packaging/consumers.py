"""Builds and runs user programs against weft in every way it can be taken in, outside of the tree.

usage: consumers.py SOURCE STATIC_BUILD SHARED_BUILD
The two builds are installed, moved, and found again by CMake and pkg-config; SHARED_BUILD is also
packed as Debian packages. Prints a line per way; the hashes of all of them must be equal.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
FLAGS = ["-fno-exceptions", "-fno-rtti", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion",
         "-Werror", "-O1"]
COMPILERS = [name for name in ("g++", "clang++") if shutil.which(name)]


class Failure(Exception):
    pass


def run(*command, env=None, cwd=None):
    """The standard output of a command that must succeed."""
    settings = dict(os.environ, OMP_WAIT_POLICY="passive", **(env or {}))
    done = subprocess.run(command, env=settings, cwd=cwd, capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        raise Failure(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def one(root, name):
    """The only file or folder of that name below root."""
    found = [os.path.join(folder, name) for folder, folders, files in os.walk(root)
             if name in folders + files]
    if len(found) != 1:
        raise Failure(f"{name}: found {len(found)} times below {root}")
    return found[0]


class Ways:
    def __init__(self, source, static_build, shared_build, work):
        self.source, self.work = source, work
        self.hashes = {}
        self.prefix = {"static": self.install(static_build, "static"),
                       "shared": self.install(shared_build, "shared")}
        self.shared_build = shared_build

    def folder(self, name):
        path = os.path.join(self.work, name.replace(" ", "_").replace("+", "x"))
        os.makedirs(path)
        return path

    def install(self, build, kind):
        """Installed in one place and moved to another: nothing may remember the first."""
        first, then = (os.path.join(self.work, f"{kind}_{place}") for place in ("made", "moved"))
        run("cmake", "--install", build, "--prefix", first)
        os.rename(first, then)
        return then

    def took(self, name, output):
        self.hashes[name] = output.split()[-1]
        print(f"{name}: {self.hashes[name]}", flush=True)

    def library_path(self, kind, root=None):
        if kind == "static":
            return {}
        return {"LD_LIBRARY_PATH": os.path.dirname(one(root or self.prefix["shared"],
                                                       "libweft.so.0"))}

    # The ways.

    def cmake(self, name, kind, compiler, standard, *options):
        folder = self.folder(name)
        shutil.copy(os.path.join(HERE, "consumer.cpp"), folder)
        shutil.copy(os.path.join(HERE, "CMakeLists.consumer.txt"),
                    os.path.join(folder, "CMakeLists.txt"))
        flags = " ".join(FLAGS) if kind else "-O1"
        run("cmake", "-S", folder, "-B", folder + "/build", "-G", "Ninja",
            f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_STANDARD={standard}",
            f"-DCMAKE_CXX_FLAGS={flags}", *options)
        run("cmake", "--build", folder + "/build", "--parallel", str(os.cpu_count()))
        # A build tree finds the shared library by itself.
        self.took(name, run(folder + "/build/consumer"))

    def find_package(self, kind, compiler, standard):
        self.cmake(f"find_package {kind} {compiler} {standard}", kind, compiler, standard,
                   f"-DCMAKE_PREFIX_PATH={self.prefix[kind]}", f"-DWEFT_KIND={kind}")

    def add_subdirectory(self):
        self.cmake("add_subdirectory", "", "g++", 17, f"-DWEFT_SOURCE={self.source}",
                   "-DWEFT_ISA_LEVELS=v2", "-DCMAKE_UNITY_BUILD=ON")

    def pkg_config(self, kind, *options, root=None):
        path = os.path.dirname(one(root or self.prefix[kind], "weft.pc"))
        extra = ["--static"] if kind == "static" else []
        return run("pkg-config", *options, *extra, "weft", env={"PKG_CONFIG_PATH": path}).split()

    def by_pkg_config(self, kind, compiler, standard, root=None, name=None):
        name = name or f"pkg-config {kind} {compiler} {standard}"
        program = self.folder(name) + "/consumer"
        run(compiler, f"-std=c++{standard}", *FLAGS, os.path.join(HERE, "consumer.cpp"),
            *self.pkg_config(kind, "--cflags", "--libs", root=root), "-o", program)
        self.took(name, run(program, env=self.library_path(kind, root)))

    def c_program(self, kind):
        header = os.path.join(self.prefix[kind], "include/weft/weft.h")
        if not os.path.exists(header):
            print(f"C {kind}: skipped (this version has no weft.h)")
            return
        program = self.folder(f"C {kind}") + "/consumer"
        # The linker needs C++'s runtime of a static library, which weft.pc names.
        run("gcc", "-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror",
            os.path.join(HERE, "consumer.c"), *self.pkg_config(kind, "--cflags", "--libs"),
            "-o", program)
        self.took(f"C {kind}", run(program, env=self.library_path(kind)))

    def plugins(self):
        folder = self.folder("two plug-ins")
        paths = []
        for number in (1, 2):
            paths.append(f"{folder}/plugin{number}.so")
            run("g++", "-std=c++17", *FLAGS, "-DWEFT_PLUGIN", "-shared", "-fPIC",
                os.path.join(HERE, "consumer.cpp"),
                *self.pkg_config("static", "--cflags", "--libs"), "-o", paths[-1])
            exported = [line for line in run("nm", "-DC", "--defined-only", paths[-1]).splitlines()
                        if "weft" in line]
            if exported:
                raise Failure(f"{paths[-1]} shows weft to other plug-ins:\n" + "\n".join(exported))
        run("g++", "-std=c++17", *FLAGS, os.path.join(HERE, "plugin_host.cpp"), "-ldl", "-o",
            folder + "/host")
        for number, line in enumerate(run(folder + "/host", *paths).split(), 1):
            self.took(f"plug-in {number} of 2", line)

    def symbols(self):
        library = one(self.prefix["shared"], "libweft.so.0")
        if "[libweft.so.0]" not in run("readelf", "-d", library):
            raise Failure("the SONAME is not libweft.so.0")
        names = [line.split(maxsplit=2)[2] for line in
                 run("nm", "-DC", "--with-symbol-versions", "--defined-only", library).splitlines()]
        own = re.compile(r"^(vtable for |typeinfo (name )?for |guard variable for )?"
                         r"(weft::v0::|weft_\w+@@WEFT_0$).*|^WEFT_0(@@WEFT_0)?$")
        others = [name for name in names if not own.match(name)]
        if others or len(names) < 20:
            raise Failure("libweft.so shows more than the interface:\n" + "\n".join(others))
        bare = [name for name in names if not name.endswith("@@WEFT_0")]
        if [name for name in bare if name != "WEFT_0"]:
            raise Failure("symbols without a version: " + ", ".join(bare))
        print(f"exported symbols: {len(names)}, all of weft::v0 or weft_*, version WEFT_0")

    def debian(self):
        folder = self.folder("debian")
        run("cpack", "--config", self.shared_build + "/CPackConfig.cmake", "-B", folder)
        packages = [name for name in os.listdir(folder) if name.endswith(".deb")]
        names = sorted(name.split("_")[0] for name in packages)
        if names != ["libweft-dev", "libweft0", "weft-tools"]:
            raise Failure(f"packages: {names}")
        root = folder + "/root"
        for package in packages:
            run("dpkg-deb", "-x", os.path.join(folder, package), root)
            fields = run("dpkg-deb", "-f", os.path.join(folder, package))
            needed = {"libweft0": "libgomp1", "libweft-dev": "libweft0 (=",
                      "weft-tools": "libweft0 (="}[package.split("_")[0]]
            if needed not in fields:
                raise Failure(f"{package} does not depend on {needed}\n{fields}")
        self.by_pkg_config("shared", "g++", 17, root=root, name="Debian packages")
        version = run(root + "/usr/bin/weft", "--version", env=self.library_path("shared", root))
        print(f"weft-tools: {version.strip()}")
        if shutil.which("lintian"):
            done = subprocess.run(["lintian", "--no-tag-display-limit", "--fail-on", "error",
                                   *(os.path.join(folder, name) for name in packages)],
                                  capture_output=True, text=True, check=False)
            print(done.stdout.strip() or "lintian: nothing to say")
            if done.returncode != 0:
                raise Failure("lintian found errors")


def main(source, static_build, shared_build):
    with tempfile.TemporaryDirectory() as work:
        ways = Ways(*map(os.path.abspath, (source, static_build, shared_build)), work)
        ways.symbols()
        for compiler in COMPILERS:
            for kind in ("shared", "static"):
                ways.by_pkg_config(kind, compiler, 17)
                ways.by_pkg_config(kind, compiler, 20)
            ways.find_package("shared", compiler, 17)
            ways.find_package("static", compiler, 20)
        for kind in ("shared", "static"):
            ways.c_program(kind)
        ways.plugins()
        if shutil.which("dpkg-shlibdeps"):
            ways.debian()
        else:
            print("Debian packages: skipped (dpkg-shlibdeps is missing; apt-get install dpkg-dev)")
        ways.add_subdirectory()
        if len(set(ways.hashes.values())) != 1:
            raise Failure(f"different hashes: {ways.hashes}")
        print(f"{len(ways.hashes)} ways, one hash")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except Failure as failure:
        sys.exit(f"packaging: {failure}")

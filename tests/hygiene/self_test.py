"""Shows that every hygiene check fails when its rule is broken.

usage: self_test.py CXX NM OBJDUMP
"""

import os
import subprocess
import sys
import tempfile
import unittest

import cpu_library
import isa_symbols
import layers
import links
import no_spills
import public_headers
import style
import variants
import vectorised

CXX, NM, OBJDUMP = sys.argv[1:4]


class Project(unittest.TestCase):
    """A throw-away project folder for each test."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name

    def write(self, path, text):
        full = os.path.join(self.root, path)
        os.makedirs(os.path.dirname(full), exist_ok=True)
        with open(full, "w", encoding="utf-8") as file:
            file.write(text)
        return full

    def compile(self, path, text, *flags):
        source = self.write(path, text)
        subprocess.run([CXX, "-std=c++17", *flags, "-c", source, "-o", source + ".o"], check=True)
        return source + ".o"

    def assert_problem(self, problems, text):
        self.assertTrue(any(text in problem for problem in problems), f"{text!r} not in {problems}")


class Layers(Project):
    def problems(self, **files):
        self.write("include/weft/core.hpp", "#include <cstdint>\n")
        self.write("src/base/vec3.h", '#include "base/view.h"\n#include "weft/core.hpp"\n')
        self.write("src/base/view.h", "// __CUDACC__ in a comment names nothing\n")
        self.write("src/kernels/spring.h", '#include "base/vec3.h"\n#include <cmath>\n')
        self.write("src/scene/order.cpp", '#include "base/vec3.h"\n#include <vector>\n')
        self.write("src/step/backend.h", '#include "base/view.h"\n')
        self.write("src/plan/plan.h", '#include "scene/order.h"\n#include "base/view.h"\n')
        self.write("src/scene/order.h", "#include <vector>\n#include <Eigen/Core>\n")
        for path, text in files.items():
            self.write(path, text)
        return layers.check(self.root).problems

    def test_accepts_what_the_layers_allow(self):
        self.assertEqual(self.problems(**{
            "src/api/world/world.cpp": '#include "step/backend.h"\n#include "plan/plan.h"\n',
            "tools/run.cpp": '#include "io/obj.h"\n#include "weft/core.hpp"\n',
            "src/io/obj.h": '#include "weft/core.hpp"\n#include <string>\n',
            "tests/unit/a.cpp": '#include "scene/order.h"\n#include "kernels/spring.h"\n'}), [])

    def test_refuses_wrong_layers(self):
        for path, include in [
                ("src/base/a.h", "kernels/spring.h"), ("src/state/a.h", "scene/order.h"),
                ("src/kernels/a.h", "plan/plan.h"), ("src/scene/a.h", "plan/plan.h"),
                ("src/plan/a.h", "step/backend.h"), ("src/step/a.h", "scene/order.h"),
                ("src/omp/a.cpp", "api/world/a.h"), ("src/cuda/a.cuh", "omp/exec.h"),
                ("src/api/world/a.cpp", "step/pipeline.h"),
                ("src/api/arena/b.cpp", "kernels/spring.h"),
                ("src/api/records/a.cpp", "api/world/a.h"), ("src/api/c/a.cpp", "api/world/a.h"),
                ("src/io/a.cpp", "base/vec3.h"), ("tools/a.cpp", "plan/plan.h"),
                ("samples/hello/a.cpp", "base/vec3.h"), ("include/weft/a.hpp", "base/vec3.h")]:
            with self.subTest(f"{path} includes {include}"):
                self.setUp()
                found = self.problems(**{
                    "src/api/world/a.h": "", "src/omp/exec.h": "", "src/step/pipeline.h": "",
                    path: f'#include "{include}"\n'})
                self.assert_problem(found, "must not include")

    def test_lets_one_file_alone_enter_what_exists_to_be_measured(self):
        sums = {"src/kernels/measured/sums.h": '#include "kernels/spring.h"\n'}
        include = '#include "kernels/measured/sums.h"\n'
        self.assertEqual(self.problems(**sums, **{"src/step/measured.h": include}), [])
        for path in "src/step/pipeline.h", "src/kernels/advance.h":
            found = self.problems(**sums, **{path: include})
            self.assert_problem(found, "only src/step/measured.h may include src/kernels/measured")

    def test_refuses_an_unknown_folder(self):
        self.assert_problem(self.problems(**{"src/gadgets/a.h": ""}), "is not a layer")

    def test_refuses_cycles(self):
        found = self.problems(**{"src/base/a.h": '#include "base/b.h"\n',
                                 "src/base/b.h": '#include "base/a.h"\n'})
        self.assert_problem(found, "file include cycle")
        self.setUp()
        found = self.problems(**{"tools/a.h": '#include "bench/b.h"\n', "bench/c.h": "",
                                 "bench/b.h": '#include "tools/d.h"\n', "tools/d.h": ""})
        self.assert_problem(found, "folder include cycle")

    def test_refuses_wrong_spelling(self):
        self.assert_problem(self.problems(**{"src/base/a.h": '#include "vec3.h"\n'}), "written")
        self.assert_problem(self.problems(**{"src/base/a.h": '#include <base/vec3.h>\n'}), "quotes")
        self.assert_problem(self.problems(**{"src/base/a.h": '#include "vector"\n'}), "not a file")

    def test_refuses_compiler_macros_and_branches(self):
        found = self.problems(**{"src/omp/exec.h": "#ifdef __CUDACC__\n#endif\n"})
        self.assert_problem(found, "may name __CUDACC__")
        found = self.problems(**{"src/kernels/a.h": "#if 1\n#endif\n"})
        self.assert_problem(found, "one text")
        self.assert_problem(self.problems(**{"src/omp/sort.cu": ""}), "live in src/cuda")

    def test_refuses_headers_of_others_in_the_wrong_place(self):
        for path, include in [("src/base/a.h", "vector"), ("src/kernels/a.h", "algorithm"),
                              ("src/step/a.h", "thrust/sort.h"), ("src/omp/memory.h", "string"),
                              ("src/state/a.h", "iostream"), ("src/omp/exec.h", "Eigen/Core")]:
            with self.subTest(f"{path} includes {include}"):
                self.setUp()
                found = self.problems(**{path: f"#include <{include}>\n"})
                self.assert_problem(found, "seen by an ISA object")
        found = self.problems(**{"src/omp/backend.cpp": '#include "scene/order.h"\n'})
        self.assert_problem(found, "src/scene/order.h:1: <vector> is seen by an ISA object")
        found = self.problems(**{"src/api/context/a.cpp": "#include <cuda_runtime.h>\n"})
        self.assert_problem(found, "belongs in src/cuda/")


class Style(Project):
    def test_refuses_each_fault(self):
        for text, fault in [("x" * 101 + "\n", "columns"), ("\tint x;\n", "tab"),
                            ("// TO" "DO: later\n", "unfinished"), ("int x;\n" * 401, "split"),
                            ("int x;\n" * 301, "one file in ten")]:
            with self.subTest(fault):
                self.write("src/a.cpp", text)
                self.assert_problem(style.check(self.root)[0], fault)

    def test_accepts_the_limits(self):
        self.write("src/a.cpp", ("x" * 100 + "\n") * 300)
        self.assertEqual(style.check(self.root)[0], [])


class PublicHeaders(Project):
    def test_refuses_each_fault(self):
        for text, fault in [("inline std::size_t f() { return 0; }\n", "size_t"),
                            ("inline void f() { throw 1; }\n", "exception"),
                            ("inline int f(long x) { return x; }\n", "conversion"),
                            ("inline int twice() { return 0; }\n", "redefinition"),
                            ("template <class T> requires true\nvoid f(T);\n", "requires")]:
            with self.subTest(fault):
                self.write("weft/a.hpp", text)
                self.assert_problem(public_headers.check(self.root, [CXX])[0], fault)

    def test_accepts_a_good_header_and_refuses_an_empty_folder(self):
        self.assert_problem(public_headers.check(self.root, [CXX])[0], "no header")
        self.write("weft/a.hpp", "#pragma once\n#include <cstddef>\ninline std::size_t f();\n")
        self.assertEqual(public_headers.check(self.root, [CXX])[0], [])


class IsaSymbols(Project):
    ENTRY = "namespace weft { void* backend_omp_v4() { return nullptr; } }\n"
    GOOD = ENTRY + """namespace weft { namespace omp_v4 {
        struct Shape { virtual ~Shape(); virtual int area() { return 1; } };
        Shape::~Shape() {}
        template <class T> T twice(T x) { static int calls = 0; return ++calls, x + x; }
        template float twice(float); } }\n"""

    def test_accepts_members_their_typeinfo_and_statics(self):
        good = self.compile("good.cpp", self.GOOD)
        self.assertEqual(isa_symbols.check(NM, "omp_v4", [good])[0], [])

    def test_refuses_what_the_linker_could_share(self):
        for text, fault in [
                ("namespace weft { float free_function(float x) { return x; } }", "free_function"),
                ("namespace weft { struct Leak { virtual float area() { return 1; } };"
                 "float use(Leak* l) { Leak x; return l->area() + x.area(); } }", "Leak::area"),
                ("namespace weft { namespace omp_v4 { struct V {}; } template <class T> T f() {"
                 "return T(); } template omp_v4::V f(); }", "omp_v4::V weft::f"),
                ("#include <algorithm>\nusing F = const int& (*)(const int&, const int&);"
                 "F leak = std::max<int>;", "std::max"),
                ("int global;", "global")]:
            with self.subTest(fault):
                leak = self.compile("leak.cpp", self.ENTRY + text)
                self.assert_problem(isa_symbols.check(NM, "omp_v4", [leak])[0], fault)

    def test_refuses_an_object_of_another_level(self):
        good = self.compile("good.cpp", self.GOOD)
        self.assert_problem(isa_symbols.check(NM, "omp_v3", [good])[0], "outside weft::omp_v3")
        self.assert_problem(isa_symbols.check(NM, "omp_v3", [good])[0], "is missing")


class CpuLibrary(Project):
    def test_refuses_what_needs_a_gpu_runtime(self):
        good = self.compile("good.cpp", "void free_memory(); void f() { free_memory(); }")
        self.assertEqual(cpu_library.check(NM, good)[0], [])
        bad = self.compile("bad.cpp", 'extern "C" int cudaFree(void*); int f() {'
                                      "return cudaFree(nullptr); }")
        self.assert_problem(cpu_library.check(NM, bad)[0], "cudaFree")


class Vectorised(Project):
    FLAGS = ["-O3", "-fopenmp", "-fno-math-errno", "-fno-trapping-math", "-march=x86-64-v3"]
    LOOP = """#include <cmath>
        namespace weft { namespace omp_v3 { void roots(float* x, const int* n) {
        #pragma omp simd
          for (int l = 0; l < 32; ++l) { float sum = 0; %s sum += std::sqrt(x[l]); x[l] = sum; }
        } } }\n"""

    def problems(self, text, allowed=""):
        good = self.compile("a.cpp", text, *self.FLAGS)
        return vectorised.check(OBJDUMP, "omp_v3", self.write("allowed.txt", allowed), [good])[0]

    def test_accepts_a_vectorised_loop(self):
        self.assertEqual(self.problems(self.LOOP % ""), [])

    def test_refuses_a_loop_of_run_time_length_inside_the_lanes(self):
        found = self.problems(self.LOOP % "for (int s = 0; s < n[0]; ++s) sum += x[n[s]];")
        self.assert_problem(found, "no packed square root: weft::omp_v3::roots")

    def test_allows_what_the_list_names_and_no_more(self):
        text = ("#include <cmath>\nnamespace weft { float one(float x) { return std::sqrt(x); }\n"
                "float two(float x) { return std::sqrt(x) + std::sqrt(x + 1); } }\n")
        found = self.problems(self.LOOP % "" + text, "1 weft::one  # a comment\n1 weft::two\n")
        self.assertEqual(found, ["omp_v3: 2 scalar roots, 1 allowed: weft::two(float)"])


class NoSpills(unittest.TestCase):
    OUTPUT = """ptxas info    : 0 bytes gmem
ptxas info    : Compiling entry function 'K' for 'sm_80'
ptxas info    : Function properties for K
    16 bytes stack frame, {0} bytes spill stores, {0} bytes spill loads
ptxas info    : Used 255 registers, used 0 barriers
"""

    def problems(self, kernel, spilled):
        name = f"void weft::cuda::run_blocks<weft::cuda::{kernel} >(int, weft::cuda::{kernel} )"
        return no_spills.check(self.OUTPUT.format(spilled), lambda _: name)[0]

    def test_refuses_spills_and_silence(self):
        self.assertEqual(self.problems("Survey<float>", 0), [])
        self.assertIn("Survey<float> spills 8 bytes on sm_80", self.problems("Survey<float>", 4)[0])
        self.assertIn("no kernel was found", no_spills.check("nvcc fatal", str)[0][0])

    def test_bounds_what_a_rare_pass_may_spill(self):
        for kernel, most in no_spills.MAY_SPILL.items():
            self.assertEqual(self.problems(kernel, most // 2), [])
            self.assertIn("spills", self.problems(kernel, most)[0])


class Variants(Project):
    ROW = "    case KernelKind::kind%s: return launch(Springs<T, %s>{sim.rows});\n"

    def problems(self, rows):
        self.write(variants.TABLE, "switch (kind) {\n" + rows + "}\n")
        return variants.check(self.root)[0]

    def test_bounds_the_table(self):
        rows = [self.ROW % (i, i) for i in range(9)]
        self.assertEqual(self.problems("".join(rows[:8])), [])
        self.assert_problem(self.problems("".join(rows)), "18 kernels")

    def test_refuses_a_table_it_cannot_trust(self):
        self.assert_problem(self.problems(""), "could not be read")
        self.assert_problem(self.problems("case KernelKind::a: { go(); }\n"), "could not be read")
        self.assert_problem(self.problems(self.ROW % (1, 1) + self.ROW % (2, 1)), "listed twice")


class Links(Project):
    def problems(self, text):
        self.write("README.md", "# One word\n## Two `words`\n" + text)
        self.write("docs/page.md", "[up](../README.md#two-words) [out](https://example.org/x)\n")
        return links.check(self.root)[0]

    def test_follows_paths_and_headings(self):
        self.assertEqual(self.problems("[a](docs/page.md) [b](#one-word) [c](docs)\n"), [])

    def test_refuses_what_is_not_there(self):
        self.assert_problem(self.problems("\n[a](docs/none.md)\n"), "README.md:4")
        self.assert_problem(self.problems("[a](#three)\n"), "no heading #three")
        self.assert_problem(self.problems("[a](../elsewhere.md)\n"), "out of the project")

    def test_refuses_headings_inside_of_code(self):
        self.assert_problem(self.problems("```\n# three\n```\n[a](#three)\n"), "no heading")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

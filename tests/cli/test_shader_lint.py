#!/usr/bin/env python3
"""Checks that tools/check-shaders reports each kind of error, and nothing else."""
import importlib.machinery
import importlib.util
import sys
import unittest

from common import SOURCE, main

sys.dont_write_bytecode = True
loader = importlib.machinery.SourceFileLoader("check_shaders", str(SOURCE / "tools/check-shaders"))
lint = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
loader.exec_module(lint)

# Each text has one error, which is in its second line.
WRONG = [
    "float f(float x) {\nreturn x * 2.0f; }",
    "void f(float a, float b) {\nfloat c = a + b; }",
    "void f(vec3 v) {\nif (v.x - 1.0f > 0.0f) return; }",
    "float f(float x) { precise float y =\ng(x * x); return y; }",
    "float f(float x) { precise float y =\nx * x > 1.0f ? 1.0f : 0.0f; return y; }",
    "float f(float x) { precise float y =\nx / 3.0f; return y; }",
    "struct S { vec4 a; }; void f(S s) {\ns.a.x = s.a.y + 1.0f; }",
    "void f(vec4 v) { v.x = 0.0f;\nv += 1.0f; }",
    "void f(float x) { for (int i = 0;\nfloat(i) < x * 2.0f; ++i) ; }",
    "void f(vec3 a) { int i =\nint(a.x * 2.0f); }",
    "#define ADD(k) \\\nsum##k = sum##k + 1.0f;",
    "#define TWICE(a) (2.0f * a)\nvoid f(float a) { float b = TWICE(a); }",
    "#ifdef EXACT_PICTURE\nfloat f(float x) { return x * 2.0f; }\n#else\nfloat f(float x) { return 2.0f * x; }\n#endif",
    "float f(vec3 a) {\nreturn dot(a, a); }",
    "float f(float a) { precise float b =\nsqrt(a); return b; }",
    "vec3 f(vec3 a, float t) {\nreturn mix(a, vec3(1.0f), t); }",
    "uniform mat4 m;\nvec4 f(vec4 p) { precise vec4 q = m * p; return q; }",
    "float inverse(float x); float f(float x) { ROUNDED float y =\ninverse(x * x); return y; }",
    "#ifdef EXACT_PICTURE\nfloat f(float x) { return x * x; }\n#else\nfloat f(float x) { return x + x; }\n#endif",
    "#define SIZE s.n\nstruct S { vec2 n; }; S s; float f(float x) { return x * SIZE.x; }",
    "void f(vec3 a) { vec3 b[2] =\nvec3[](a * 2.0f, a); }",
]
RIGHT = [
    "float f(float x, int i) { precise float y = (x * 2.0f - float(i + 1)) * -x; y += x; return -y; }",
    "int f(int i, ivec2 n) { int j = i * n.x + n.y / 2; return j % 3 - (j >> 1); }",
    "vec3 f(vec3 a, bool b) { precise vec3 c = b ? vec3(a.x * a.y, 0.0f, 1.0f) : a * 2.0f; c.x = -c.x; return c; }",
    "struct S { ivec4 n; uint k; }; S s; vec4 a[4]; void f() { vec4 v = a[s.n.x * 2 + int(s.k - 1u)]; }",
    "#ifdef FAST_NUMERICS\nfloat f(float x) { return 1.0f / x; }\n#else\nfloat f(float x) { return x; }\n#endif",
    "void f(float x) { float y = x * x; }  // inexact",
    "#ifdef EXACT_PICTURE\n#define ROUNDED precise\n#else\n#define ROUNDED\nfloat g(float x) { return 1.0 / x; }\n#endif\n"
    "float f(float x) { ROUNDED float y = x * x; return y; }",
    "#define TWICE(a) (2.0f * a)\nvoid f(float a) { precise float b = TWICE(a); }",
    "int f() { return int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x); }",
    "struct S { ivec2 n; }; S s;\n#define SIZE s.n\nint f(int i) { return i * SIZE.x - 1; }",
    "#define SIZE ivec2(3)\nint f(int i) { return i * SIZE.x / 2; }",
    "INPUT_WORDS(0, Block, w)\nuint f(int i) { return w[i].x + 1u; }",
    "uvec4 f(uvec4 a, bvec4 b) { return mix(mix(a, uvec4(1u), b), a, b); }",
    "float inverse(float x);\nfloat f(float x) { ROUNDED float y = x * inverse(x); return y; }",
    "uniform mat4 m;\nvec4 f(vec3 p) { precise vec4 q = m[0] * p.x + m[1] * p.y + m[3]; return q; }",
    "#ifdef EXACT_PICTURE\n#define ROUNDED precise\n#else\n#define ROUNDED\nfloat f(float x) { return 1.0f / x; }\n#endif",
]
MISPLACED = ["float a;\nvec4 b;", "vec4 a;\nvec3 b;", "int i;\nfloat a[4];", "float a;\nvec2 b;"]
PLACED = ["vec4 a;\nmat4 b;\nfloat c;\nint d DEFAULT(1);", "float a;\nint b;\nvec2 c;\nvec4 d;",
          "float a;\nOther b[3];\nvec4 c[2];\nfloat d;"]


class Lint(unittest.TestCase):
    def test_files_of_exact_drawing_are_checked(self):
        folder = SOURCE / "glsl/draw"
        for file in lint.EXACT_DRAWING - {"exact"}:
            self.assertTrue((folder / file).exists(), file)
        self.assertTrue(lint.is_exact("draw/sky.glsl") and lint.is_exact("draw/exact/some.comp"))
        self.assertTrue(lint.is_exact("cloth/step.comp") and lint.is_exact("common/exact.glsl"))
        self.assertFalse(lint.is_exact("draw/surface/surface.frag") or lint.is_exact("probe/samples.comp"))

    def test_floating_point_arithmetic_without_precise_is_reported(self):
        for text in WRONG:
            with self.subTest(text=text):
                self.assertEqual([line for _, line, _ in lint.check({"": text})], [2])

    def test_precise_and_integer_arithmetic_is_allowed(self):
        for text in RIGHT:
            with self.subTest(text=text):
                self.assertEqual(lint.check({"": text}), [])

    def test_types_are_known_from_included_files(self):
        texts = {"types": "struct S { ivec4 counts; vec4 place; };\nuniform B { S stepData; };",
                 "kernel": "void main() { int i = stepData.counts.x * 2;\nfloat x = stepData.place.x * 2.0f; }"}
        self.assertEqual([(file, line) for file, line, _ in lint.check(texts)], [("kernel", 2)])

    def test_block_members_at_other_offsets_than_in_cpp_are_reported(self):
        for text in MISPLACED + PLACED:
            with self.subTest(text=text):
                found = [line for line, _ in lint.misplaced(f"struct STD140 A {{\n{text}\n}};")]
                self.assertEqual(found, [3] if text in MISPLACED else [])


if __name__ == "__main__":
    main()

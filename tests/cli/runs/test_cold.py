"""Tests first pictures with an empty shader cache: the bytes do not depend on which thread compiles the kernels."""
import os
import unittest

from common import Case, main


class Cold(Case):
    def render(self, name, **more):
        done = self.good("render", "scene.json", "-o", f"{name}/", "--frames", "0-1", "-v", env={"LP_NUM_THREADS": "2"} | more)
        return done.err, self.content(name)

    @unittest.skipIf(len(os.sched_getaffinity(0)) < 2, "one processor compiles nothing ahead")
    def test_kernels_compiled_ahead(self):
        """On a device with a hardware driver no kernel is compiled ahead."""
        cache = {"MESA_SHADER_CACHE_DIR": str(self.folder / "cache")}
        cold, first = self.render("cold", **cache)
        _, second = self.render("warm", **cache)
        off, third = self.render("off", MESA_SHADER_CACHE_DISABLE="true", **cache)
        self.assertEqual(first, second)
        self.assertEqual(first, third)
        self.assertNotIn("compiled ahead", off)
        if "llvmpipe" in cold:
            self.assertIn("compiled ahead", cold)

    def test_an_unwritable_cache_does_not_change_pictures(self):
        err, pictures = self.render("none", MESA_SHADER_CACHE_DIR="/proc/self/nowhere")
        self.assertNotIn("compiled ahead", err)
        self.assertEqual(pictures, self.render("kept", MESA_SHADER_CACHE_DIR=str(self.folder / "cache"))[1])


if __name__ == "__main__":
    main()

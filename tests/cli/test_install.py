"""Tests the results of `cmake --install` and `cpack`: a tree that works after being moved, a man page, completions."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import common
from common import PATIENCE, PROGRAM, Case, main, png_rows
from serve_client import Server

BUILD = pathlib.Path(PROGRAM).parent
COMMANDS = ["render", "serve", "bake", "new", "list", "explain", "validate", "test", "accept", "report", "diff", "reproduce", "trace",
            "bisect", "sweep", "pieces", "kernels", "doctor", "bench", "schema"]


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=True, **options).stdout


@unittest.skipUnless(shutil.which("cmake") and (BUILD / "cmake_install.cmake").exists(), "no build folder")
class Installed(Case):
    def setUp(self):
        super().setUp()
        self.root = self.folder / "moved tree"
        self.work = self.folder / "elsewhere"
        self.work.mkdir()

    @classmethod
    def setUpClass(cls):
        cls.shared = pathlib.Path(tempfile.mkdtemp(prefix="simreel-install-"))
        cls.addClassCleanup(shutil.rmtree, cls.shared, True)
        run("cmake", "--install", str(BUILD), "--prefix", str(cls.shared / "prefix"))
        (cls.shared / "prefix").rename(cls.shared / "moved tree")

    def installed(self):
        """Returns the installed tree, shared by all tests that only read it."""
        return self.shared / "moved tree"

    def assert_renders(self, prefix):
        """Renders from another folder, with a pattern that only this tree's assets have, with the built-in shaders."""
        patterns = prefix / "share/simreel/assets/patterns"
        shutil.copy(patterns / "glider.rle", patterns / "ours.rle")
        shutil.rmtree(prefix / "share/simreel/glsl")
        cells = {"life": {"size": [16, 16], "patterns": [{"file": "patterns/ours.rle"}]}}
        self.write("elsewhere/scene.json", {**common.SCENE, "objects": {"cells": cells}})
        environment = {k: v for k, v in os.environ.items() if k not in ("SIMREEL_ASSETS", "SIMREEL_GLSL")}
        run(str(prefix / "bin/simreel"), "render", "scene.json", "-o", "out/", "--frames", "0,1", cwd=self.work,
            env=environment)
        self.assertEqual(png_rows((self.work / "out/000001.png").read_bytes())[:2], (64, 36))
        server = Server("scene.json", cwd=self.work, env=environment, program=prefix / "bin/simreel")
        self.addCleanup(server.stop)
        status, headers, page = server.get(f"/{server.token}/")
        self.assertEqual((status, headers["content-type"]), (200, "text/html; charset=utf-8"))
        for name in re.findall(rb'(?:src|href)="([^"]+)"', page):
            self.assertEqual(server.get(f"/{server.token}/{name.decode()}")[0], 200, name)
        viewer = server.viewer()
        self.addCleanup(viewer.close)
        self.assertEqual(png_rows(viewer.rest(0)[1])[:2], (64, 36))

    def test_shipped_scenes_starters_and_the_guide_are_installed(self):
        environment = {k: v for k, v in os.environ.items() if k != "SIMREEL_ASSETS"}
        program = str(self.installed() / "bin/simreel")
        self.assertIn("flag.json: ok", run(program, "validate", "flag", cwd=self.work, env=environment))
        self.assertIn('"cloth": {', run(program, "new", "cloth", cwd=self.work, env=environment))
        self.assertTrue((self.installed() / "share/doc/simreel/guide/reference/cloth.md").exists())
        self.assertTrue((self.installed() / "share/doc/simreel/guide/pictures/starter_cloth.png").exists())
        self.assertFalse((self.installed() / "share/simreel/assets/guide").exists())

    def test_a_moved_installation_works(self):
        shutil.copytree(self.installed(), self.root)
        self.assert_renders(self.root)

    def test_the_man_page_has_every_command_and_flag(self):
        page = self.installed() / "share/man/man1/simreel.1"
        text = page.read_text(encoding="utf-8")
        self.assertTrue(text.startswith(".TH SIMREEL 1"))
        self.assertEqual(re.findall(r'^\.SS "(\w+)', text, re.M), COMMANDS)
        for words in ("128 + n", "SIMREEL_ASSETS", "share/doc/simreel/guide"):
            self.assertIn(words, text)
        for command in COMMANDS:
            section = text.split(f'.SS "{command}')[1].split(".SS ")[0].replace("\\-", "-")
            for flag in re.findall(r"^  (?:-\w, )?(--[\w-]+)", run(PROGRAM, command, "--help"), re.M):
                if flag != "--help":
                    self.assertIn(f"\\fB{flag}\\fR", section, command)
        if shutil.which("man"):
            done = subprocess.run(["man", "--warnings", "-l", str(page)], capture_output=True, text=True, check=True,
                                  env={**os.environ, "MANWIDTH": "120", "MANPAGER": "cat"})
            self.assertEqual(done.stderr, "")
            self.assertIn("--stream-format rgba|y4m", done.stdout)

    def bash(self, *words):
        """Returns bash's completions for the last of these words."""
        script = self.installed() / "share/bash-completion/completions/simreel"
        line = " ".join(f"'{word}'" for word in words)
        return run("bash", "-c", f'source "$1"; COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _simreel; '
                   'printf "%s\\n" "${COMPREPLY[@]}"', "bash", str(script)).split()

    def test_bash_completes_a_command(self):
        self.assertEqual(self.bash("simreel", "ren"), ["render"])

    def test_bash_completes_a_flag(self):
        self.assertEqual(self.bash("simreel", "-q", "render", "scene.json", "--stream"), ["--stream-format"])

    def test_bash_completes_a_choice(self):
        self.assertEqual(self.bash("simreel", "render", "--fields", ""), ["npy", "pfm"])

    def test_bash_leaves_files_to_the_shell(self):
        self.assertEqual(self.bash("simreel", "render", "-o", "ren"), [])

    @unittest.skipUnless(shutil.which("fish"), "no fish")
    def test_fish_completes_a_command_a_flag_and_a_choice(self):
        script = self.installed() / "share/fish/vendor_completions.d/simreel.fish"

        def offered(line):
            return run("fish", "--no-config", "-c", 'source $argv[1]; complete -C $argv[2]', str(script), line)
        self.assertIn("render\tRender a scene", offered("simreel ren"))
        self.assertIn("--stream-format\t", offered("simreel render --stream"))
        self.assertIn("npy\t", offered("simreel render --fields n"))

    @unittest.skipUnless(shutil.which("zsh"), "no zsh")
    def test_zsh_can_read_its_completion(self):
        script = self.installed() / "share/zsh/site-functions/_simreel"
        run("zsh", "-n", str(script))

    def test_a_program_builds_against_the_library_and_runs(self):
        build = self.folder / "example"
        environment = {k: v for k, v in os.environ.items() if k != "SIMREEL_ASSETS"}
        run("cmake", "-S", str(common.SOURCE / "examples/cpp"), "-B", str(build), f"-DCMAKE_PREFIX_PATH={self.installed()}")
        run("cmake", "--build", str(build))
        text = run(str(build / "fall"), cwd=self.work, env=environment)
        self.assertIn('line 1, column 44, objects.a.cloth.fabrik: "fabric" is meant', text)
        self.assertEqual(png_rows((self.work / "fall.png").read_bytes())[:2], (320, 180))

    @unittest.skipUnless(shutil.which("pkg-config"), "no pkg-config")
    def test_pkg_config_finds_the_library(self):
        (folder,) = {file.parent for file in self.installed().glob("lib/**/simreel.pc")}
        words = run("pkg-config", "--cflags", "--libs", "simreel", env={**os.environ, "PKG_CONFIG_PATH": str(folder)})
        self.assertIn("-lsimreel", words)
        include = pathlib.Path(re.search(r"-I((?:\\.|\S)+)", words)[1].replace("\\", ""))
        self.assertTrue((include / "simreel/simreel.hpp").exists(), words)

    @unittest.skipUnless((BUILD / "python/simreel").exists() and os.access("/usr/bin/python3", os.X_OK), "no Python module")
    def test_the_python_module_works_where_it_is_installed(self):
        environment = {k: v for k, v in os.environ.items() if k not in ("SIMREEL_ASSETS", "SIMREEL")}
        environment["PYTHONPATH"] = str(self.installed() / "lib/python3/dist-packages")
        self.write("elsewhere/scene.json", common.SCENE)
        text = run("/usr/bin/python3", "-c", "import simreel\nscene = simreel.load('scene.json')\n"
                   "print(simreel.__file__, simreel.program(), scene.step(2)['flag'].positions.shape)", cwd=self.work, env=environment)
        self.assertEqual(text.replace(str(self.installed()), "").strip(),
                         "/lib/python3/dist-packages/simreel/__init__.py /bin/simreel (7, 9, 3)")

    @unittest.skipUnless(shutil.which("cpack") and shutil.which("dpkg-shlibdeps"), "no cpack or dpkg-dev")
    def test_the_package_renders_and_names_its_libraries(self):
        run("cpack", "--config", str(BUILD / "CPackConfig.cmake"), "-B", str(self.folder / "package"),
            "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip", cwd=self.folder)
        (package,) = (self.folder / "package").glob("simreel_*.deb")
        names = {file.name.partition("_")[0] for file in (self.folder / "package").glob("*.deb")}
        self.assertLessEqual({"simreel", "libsimreel", "libsimreel-dev"}, names)
        depends = run("dpkg-deb", "-f", str(package), "Depends")
        for library in ("libepoxy0", "libisal2", "libegl1", "libopengl0", "libgl1-mesa-dri"):
            self.assertIn(library, depends)
        run("dpkg-deb", "-x", str(package), str(self.root))
        self.assertEqual(run("dpkg-deb", "-f", str(package), "Architecture"), run("dpkg", "--print-architecture"))
        self.assert_renders(self.root / "usr")


if __name__ == "__main__":
    main()

"""Tests exit codes 4 (device, limit, lost state) and 6 (input and output)."""
import ctypes
import os
import resource
import struct
import subprocess
import zlib

from common import PROGRAM, SOURCE, Case, main, with_values


def png(size, raw, extra=b"IEND"):
    """Returns an 8-bit colour PNG with raw rows `raw`; `extra` is the kind of a last, empty chunk."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", *size, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", packed(raw)) + chunk(extra, b""))


def packed(raw):
    """Compresses bytes, or `raw` zero bytes. The zeros are compressed in pieces, because a child process starts with
    its parent's peak memory size."""
    if isinstance(raw, bytes):
        return zlib.compress(raw, 9)
    packer, piece = zlib.compressobj(9), bytes(1_000_000)
    return b"".join(packer.compress(piece) for _ in range(raw // len(piece))) + packer.flush()


LIBC = ctypes.CDLL(None)


class Device(Case):
    def test_no_such_device(self):
        for name in ("nonsense", "99"):
            self.bad(4, [f"--device {name}", "no device matches"], "render", "scene.json", "-o", "out/",
                     "--device", name)
        self.bad(4, ["no device matches"], "doctor", "--device", "nonsense")
        self.assertFalse((self.folder / "out").exists())

    def test_a_small_stack(self):
        """The program raises the stack limit to what drivers and threads need, or reports that it cannot."""
        def limited(size, hard):
            return lambda: resource.setrlimit(resource.RLIMIT_STACK, (size << 10, hard))
        self.good("render", "scene.json", "-o", "out/", "--frames", "0", preexec_fn=limited(64, resource.RLIM_INFINITY))
        # Root could raise its hard limit, so the program runs without CAP_SYS_RESOURCE.
        done = subprocess.run(["setpriv", "--bounding-set=-sys_resource", "--inh-caps=-sys_resource", "prlimit", f"--stack={64 << 10}:{64 << 10}",
                               PROGRAM, "list"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertEqual(done.stderr, "simreel: error: the stack may have 64 KiB here, and drivers need 256; allow more: ulimit -s 8192\n")

    def test_no_driver(self):
        for env in ({"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"}, {"__EGL_VENDOR_LIBRARY_DIRS": str(self.folder)}):
            self.bad(4, ["install a driver", "simreel doctor"], "render", "scene.json", "-o", "out/", env=env)
        # The message first names environment variables that select the driver.
        for name, value in (("GALLIUM_DRIVER", "softpipe"), ("MESA_GL_VERSION_OVERRIDE", "3.3"), ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nothing")):
            words = f"{name}={value} in the environment selects another driver. Unset it first, or install a driver"
            self.bad(4, [words], "render", "scene.json", "-o", "out/", env={name: value})
            done = self.bad(4, [words], "doctor", env={name: value})
            self.assertIn(f"Environment: {name}={value} selects another driver", done.stdout.decode())
            done = self.bad(4, "install a driver", "doctor", env=env)
            self.assertIn(b"EGL devices: none", done.stdout)
        self.assertFalse((self.folder / "out").exists())
        self.good("validate", "scene.json", env={"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"})

    def test_picture_beyond_the_limits(self):
        self.bad(4, ["16 samples", "GL_MAX_SAMPLES"], "render", "scene.json", "-o", "out/",
                 "-D", "render.size=[16384,16384]", "--samples", "16", "--rasterizer", "driver")
        self.assertEqual(list(self.folder.glob("out/*")), [])

    def test_cloth_beyond_the_limits(self):
        """The error comes at once, before gigabytes are allocated."""
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))
        for size in ([16384, 16384], [5000, 5000]):
            self.bad(4, ["flag", "16384x16384" if size[0] > 9999 else "5000x5000", "GL_MAX_SHADER_STORAGE_BLOCK_SIZE"],
                     "render", "scene.json", "-o", "out/", "-D", f"objects.flag.cloth.size={size}", preexec_fn=limit)
        self.assertEqual(list(self.folder.glob("out/*")), [])

    def test_a_diverging_simulation_is_an_error(self):
        scene = with_values({"objects.flag.cloth": {"size": [9, 7], "stiffness": 1e7, "mass": 0.001, "substeps": 2,
                                                    "jitter": 0.01, "pins": [{"rows": [-1]}]}, "time.duration": 2})
        self.write("wild.json", scene)
        done = self.bad(4, ["\"flag\" blew up in substep ", "particle (", "use more substeps (2 per frame",
                            "simreel: warning: ", "stable"], "render", "wild.json", "-o", "out/")
        self.assertLessEqual(len(done.err.splitlines()), 3)  # one of them says that the wind is strong for so little mass
        frames = self.assert_manifest_is_whole("out")
        self.assertEqual(frames, list(range(len(frames))))
        self.assertLess(len(frames), 60)
        self.assertGreaterEqual(len(frames), 1)

    def test_auto_substeps_above_the_limit_are_refused(self):
        """The message gives the number of substeps and the solver without such a limit, which then renders."""
        self.write("stiff.json", with_values({"objects.flag.cloth": {"size": [9, 7], "stiffness": 1e7, "mass": 0.01,
                                                                     "substeps": "auto"}}))
        self.bad(2, ["\"auto\" would take 1142 a frame", "1024", "\"solver\": \"constraints\""],
                 "render", "stiff.json", "-o", "out/", "--fps", "60")
        self.good("render", "stiff.json", "-o", "out/", "--fps", "60", "-D", "objects.flag.cloth.solver=constraints")

    def test_fast_air_later_in_the_run_is_warned_about_at_the_start(self):
        light = {"size": [9, 7], "stiffness": 10, "mass": 0.0002, "substeps": 64, "air": {"velocity": {
            "keys": [[0, [0, 0, 0]], [50, [150, 0, 0]]]}}}
        self.write("storm.json", with_values({"objects.flag.cloth": light}))
        done = self.good("render", "storm.json", "-o", "out/", "--frames", "0")
        self.assert_words(["fewer than the ", "fastest air", "\"substeps\": \"auto\""], done)
        self.assertEqual(done.err.count("fastest air"), 1)


class Scarce(Case):
    """Tests with few threads or little address space: rendering is slower, and the pictures are equal."""

    def setUp(self):
        super().setUp()
        self.once("render", "scene.json", "-o", "whole/")

    def assert_same(self, prepare):
        done = self.good("render", "scene.json", "-o", "out/", "-v", preexec_fn=prepare)
        self.assertEqual(self.content("out"), self.content("whole"))
        return done

    def test_no_threads(self):
        for path in (self.folder, self.folder / "scene.json"):
            path.chmod(0o777)

        def prepare():
            if os.geteuid() == 0:
                os.setgid(65534)
                os.setuid(65534)
            resource.setrlimit(resource.RLIMIT_NPROC, (1, 1))

        try:
            subprocess.run([PROGRAM, "--version"], preexec_fn=prepare, capture_output=True, check=True)
        except (OSError, subprocess.SubprocessError):
            self.skipTest("the program cannot be run by another user here")
        done = self.assert_same(prepare)
        self.assertRegex(done.err, "0 of [0-9]+ threads for encoding")

    def test_little_address_space(self):
        self.assert_same(lambda: resource.setrlimit(resource.RLIMIT_AS, (600000 << 10, 600000 << 10)))


class InputOutput(Case):
    def test_existing_frames(self):
        self.good("render", "scene.json", "-o", "out/")
        before = self.content("out")
        self.bad(6, ["out/000000.png", "5 more", "--overwrite", "--resume"], "render", "scene.json", "-o", "out/",
                 "--seed", "7")
        self.bad(6, ["out/000002.png", "exists"], "render", "scene.json", "-o", "out/", "--frames", "2")
        self.assertEqual(self.content("out"), before)
        self.good("render", "scene.json", "-o", "out/", "--frames", "9")

    def test_folders_that_cannot_be_created(self):
        self.write("file", "x")
        for output in ("file/", "file/deep/", "file/a.mp4", "file/a_####.png", "/proc/x/"):
            self.bad(6, ["cannot create", output.split("/")[-2]], "render", "scene.json", "-o", output)
        self.assertEqual((self.folder / "file").read_text(), "x")

    def test_read_only_folder(self):
        out = self.folder / "out"
        out.mkdir()
        out.chmod(0o555)
        # Root may write to all files unless this capability is dropped (prctl 24 drops a capability; its number is 1).
        preexec = (lambda: LIBC.prctl(24, 1, 0, 0, 0)) if os.geteuid() == 0 else None
        self.bad(6, ["cannot create out/"], "render", "scene.json", "-o", "out/", preexec_fn=preexec)

    def test_a_folder_in_the_place_of_a_frame(self):
        (self.folder / "out/000001.png").mkdir(parents=True)
        self.bad(6, ["out/000001.png"], "render", "scene.json", "-o", "out/", "--overwrite")

    def test_full_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        mounted = os.geteuid() == 0 and subprocess.run(["mount", "-t", "tmpfs", "-o", "size=96k", "tmpfs", disk],
                                                       capture_output=True, check=False).returncode == 0
        if not mounted:
            self.skipTest("a small file system can be mounted by root only")
        try:
            # The file system has 24 pages. One is already used, eight are reserved for the manifest, and each frame
            # takes one.
            self.write("disk/other", "x")
            arguments = ("render", "scene.json", "-o", "disk/", "-D", "time.duration=2")
            self.bad(6, ["disk/0000", "No space left"], *arguments)
            frames = self.assert_manifest_is_whole("disk")
            self.assertGreaterEqual(len(frames), 8)
            # The manifest lists all written files, and no other file remains, not even a .part file.
            listed = [frame["file"] for frame in self.manifest("disk")["frames"]]
            self.assertEqual(sorted(p.name for p in disk.iterdir()), sorted([*listed, "as-run.json", "manifest.json", "other", "run.json"]))
            times = {name: (disk / name).stat().st_mtime_ns for name in listed}
            subprocess.run(["mount", "-o", "remount,size=4m", disk], check=True)
            self.good(*arguments, "--resume")
            self.assertEqual(len(self.assert_manifest_is_whole("disk")), 60)
            self.assertEqual(times, {name: (disk / name).stat().st_mtime_ns for name in listed})
        finally:
            subprocess.run(["umount", disk], check=True)

    def test_full_disk_for_text(self):
        with open("/dev/full", "wb") as full:
            for arguments in (["schema"], ["list"], ["list", "sun"], ["--version"], ["--help"]):
                self.bad(6, ["simreel: error: cannot write"], *arguments, stdout=full)
            self.bad(6, "No space left", "render", "scene.json", "-o", "-", stdout=full)

    def test_corrupt_textures(self):
        self.write("scene.json", with_values({"objects.flag.material": {"texture": "t.png"}}))
        whole = (SOURCE / "assets/textures/flag.png").read_bytes()
        for content in (b"", b"not a picture", whole[:2000], whole[:40] + bytes(1000)):
            self.write("t.png", content)
            self.bad(6, ["t.png", "PNG or JPEG"], "render", "scene.json", "-o", "out/")
        for magic, channels in ((b"P5", 1), (b"P6", 3)):
            self.write("t.png", magic + b" 64 64 65535\n" + bytes(64 * 64 * 2 * channels))
            self.bad(6, ["t.png", "PNM picture of 16 bits", "use PNG"], "render", "scene.json", "-o", "out/")
        # A header with a size above the device's limit is refused before memory is allocated.
        self.write("t.png", png((20000, 10000), b"x"))
        self.bad(4, ["t.png", "20000x10000", "limit of 16384"], "render", "scene.json", "-o", "out/")
        for promise in (png((16000, 16000), bytes(16001 * 3)), b"P5 16000 16000 255 x"):
            self.write("t.png", promise)
            self.bad(6, ["t.png", "16000x16000 pixels do not fit"], "render", "scene.json", "-o", "out/")
        for flat in (b"P5 2 P5 255 abcd", b"P6 0 2 255 x"):
            self.write("t.png", flat)
            self.bad(6, ["t.png", "PNG or JPEG"], "render", "scene.json", "-o", "out/")
        # The message may quote the file but must stay on one line.
        self.write("t.png", png((1, 1), bytes(4), extra=b"\n\x1bLT"))
        self.bad(6, ["t.png", "PNG or JPEG"], "render", "scene.json", "-o", "out/")
        self.assertEqual(list(self.folder.glob("out/*")), [])

    def test_data_after_the_pixels_of_a_picture_is_not_decompressed(self):
        """600 MB of zeros after a picture of 64 pixels are not decompressed."""
        self.write("scene.json", with_values({"objects.flag.material": {"texture": "t.png"}}))
        self.write("t.png", png((64, 1), 600_000_000))
        ran = subprocess.Popen([PROGRAM, "render", "scene.json", "-o", "out/"], cwd=self.folder, stderr=subprocess.PIPE)
        message = ran.stderr.read().decode()
        _, status, usage = os.wait4(ran.pid, 0)
        ran.stderr.close()
        ran.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(ran.returncode, 6, message)
        self.assertLess(usage.ru_maxrss, 400_000)  # peak memory in KiB; most of it belongs to the driver

    def test_no_ffmpeg(self):
        self.bad(6, ["ffmpeg is not installed", "apt install ffmpeg"], "render", "scene.json", "-o", "a.mp4",
                 env={"PATH": str(self.folder)})
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["scene.json"])

    def test_ffmpeg_dies(self):
        for name, body, words in (("late", "head -c 20000 >/dev/null; echo trouble >&2; exit 3", ["status 3", "trouble"]),
                                  ("early", "exit 1", ["ffmpeg", "status 1"]),
                                  ("signal", "head -c 100 >/dev/null; kill -11 $$", ["signal 11"]),
                                  ("end", "cat >/dev/null; exit 4", ["status 4"])):
            fake = self.write(f"{name}/ffmpeg", f"#!/bin/sh\n{body}\n")
            fake.chmod(0o755)
            self.bad(6, words, "render", "scene.json", "-o", "a.mp4",
                     env={"PATH": f"{fake.parent}:{os.environ['PATH']}"})
        self.assertEqual(list(self.folder.glob("*.mp4*")) + list(self.folder.glob("*part*")), [])

    def test_closed_pipe(self):
        for form in ("rgba", "y4m"):
            reader, writer = os.pipe()
            os.close(reader)
            self.bad(6, "standard output was closed", "render", "scene.json", "-o", "-", "--stream-format", form,
                     stdout=writer)
            os.close(writer)


if __name__ == "__main__":
    main()

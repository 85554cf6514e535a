"""share/python/raypro.py against the programs that the environment variables RAYPRO and RAYIMG name."""

import contextlib
import glob
import io
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import warnings
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "share/python"))
import raypro  # noqa: E402

HELLO = ROOT / "scenes/hello.scn"
BALL = "camera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100\nsphere -1  0 0.5 0  1\n"
SIZE = {"width": 24, "height": 18}
LONG = {"width": 256, "height": 256, "samples": 100000, "mode": "path"}


class Folder(unittest.TestCase):
    """Each test with a folder of its own, in which temporary folders are made too."""

    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = made.name
        for change in (mock.patch.dict(os.environ, TMPDIR=self.folder), mock.patch.object(tempfile, "tempdir", None)):
            change.start()
            self.addCleanup(change.stop)

    def left(self):
        return glob.glob(os.path.join(self.folder, "raypro-*"))

    def traced(self):
        """Environment variables by which raypro leaves the number of its process in a file."""
        program = pathlib.Path(self.folder, "raypro")
        program.write_text(f"#!/bin/sh\necho $$ > '{self.folder}/process'\nexec '{raypro._find('raypro')}' \"$@\"\n")
        program.chmod(0o755)
        return {**os.environ, "RAYPRO": str(program)}

    def is_running(self):
        try:
            os.kill(int(pathlib.Path(self.folder, "process").read_text()), 0)
            return True
        except ProcessLookupError:
            return False


class Pictures(Folder):
    def test_every_mode_shows_the_pixels_that_raypro_writes(self):
        listed = raypro._run("raypro", ["-list", "modes"])[0]
        modes = re.findall(r"^  (\w+) ", listed, flags=re.MULTILINE)
        self.assertGreater(len(modes), 10)
        ways = ({"srgb": True}, {"bytes": "truncated"})
        written = [{"mode": mode, **way} for mode in ("whitted", "depth") for way in ways]
        for options in [{"mode": mode} for mode in modes] + written:
            own, ours = self.folder + "/own.png", self.folder + "/ours.png"
            raypro._run_scene(HELLO, [own, "-quiet"], {**SIZE, **options})
            pathlib.Path(ours).write_bytes(raypro.render(HELLO, **SIZE, **options)._repr_png_())
            self.assertEqual(raypro.diff(ours, own)["largest"]["value"], 0, options)

    def test_the_rows_begin_above_and_pixels_are_those_of_debugpixel(self):
        image = raypro.render(BALL, **SIZE)
        self.assertEqual((image.width, image.height), (24, 18))
        self.assertEqual((len(image.array), len(image.array[0])), (18, 24))
        above, below = (sum(map(sum, image.array[row])) for row in (6, 11))
        self.assertGreater(above, below, "the ball is above the middle")
        for x, y in ((12, 12), (10, 9), (0, 0)):
            head = raypro.debugpixel(BALL, x, y, **SIZE).splitlines()[0]
            self.assertTrue(head.startswith(f"pixel {x} {y} of 24 x 18"), head)
            for told, value in zip(head.split(": ")[1].split(), image.pixel(x, y)):
                self.assertAlmostEqual(float(told), float(value), places=4)
        with self.assertRaisesRegex(IndexError, "no pixel 24 0 in an image of 24 x 18"):
            image.pixel(24, 0)

    def test_an_image_knows_the_rays_behind_its_pixels(self):
        for options in ({}, SIZE, {"width": 40, "height": 30, "layers": ["depth"], "samples": 2, "mode": "path"}):
            image = raypro.render(BALL, **options)
            x, y = image.width - 1, image.height // 2
            tree = image.debugpixel(x, y)
            self.assertTrue(tree.startswith(f"pixel {x} {y} of {image.width} x {image.height}"), tree)
            for told, value in zip(tree.splitlines()[0].split(": ")[1].split(), image.pixel(x, y)):
                self.assertAlmostEqual(float(told.rstrip(",")), float(value), places=4)
        with self.assertRaisesRegex(ValueError, "it is a layer"):
            image.layers["depth"].debugpixel(0, 0)

    @unittest.skipUnless(raypro.numpy, "numpy is not installed")
    def test_numpy_or_not_the_numbers_are_those(self):
        image = raypro.render(HELLO, **SIZE)
        with mock.patch.object(raypro, "numpy", None):
            lists = raypro.Image(image._pfm).array
        self.assertIsInstance(lists, list)
        self.assertEqual(image.array.tolist(), lists)

    def test_floats_of_both_byte_orders_are_read(self):
        image = raypro.render(HELLO, **SIZE)
        floats = image._floats
        turned = b"".join(floats[i : i + 4][::-1] for i in range(0, len(floats), 4))
        other = raypro.Image(b"PF\n24 18\n1.0\n" + turned)
        self.assertEqual([list(p) for p in other.array[3]], [list(p) for p in image.array[3]])

    def test_layers_report_and_summary_come_along(self):
        image = raypro.render(HELLO, samples=4, layers=["depth", "normal"], **SIZE)
        self.assertEqual(sorted(image.layers), ["depth", "normal"])
        self.assertEqual(image.report["settings"]["samples"], 4)
        self.assertRegex(image.summary, r"^24x18 4 spp ")
        self.assertEqual(image.warnings, [])
        tree = raypro.debugpixel(HELLO, 12, 4, **SIZE)
        points = re.search(r"from (\S+ \S+ \S+) along[^,]*,[^,]* at t \S+, (\S+ \S+ \S+), normal", tree).groups()
        eye, hit = ([float(number) for number in point.split()] for point in points)
        depth = raypro.render(HELLO, layers="depth", **SIZE).layers["depth"].pixel(12, 4)[0]
        self.assertAlmostEqual(math.dist(eye, hit), float(depth), places=3)

    def test_a_saved_image_is_compared_with_one_at_hand(self):
        image = raypro.render(HELLO, **SIZE)
        image.save(self.folder + "/out.pfm")
        self.assertEqual(raypro.diff(self.folder + "/out.pfm", image)["rmse"], 0)
        darker = raypro.render(HELLO, shadows=True, max_depth=0, **SIZE)
        found = raypro.diff(darker, image, fail_rmse=1e-6)
        self.assertGreater(found["rmse"], 0)
        self.assertEqual(len(found["failures"]), 1)
        self.assertEqual(self.left(), [])


class Options(Folder):
    def settings(self, **options):
        return raypro.render(BALL, **SIZE, **options).report["settings"]

    def test_values_of_all_kinds_reach_raypro(self):
        found = self.settings(shadows=False, glossy=True, fresnel=False, motion=(0.5, 0, -1), roulette=True, seed=None)
        self.assertEqual((found["shadows"], found["glossy"], found["fresnel"]), (False, True, False))
        self.assertEqual((found["motion"], found["roulette"], found["seed"]), ([0.5, 0, -1], "on", 0))
        self.assertEqual(self.settings(allow_path=[ROOT, "/"])["allow_path"], [str(ROOT), "/"])

    def test_zero_and_one_are_off_and_on_where_no_number_is_meant(self):
        found = self.settings(shadows=0, fresnel=1, glossy=0, samples=1, max_depth=0)
        self.assertEqual((found["shadows"], found["fresnel"], found["glossy"]), (False, True, False))
        self.assertEqual((found["samples"], found["max_depth"]), (1, 0))
        self.assertIn("primitives    1\n", raypro.tell(BALL, check=1))

    @unittest.skipUnless(raypro.numpy, "numpy is not installed")
    def test_numpys_values_are_those_of_python(self):
        numpy = raypro.numpy
        found = self.settings(
            shadows=numpy.bool_(False), fresnel=numpy.bool_(True), denoise=numpy.bool_(False), srgb=numpy.array(True),
            samples=numpy.array(4), seed=numpy.int64(1), motion=numpy.array([0.5, 0, -1]), max_depth=numpy.uint8(2),
        )  # fmt: skip
        switches = [found[name] for name in ("shadows", "fresnel", "denoise", "srgb")]
        self.assertEqual(switches, [False, True, False, True])
        self.assertEqual([found[name] for name in ("samples", "seed", "max_depth")], [4, 1, 2])
        self.assertEqual(found["motion"], [0.5, 0, -1])

    def test_names_may_begin_with_a_dash(self):
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        pathlib.Path("-ball.scn").write_text(BALL)
        image = raypro.render("-ball.scn", **SIZE)
        self.assertEqual(raypro.diff(image, raypro.render(BALL, **SIZE))["rmse"], 0)
        image.save("-out.pfm")
        self.assertEqual(raypro.diff("-out.pfm", image, map="-map.png")["rmse"], 0)
        self.assertTrue(os.path.exists("-map.png"))

    def test_a_report_is_written_where_it_is_wanted(self):
        image = raypro.render(BALL, folder=self.folder, report="-run.json", **SIZE)
        self.assertEqual(json.loads(pathlib.Path(self.folder, "-run.json").read_text()), image.report)
        self.assertEqual(self.left(), [])

    def test_the_version_is_that_of_the_program(self):
        self.assertTrue(raypro._run("raypro", ["-version"])[0].startswith(f"raypro {raypro.__version__}"))
        with mock.patch.dict(os.environ, RAYPRO="/nowhere/raypro"):
            self.assertFalse(hasattr(raypro, "__version__"))
        self.assertFalse(hasattr(raypro, "no_such_name"))

    def test_what_is_defined_stands_in_the_scene(self):
        moving = BALL.replace("0 0.5 0", "$x $y 0")
        there = raypro.render(moving, define={"x": 0, "y": 0.5}, **SIZE)
        self.assertEqual(raypro.diff(there, raypro.render(BALL, **SIZE))["rmse"], 0)
        elsewhere = raypro.render(moving, define=["x=1", "y=0"], **SIZE)
        self.assertGreater(raypro.diff(elsewhere, there)["rmse"], 0)

    def test_names_in_a_text_start_in_the_folder(self):
        text = HELLO.read_text()
        image = raypro.render(text, folder=HELLO.parent, **SIZE)
        self.assertEqual(raypro.diff(image, raypro.render(HELLO, **SIZE))["rmse"], 0)

    def test_what_renders_nothing_is_told(self):
        self.assertIn("primitives    1\n", raypro.tell(BALL, check=True))
        with self.assertRaisesRegex(ValueError, "raypro.tell"):
            raypro.render(BALL, check=True)


class Mistakes(Folder):
    def refused(self, *arguments, **options):
        with self.assertRaises(raypro.SceneError) as caught:
            raypro.render(*arguments, **options)
        self.assertEqual(self.left(), [])
        return caught.exception.status, str(caught.exception)

    def test_a_mistake_in_a_scene_comes_with_its_caret(self):
        status, text = self.refused(BALL + "spere -1 0 0 0 1\n")
        self.assertEqual(status, 3)
        self.assertEqual(text.splitlines()[0], "<stdin>:3:1: error: unknown command 'spere'")
        self.assertRegex(text.splitlines()[2], r"^ +\| \^~~~~ did you mean 'sphere'\?$")
        status, text = self.refused("no such scene.scn")
        self.assertEqual((status, text), (3, "no such scene.scn: error: no such file"))

    def test_an_empty_scene_is_named_as_such(self):
        for empty in ("", " ", "\n"):
            with self.assertRaisesRegex(ValueError, "the scene is empty"):
                raypro.render(empty)

    def test_with_progress_the_words_are_those_without(self):
        wrong = BALL + "spere -1 0 0 0 1\n"
        self.assertEqual(self.refused(wrong, progress=lambda share, text: None), self.refused(wrong, progress=False))

    def test_an_option_that_is_wrong_is_refused_by_raypro(self):
        self.assertRegex(self.refused(BALL, widht=5)[1], "unknown option '-widht'; did you mean '-width'")
        self.assertRegex(self.refused(BALL, width="wide")[1], "^raypro: -width must be a whole number.*got 'wide'")
        self.assertRegex(self.refused(BALL, shadows="maybe")[1], "'maybe'")
        self.assertEqual(self.refused(BALL, bits=9)[0], 2)

    def test_warnings_are_kept_and_given_to_python(self):
        scene = BALL + "cone -1  0 0 0  1 0\ncone -1  0 0 0  1 0\n"
        with warnings.catch_warnings(record=True) as given:
            warnings.simplefilter("always")
            image = raypro.render(scene, **SIZE)
        self.assertEqual(len(image.warnings), 2)
        self.assertEqual(image.warnings, image.report["warnings"])
        self.assertEqual([str(each.message).strip() for each in given], image.warnings)

    def test_a_missing_program_says_what_to_do(self):
        with mock.patch.dict(os.environ, RAYPRO=self.folder + "/raypro"):
            with self.assertRaisesRegex(FileNotFoundError, "the folder of RAYPRO; build it"):
                raypro.render(BALL)
        moved = mock.patch.object(raypro, "__file__", "/nowhere/raypro.py")
        with mock.patch.dict(os.environ, {"PATH": self.folder}, clear=True), moved:
            with self.assertRaisesRegex(FileNotFoundError, "or on PATH; build it"):
                raypro.render(BALL)

    def test_programs_are_found_nearby_installed_and_on_the_path(self):
        for place, package in (("raypro_programs", ""), ("bin", "share/raypro/python"), ("build", "share/python")):
            folder = pathlib.Path(self.folder, place + "!")
            (folder / place).mkdir(parents=True)
            (folder / package).mkdir(parents=True, exist_ok=True)
            program = folder / place / "raypro"
            program.symlink_to("/bin/sh")
            for path, file in (("", folder / package / "raypro.py"), (str(program.parent), "/nowhere/raypro.py")):
                moved = mock.patch.object(raypro, "__file__", file)
                with mock.patch.dict(os.environ, {"PATH": path}, clear=True), moved:
                    self.assertEqual(os.path.normpath(raypro._find("raypro")), str(program))


class Progress(Folder):
    def test_shares_grow_and_words_follow(self):
        told = []
        raypro.render(HELLO, progress=lambda *each: told.append(each), width=128, height=128, mode="path", time="1s")
        self.assertGreater(len(told), 2)
        self.assertEqual([share for share, _ in told], sorted(share for share, _ in told))
        self.assertTrue(all(0 <= share <= 1 for share, _ in told))
        self.assertRegex(told[-1][1], "left")

    def test_the_line_is_taken_away(self):
        with contextlib.redirect_stdout(io.StringIO()) as shown:
            raypro.render(HELLO, progress=True, width=128, height=128, mode="path", time="1s")
        self.assertRegex(shown.getvalue(), r"^\r +\d+%  .*left")
        self.assertRegex(shown.getvalue(), r"\r +\r$")

    def test_lines_in_pieces_are_the_lines(self):
        class Pieces:
            def __init__(self, content, length):
                self.left = [content[i : i + length] for i in range(0, len(content), length)]

            def read(self, _):
                return self.left.pop(0) if self.left else b""

        said = b"a.scn:1:1: warning: x\r\n\r\033[K  5%  0:09 left\r\033[K 50%  0:02 left\r\033[Kb: warning: y\r\n"
        for length in (1, 2, 3, 7, 1000):
            told = []
            kept = raypro._listen(Pieces(said, length), lambda *each: told.append(each))
            self.assertEqual(raypro._split_warnings(kept), ["a.scn:1:1: warning: x", "b: warning: y"], length)
            self.assertEqual(told[-1], (0.5, "0:02 left"))

    def test_what_progress_raises_stops_raypro(self):
        def refuse(share, text):
            self.assertTrue(self.is_running())
            raise RuntimeError("enough")

        with mock.patch.dict(os.environ, self.traced()), self.assertRaisesRegex(RuntimeError, "enough"):
            raypro.render(HELLO, progress=refuse, **LONG)
        self.assertFalse(self.is_running())
        self.assertEqual(self.left(), [])

    def test_an_interrupt_stops_raypro_and_leaves_nothing(self):
        for progress in ("False", "lambda share, text: None"):
            program = f"import raypro; raypro.render({str(HELLO)!r}, progress={progress}, **{LONG})"
            python = subprocess.Popen(
                [sys.executable, "-c", program], stderr=subprocess.PIPE, text=True,
                env={**self.traced(), "PYTHONPATH": str(ROOT / "share/python")},
                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
            )  # fmt: skip
            started = time.monotonic()
            while not os.path.exists(self.folder + "/process") and time.monotonic() - started < 20:
                time.sleep(0.02)
            time.sleep(0.3)
            self.assertTrue(self.is_running())
            python.send_signal(signal.SIGINT)
            _, said = python.communicate(timeout=20)
            self.assertTrue(said.rstrip().endswith("KeyboardInterrupt"), said)
            self.assertFalse(self.is_running())
            self.assertEqual(self.left(), [])
            os.remove(self.folder + "/process")


if __name__ == "__main__":
    unittest.main()

"""The package ribbon for Python, as its users see it."""

import ast
import contextlib
import inspect
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy

import ribbon
from ribbon import _ribbon

ALONG, ACROSS, LENGTH, WIDTH = 30, 5, 0.6, 0.04
SIZE = {"length": LENGTH, "width": WIDTH}
OWN = {"along": ALONG, "across": ACROSS, **SIZE}
STONE = ribbon.Mesh([[0, 0, 0], [0, 0, 0.1], [0.1, 0, 0], [0, 0.1, 0]],
                    [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], "stone")


def flat(height=0.5):
    """A flat ribbon at this height, along x across x 3."""
    positions = numpy.empty((ALONG, ACROSS, 3))
    positions[..., 0] = numpy.linspace(0, LENGTH, ALONG)[:, None]
    positions[..., 1] = height
    positions[..., 2] = numpy.linspace(-WIDTH / 2, WIDTH / 2, ACROSS)
    return positions


def folded():
    """Turned back upon itself, through itself."""
    positions = flat()
    positions[20:, :, 0] = positions[20, 0, 0] - (positions[20:, :, 0] - positions[20, 0, 0])
    positions[20:, :, 1] += numpy.linspace(0.01, -0.01, 10)[:, None]
    return positions


class RibbonTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "own.rbn"

    def written(self, frames, **settings):
        ribbon.write(self.path, frames, **SIZE, **settings)
        return ribbon.open(self.path)


class Writing(RibbonTest):
    def test_frames_come_back_within_the_error(self):
        frames = [flat(0.1 * i) + 1e-4 * numpy.sin(i) for i in range(12)]
        recording = self.written(frames, max_error=1e-6)
        self.assertEqual(len(recording), 12)
        for positions, frame in zip(recording, frames):
            self.assertLessEqual(numpy.abs(positions - frame).max(), 1e-6)

    def test_without_an_error_single_precision_is_kept(self):
        frame = numpy.random.default_rng(1).uniform(-1, 1, (ALONG, ACROSS, 3)).astype(numpy.float32)
        self.assertTrue((self.written([frame], max_error=0)[0] == frame).all())

    def test_what_is_told_of_the_ribbon_is_kept(self):
        recording = self.written([flat()], frames_per_second=24, name="sail", stated_gap=1e-4, strain_limit=0.2,
                                 obstacle=STONE)
        self.assertEqual((recording.along, recording.across), (ALONG, ACROSS))
        self.assertEqual((recording.length, recording.width), (LENGTH, WIDTH))
        self.assertEqual((recording.frames_per_second, recording.scene_name), (24, "sail"))
        self.assertEqual((recording.stated_gap, recording.strain_limit), (1e-4, 0.2))
        self.assertEqual(recording.obstacle.name, "stone")
        self.assertTrue((recording.obstacle.triangles == STONE.triangles).all())
        self.assertTrue((recording.row_widths == WIDTH).all())
        self.assertEqual(recording.uv.shape, (ALONG, ACROSS, 2))
        self.assertEqual(recording.triangles.shape, (2 * (ALONG - 1) * (ACROSS - 1), 3))
        self.assertTrue(recording.finished)
        self.assertEqual(ribbon.scene(recording), {})

    def test_numbers_are_arrays_over_time(self):
        stretched = flat() * [1.1, 1, 1]
        recording = self.written([flat(), stretched], frames_per_second=10)
        numpy.testing.assert_allclose(recording.numbers()["time"], [0, 0.1])
        numpy.testing.assert_allclose(recording.numbers()["worst_strain"], [0, 0.1], atol=1e-3)
        self.assertTrue(numpy.isnan(recording.numbers()["progress"]).all())

    def test_an_older_recording_stays_unless_told_otherwise(self):
        self.written([flat()])
        with self.assertRaisesRegex(ribbon.Error, "own.rbn"):
            self.written([flat(), flat()])
        self.assertEqual(len(ribbon.open(self.path)), 1)
        with ribbon.Writer(self.path, force=True, **OWN):
            pass
        self.assertEqual(len(ribbon.open(self.path)), 1, "no frame came")
        self.assertEqual(len(self.written([flat(), flat()], force=True)), 2)

    def test_what_stops_on_the_way_is_readable_and_not_finished(self):
        with self.assertRaises(KeyError), ribbon.Writer(self.path, **OWN) as writer:
            writer.append(flat())
            raise KeyError
        recording = ribbon.open(self.path)
        self.assertEqual((len(recording), recording.finished), (1, False))

    def test_what_has_no_frame_leaves_the_name_free(self):
        for first in (flat() * numpy.nan, flat() + 1e9, numpy.full((ALONG, ACROSS, 3), "x"), flat()[..., :2]):
            with self.assertRaises((ValueError, ribbon.Error)):
                self.written([first])
            self.assertFalse(self.path.exists())
        writer = ribbon.Writer(self.path, **OWN)
        self.assertTrue(self.path.exists())
        del writer
        self.assertEqual(len(self.written([flat()])), 1)
        with self.assertRaises(ribbon.Error):
            self.written([flat() + 1e9], force=True)
        self.assertEqual(len(ribbon.open(self.path)), 1)

    def test_what_no_reader_would_take_replaces_nothing(self):
        self.written([flat()])
        for wrong in ({"max_error": 1e39}, {"length": 1e40}):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(ribbon.Error, "no reader would take its header"):
                ribbon.write(self.path, [flat()], **(SIZE | wrong), force=True)
        self.assertEqual(len(ribbon.open(self.path)), 1)

    def test_what_makes_no_sense_is_refused(self):
        for wrong, word in (({"along": 1}, "2 x 2"), ({"along": 50000, "across": 50000}, "not 50000 x 50000"),
                            ({"across": 2**31 - 1}, r"at most 2\^20 columns"), ({"length": 0}, "length"),
                            ({"width": float("nan")}, "width"), ({"frames_per_second": 0}, "frames_per_second"),
                            ({"name": ""}, "name"), ({"max_error": -1}, "max_error"),
                            ({"stated_gap": -1}, "stated_gap"), ({"strain_limit": float("inf")}, "strain_limit")):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(ValueError, word):
                ribbon.Writer(self.path, **(OWN | wrong))
        self.assertFalse(self.path.exists())
        for grid in ({"along": 1}, {"along": 50000, "across": 50000}):
            with self.subTest(grid=grid), self.assertRaisesRegex(ValueError, "a ribbon has at "):
                ribbon.Verifier(**(OWN | grid))
        for size in ({"length": numpy.inf}, {"width": numpy.nan}, {"width": 0}):
            with self.subTest(size=size), self.assertRaisesRegex(ValueError, "length and width must be above 0"):
                ribbon.Verifier(**(OWN | size))
        for wrong in (numpy.full((20, 4, 3), "x"), flat() + 1j, numpy.full((20, 4, 3), None)):
            with self.subTest(wrong=wrong.dtype), self.assertRaisesRegex(ValueError, "must be numbers"):
                ribbon.write(self.path, [wrong], **SIZE)
        with self.assertRaisesRegex(ValueError, "at least one array"):
            ribbon.write(self.path, [], **SIZE)

    def test_frames_that_cannot_be_kept_are_refused(self):
        with ribbon.Writer(self.path, **OWN) as writer:
            with self.assertRaisesRegex(ValueError, r"\(30, 5, 3\), not \(5, 30, 3\)"):
                writer.append(flat().transpose(1, 0, 2))
            for number in (numpy.nan, numpy.inf):
                with self.assertRaisesRegex(ValueError, "positions of frame 1 must be finite"):
                    writer.append(numpy.full((ALONG, ACROSS, 3), number))
            with self.assertRaisesRegex(ribbon.Error, "frame 1: .* allow a larger position error"):
                writer.append(flat() + 1e9)
            for wrong in (flat().astype(str), flat() + 1j, None, [[1, 2], [3]]):
                with self.assertRaisesRegex(ValueError, "positions must be numbers, not of the type"):
                    writer.append(wrong)
            writer.append(flat())
        with self.assertRaisesRegex(ValueError, "closed"):
            writer.append(flat())
        self.assertEqual(len(ribbon.open(self.path)), 1)

    def test_times_run_forward(self):
        with ribbon.Writer(self.path, **OWN) as writer:
            for wrong in (float("nan"), float("inf")):
                with self.assertRaisesRegex(ValueError, "the time of frame 1, .*must be a number"):
                    writer.append(flat(), time=wrong)
            writer.append(flat(), time=-1)
            writer.append(flat(), time=0.5)
            for wrong in (0.25, 0.5, None, float("nan")):
                with self.subTest(wrong=wrong), self.assertRaisesRegex(
                    ValueError, r"the time of frame 3, .* s, must be later than 0\.5 s, that of the frame before"
                ):
                    writer.append(flat(), time=wrong)
            writer.append(flat(), time=0.75)
        self.assertEqual(ribbon.open(self.path).numbers()["time"].tolist(), [-1, 0.5, 0.75])

    def test_meshes_are_checked(self):
        with self.assertRaisesRegex(ValueError, "from 0 to 2"):
            ribbon.Mesh(numpy.zeros((3, 3)), [[0, 1, 3]])
        with self.assertRaisesRegex(ValueError, r"vertices must have the shape \(any, 3\)"):
            ribbon.Mesh(numpy.zeros((3, 2)), [[0, 1, 2]])
        with self.assertRaisesRegex(ValueError, "triangles must be whole numbers, not of the type float64"):
            ribbon.Mesh(numpy.zeros((3, 3)), [[0, 1.9, 2.2]])
        with self.assertRaisesRegex(ValueError, "from 0 to 2"):
            ribbon.Mesh(numpy.zeros((3, 3)), [[0, 1, 2**32 + 2]])
        with self.assertRaisesRegex(ValueError, "vertices must be numbers"):
            ribbon.Mesh([["a", "b", "c"]] * 3, [[0, 1, 2]])


class Reading(RibbonTest):
    def test_positions_are_not_copied_on_their_way(self):
        positions = self.written([flat()])[0]
        self.assertEqual(positions.shape, (ALONG, ACROSS, 3))
        self.assertEqual(positions.dtype, numpy.float32)
        self.assertTrue(positions.flags.c_contiguous and positions.flags.writeable and not positions.flags.owndata)

    def test_arrays_outlive_the_recording(self):
        recording = self.written([flat()], obstacle=STONE)
        positions, uv, vertices = recording[0], recording.uv, recording.obstacle.vertices
        del recording
        numpy.testing.assert_allclose(positions, flat(), atol=1e-5)
        self.assertEqual(uv[-1, -1].tolist(), [1, 1])
        numpy.testing.assert_allclose(vertices, STONE.vertices)
        with self.assertRaises(ValueError):
            uv[0, 0] = 1

    def test_frames_are_counted_as_in_a_list(self):
        recording = self.written([flat(0.1), flat(0.2)])
        self.assertTrue((recording[-1] == recording[1]).all())
        for frame in (2, -3):
            with self.subTest(frame=frame), self.assertRaisesRegex(IndexError, "only 2"):
                recording[frame]

    def test_errors_say_place_problem_and_remedy(self):
        with self.assertRaises(ribbon.Error) as caught:
            ribbon.open(self.path)
        error = caught.exception
        self.assertIn("own.rbn", error.place)
        self.assertTrue(error.problem and error.remedy)
        self.assertEqual(str(error), f"{error.place}: {error.problem}; {error.remedy}")

    def test_names_may_be_of_any_bytes(self):
        with self.assertRaisesRegex(ribbon.Error, r"no\\xffwhere.rbn"):
            ribbon.open(os.fsencode(self.path.with_name("no")) + b"\xffwhere.rbn")
        self.path = pathlib.Path(os.fsdecode(os.fsencode(self.path.parent) + b"/\xff.rbn"))
        self.assertEqual(self.written([flat()], name=b"\xff").scene_name, "\\xff")
        self.assertEqual(ribbon.Mesh(STONE.vertices, STONE.triangles, b"st\xf6n").name, "st\\xf6n")

    def test_a_damaged_frame_is_an_error_and_the_others_are_read(self):
        self.written([flat(0.01 * i) for i in range(9)])
        bytes_of_it = bytearray(self.path.read_bytes())
        bytes_of_it[len(bytes_of_it) // 2] ^= 255
        self.path.write_bytes(bytes_of_it)
        recording = ribbon.open(self.path)
        recording.check()
        self.assertTrue(recording.damage)
        readable = [frame for frame in range(len(recording)) if recording.readable(frame)]
        self.assertTrue(0 < len(readable) < 9)
        for frame in set(range(len(recording))) - set(readable):
            self.assertRaises(ribbon.Error, recording.__getitem__, frame)

    def test_a_recording_is_followed_while_it_is_written(self):
        writer = ribbon.Writer(self.path, **OWN)
        writer.append(flat(0.0))
        followed = ribbon.follow(ribbon.open(self.path), every=0.001)
        for frame in range(1, 20):
            self.assertAlmostEqual(float(next(followed)[0, 0, 1]), 0.01 * (frame - 1), places=4)
            writer.append(flat(0.01 * frame))
        self.assertEqual(len(list(followed)) if writer.close() is None else 0, 1)


class Verifying(RibbonTest):
    def test_a_frame_that_passes_through_itself_is_found(self):
        verifier = ribbon.Verifier(**OWN)
        self.assertFalse(verifier.verify(flat()).intersects)
        verdict = verifier.verify(folded())
        self.assertTrue(verdict.finite and verdict.intersects)
        self.assertEqual(verdict.pairs.shape[1], 2)

    def test_gap_and_obstacle_count(self):
        verifier = ribbon.Verifier(**OWN, obstacle=STONE)
        self.assertAlmostEqual(verifier.verify(flat(0.101)).gap, 0.001, places=6)
        self.assertTrue(verifier.verify(flat(0.05)).intersects)

    def test_strain_is_measured(self):
        self.assertAlmostEqual(ribbon.Verifier(**OWN).verify(flat() * [1, 1, 1.25]).strain, 0.25, places=5)

    def test_no_number_is_told(self):
        self.assertFalse(ribbon.Verifier(**OWN).verify(flat() * numpy.nan).finite)

    def test_recordings_are_verified_as_a_whole(self):
        self.assertEqual(ribbon.verify(self.written([flat(), flat(0.6)])).complaints, [])
        recording = self.written([flat(), folded()], force=True)
        verification = ribbon.verify(recording)
        self.assertEqual((verification.frames_checked, verification.intersecting_frames), (2, 1))
        self.assertTrue(any("intersect" in complaint for complaint in verification.complaints))
        self.assertEqual(ribbon.verify(recording, [0]).intersecting_frames, 0)

    def test_what_is_stated_and_not_kept_is_told(self):
        self.assertTrue(ribbon.verify(self.written([flat()], stated_gap=0.5)).complaints)
        self.assertTrue(ribbon.verify(self.written([flat() * 1.5], strain_limit=0.1, force=True)).complaints)

    def test_threads_verify_at_the_same_time(self):
        verifier, verdicts = ribbon.Verifier(**OWN), []
        threads = [threading.Thread(target=lambda: verdicts.append(verifier.verify(folded()).intersects))
                   for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(verdicts, [True] * 4)


class Documents(RibbonTest):
    def test_the_documented_examples_run(self):
        tree, installed = pathlib.Path(__file__).parents[2], pathlib.Path("/usr/share/doc/ribbon")
        document = next(folder / "docs/python.md" for folder in (tree, installed) if (folder / "docs").is_dir())
        examples = re.findall(r"^```python\n(.*?)^```$", document.read_text(), re.MULTILINE | re.DOTALL)
        self.assertEqual(len(examples), 3)
        with contextlib.chdir(self.path.parent), contextlib.redirect_stdout(io.StringIO()) as said:
            ribbon.write("knot.rbn", [flat(), flat(0.6)], **SIZE)
            names = {}
            for example in examples:
                exec(example, names)
            self.assertEqual(len(ribbon.open("wave.rbn")), 100)
        self.assertIn("2 frames of 30 x 5 particles", said.getvalue())
        self.assertIn("all is well", said.getvalue())


    def test_the_sample_plots_the_tension(self):
        tree, installed = pathlib.Path(__file__).parents[2], pathlib.Path("/usr/share/ribbon")
        sample = next(folder / "samples/tension.py" for folder in (tree, installed) if (folder / "samples").is_dir())
        self.written([flat(), flat() * [1.02, 1, 1]], max_error=1e-7)
        plot = self.path.with_suffix(".svg")
        said = subprocess.run([sys.executable, sample, self.path, plot], check=True, capture_output=True, text=True)
        self.assertRegex(said.stdout, r"2 frames, strain from -?0.00 % to 2.00 %")
        self.assertIn("<svg", plot.read_text())
        empty = self.path.with_name("empty.rbn")
        ribbon.Writer(empty, **OWN).close()
        for recording, picture, word in ((self.path.with_name("no.rbn"), plot, "no.rbn: cannot be opened"),
                                         (empty, plot, "empty.rbn: the recording holds no frame"),
                                         (self.path, plot.with_suffix(".what"), "what: "),
                                         (self.path, self.path.parent / "no" / "where.svg", "where.svg: No such file")):
            refused = subprocess.run([sys.executable, sample, recording, picture], capture_output=True, text=True)
            self.assertIn(word, refused.stderr)
            self.assertNotIn("Traceback", refused.stderr)


class Hints(unittest.TestCase):
    """What _ribbon.pyi promises is what there is, and the other way round."""

    def setUp(self):
        stub = pathlib.Path(ribbon.__file__).with_name("_ribbon.pyi")
        self.classes = {node.name: {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
                        for node in ast.parse(stub.read_text()).body if isinstance(node, ast.ClassDef)}

    def test_classes_have_what_is_promised(self):
        for name, promised in self.classes.items():
            public = {member for member in vars(getattr(_ribbon, name))
                      if not member.startswith("_") or member in promised}
            with self.subTest(name=name):
                self.assertEqual(public, promised)

    def test_no_class_is_left_out(self):
        self.assertEqual(set(self.classes),
                         {name for name, member in vars(_ribbon).items() if inspect.isclass(member)})


if __name__ == "__main__":
    unittest.main()

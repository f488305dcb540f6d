"""What gallery_page.py writes, and what it leaves as it is."""

import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

import gallery_page


class GalleryPage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.page = self.folder / "gallery.md"
        for name in ("bow", "reef"):
            (self.folder / f"{name}.toml").write_text(f"# A {name}\n# round a post.\n\n[[stage]]\n")

    def tied(self, name, hand, frames=301, passed=True):
        run = self.folder / f"{name}-{hand}"
        told = {".stats": {"across": 5, "along": 600, "frames": frames},
                ".time": {"wall_s": 3, "user_s": 2, "system_s": 0},
                ".verify": {"passed": passed, "intersections": {"pairs": 0}, "strain": {"largest": 0.081},
                            "outcome": {"embraces_object": True, "knot_distance_m": 0.0025}}}
        for suffix, content in told.items():
            run.with_suffix(suffix).write_text(json.dumps(content))
        np.save(run.with_suffix(".npy"), np.zeros((12, 4, 2, 3)))

    def written(self):
        with contextlib.redirect_stdout(io.StringIO()):
            status = gallery_page.main(self.folder, self.folder, self.page)
        return status, self.page.read_text()

    def test_a_knot_has_its_description_and_a_row_for_each_hand(self):
        self.tied("bow", "drawn")
        self.tied("bow", "mirrored", frames=302)
        status, text = self.written()
        self.assertEqual(status, 0)
        self.assertIn("**bow**<br>A bow round a post.<br>", text)
        self.assertIn("| bow | 5x600 | 1 | 301 | 3 | 2 | 0 | 8.1 % | 2.5 | 0.000 | 0.00 | yes |", text)
        self.assertIn("| bow | 5x600 | 1 | 302 |", text.split("With the other hand")[1])
        self.assertNotIn("reef", text)

    def test_a_knot_that_is_not_as_promised_is_told_of(self):
        self.tied("bow", "drawn", passed=False)
        status, text = self.written()
        self.assertEqual(status, 1)
        self.assertIn("| **no** |", text)

    def test_rows_of_other_knots_and_what_is_written_below_them_stay(self):
        self.tied("bow", "drawn")
        self.tied("reef", "drawn")
        self.tied("reef", "mirrored", frames=303)
        before = self.written()[1] + "\nBy hand.\n\nIn two paragraphs.\n"
        self.page.write_text(before)
        for file in self.folder.glob("reef-*"):
            file.unlink()
        self.assertEqual(self.written()[1], before)
        self.tied("bow", "drawn", frames=302)
        self.tied("bow", "mirrored", frames=304)
        text = self.written()[1]
        self.assertIn("| bow | 5x600 | 1 | 302 |", text)
        self.assertNotIn("| bow | 5x600 | 1 | 301 |", text)
        self.assertLess(text.index("| 304 |"), text.index("| 303 |"))
        self.assertTrue(text.endswith("|\n\nBy hand.\n\nIn two paragraphs.\n"))


if __name__ == "__main__":
    unittest.main()

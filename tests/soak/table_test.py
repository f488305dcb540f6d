"""What table.py says of runs, of their knots above all."""

import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path

import table

CHANGE = {"frame_before": 101, "frame_after": 111, "before": "reef knot", "after": "last end buried"}


class Table(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def verified(self, name, passed, of_whole=(), of_parts=()):
        (self.folder / f"{name}.part").write_text("jitter\n")
        verify = {"passed": passed, "intersections": {"pairs": 0},
                  "gap": {"smallest_m": 0.002, "stated_m": 0.001},
                  "knot": {"changes": list(of_whole),
                           "between": [{"changes": changes} for changes in of_parts]}}
        (self.folder / f"{name}.verify").write_text(json.dumps(verify))

    def told(self):
        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            code = table.main(self.folder)
        return code, text.getvalue()

    def test_a_knot_that_stays_is_the_same(self):
        self.verified("bow-jitter-1", True, of_parts=[[]])
        self.verified("reef-jitter-1", True)
        code, text = self.told()
        self.assertEqual(code, 0)
        self.assertEqual(text.count("same"), 2)
        self.assertNotIn("WRONG", text)

    def test_a_part_that_becomes_another_knot_is_not_the_same(self):
        self.verified("bow-jitter-2", False, of_parts=[[CHANGE]])
        code, text = self.told()
        self.assertEqual(code, 1)
        self.assertIn("1 changes", text)
        self.assertNotIn("same", text)
        self.assertIn("WRONG: bow-jitter-2", text)

    def test_changes_of_the_whole_and_of_its_parts_are_counted_together(self):
        self.verified("bow-jitter-3", False, of_whole=[CHANGE], of_parts=[[CHANGE, CHANGE], []])
        self.assertIn("3 changes", self.told()[1])


if __name__ == "__main__":
    unittest.main()

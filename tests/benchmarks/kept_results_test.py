"""kept_results_test.py: what was measured is measured once, and a line that a stop cut off anew."""

import tempfile
import unittest
from pathlib import Path

from kept_results import KeptResults, checksum


def must_not_be_measured():
    raise AssertionError("is there already")


class KeptResultsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "results"

    def test_what_was_measured_is_measured_once(self):
        KeptResults(self.file).of("a", lambda: [1.5, {"b": 2}])
        self.assertEqual(KeptResults(self.file).of("a", must_not_be_measured), [1.5, {"b": 2}])

    def test_another_key_is_measured(self):
        KeptResults(self.file).of("a", lambda: 1)
        self.assertEqual(KeptResults(self.file).of("b", lambda: 2), 2)

    def test_a_line_that_was_cut_off_is_measured_anew_and_spoils_none(self):
        for key, result in (("a", 1), ("b", 2)):
            KeptResults(self.file).of(key, lambda: result)
        self.file.write_bytes(self.file.read_bytes()[:-3])
        again = KeptResults(self.file)
        self.assertEqual(again.of("a", must_not_be_measured), 1)
        self.assertEqual(again.of("b", lambda: 3), 3)
        self.assertEqual(KeptResults(self.file).of("b", must_not_be_measured), 3)

    def test_files_are_told_by_what_is_in_them(self):
        self.file.write_text("one build")
        before = checksum(self.file)
        self.file.write_text("another build")
        self.assertNotEqual(before, checksum(self.file))


if __name__ == "__main__":
    unittest.main()

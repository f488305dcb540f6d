"""Manual pages from what tools say of themselves."""

import re
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "packaging"))

import man_page  # noqa: E402, found only now

HELP = """Ties a knot.
Usage: tie [OPTIONS] CORD

Positionals:
  CORD FILE REQUIRED          what is tied

Options:
  -h,--help                   Print this help
  --turns N Excludes: --loose --once
                              how often; 'twice' is 2
  --once Needs: --slow        only once

Examples:
  tie cord --turns 2
      ties it .twice

Cords are long.
Exit codes: 0 done, 2 could not:
try again.
"""


class ManPage(unittest.TestCase):
    def setUp(self):
        self.lines = man_page.page("tie", "tie 1.0", HELP).splitlines()

    def test_it_says_what_the_tool_is(self):
        self.assertEqual(self.lines[0], '.TH TIE 1 "" "tie 1.0" "User Commands"')
        self.assertIn("tie \\- ties a knot", self.lines)

    def test_an_option_stands_above_its_help(self):
        for option, text in (("CORD FILE REQUIRED", "What is tied."), ("\\-h,\\-\\-help", "Print this help.")):
            self.assertEqual(self.lines[self.lines.index(f".B {option}") + 1], text)

    def test_options_that_go_with_or_without_others_say_so(self):
        self.assertIn("How often; 'twice' is 2. Not with \\-\\-loose, \\-\\-once.", self.lines)
        self.assertIn("Only once. Only with \\-\\-slow.", self.lines)

    def test_examples_keep_their_lines_and_nothing_is_a_command_of_troff(self):
        self.assertIn("      ties it .twice", self.lines)
        self.assertEqual(man_page.roff(".twice\n'tis"), "\\&.twice\n\\&'tis")

    def test_exit_codes_have_a_title_of_their_own(self):
        at = self.lines.index(".SH EXIT STATUS")
        self.assertEqual(self.lines[at - 1:at + 3], ["Cords are long.", ".SH EXIT STATUS", "0 done, 2 could not:",
                                                     "try again."])

    def test_the_pages_of_the_tools_have_all_of_their_options(self):
        for tool in map(Path, TOOLS):
            said = man_page.answer(tool, "--help")
            page = man_page.page(tool.name, "", said).replace("\\", "")
            options = set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", said, re.MULTILINE))
            with self.subTest(tool=tool.name):
                self.assertGreater(len(options), 10)
                self.assertEqual({option for option in options
                                  if not re.search(rf"^\.B (?:-\w,)?{option}\b", page, re.MULTILINE)}, set())


if __name__ == "__main__":
    TOOLS = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])

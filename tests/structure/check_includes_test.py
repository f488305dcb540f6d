"""Plants one violation at a time into a small tree and looks whether the scan finds it."""

import tempfile
import unittest
from pathlib import Path

from check_includes import Scan

README = """
| station | is | may include |
|---|---|---|
| `result` | answers | |
| `files` | whole files | `result` |
| `physics` | motion | `result` |
| `physics/contact` | touching | |
| `physics/step` | one step | `contact` |

| tool | may include |
|---|---|
| `recorder` | `result`, `files`, `physics` |
| `player` | `result`, `files` |
"""

CLEAN = {
    "libribbon/README.md": README,
    "libribbon/result/result.h": "#include <string>\n#include <tl/expected.hpp>\n",
    "libribbon/files/files.h": '#include <Eigen/Core>\n#include "result/result.h"\n',
    "libribbon/files/files.cpp": '#include "files/files.h"\n\n#include <unistd.h>\n#include <zstd.h>\n',
    "libribbon/physics/physics.h": '#include "result/result.h"\n#include "physics/step/step.h"\n',
    "libribbon/physics/contact/contact.h": '#include "result/result.h"\n',
    "libribbon/physics/step/step.h": '#include "physics/contact/contact.h"\n',
    "libribbon/physics/step/loops.inc": '#include "physics/step/step.h"\n',
    "recorder/record.cpp": '#include "physics/physics.h"\n#include <CLI/CLI.hpp>\n',
    "player/play.cpp": '#include "files/files.h"\n#include "view.h"\n',
    "player/view.h": "#include <embree3/rtcore.h>\n",
}


def violations(files):
    """What the scan finds in a tree of these files."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            file = Path(folder) / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        return list(Scan(Path(folder)).violations())


class CheckIncludes(unittest.TestCase):
    def finds(self, name, text, *expected):
        """In the clean tree with one file replaced or added."""
        self.assertEqual(violations(CLEAN | {name: text}), list(expected))

    def test_a_clean_tree_passes(self):
        self.assertEqual(violations(CLEAN), [])

    def test_an_upward_include_is_found_with_file_and_line(self):
        self.finds("libribbon/files/files.h", '#pragma once\n#include "physics/physics.h"\n',
                   "libribbon/files/files.h:2: 'files' may not include 'physics/physics.h'")

    def test_an_include_against_the_order_of_rooms_is_found(self):
        self.finds("libribbon/physics/contact/contact.h", '#include "physics/step/step.h"\n',
                   "libribbon/physics/contact/contact.h:1: "
                   "'physics/contact' may not include 'physics/step/step.h'")

    def test_a_room_may_not_include_what_stands_at_the_door(self):
        self.finds("libribbon/physics/step/step.h", '#include "physics/physics.h"\n',
                   "libribbon/physics/step/step.h:1: 'physics/step' may not include 'physics/physics.h'")

    def test_a_room_may_include_other_stations_only_as_its_station_may(self):
        self.finds("libribbon/physics/step/step.h", '#include "files/files.h"\n',
                   "libribbon/physics/step/step.h:1: 'physics' may not include 'files/files.h'")

    def test_files_that_others_are_made_of_are_looked_at(self):
        self.finds("libribbon/physics/step/loops.inc", '#include "player/view.h"\n',
                   "libribbon/physics/step/loops.inc:1: 'physics' may not include 'player/view.h'")

    def test_a_room_without_a_row_is_found(self):
        self.finds("libribbon/physics/attic/attic.h", "",
                   "libribbon/README.md: 'physics/attic' has no row")

    def test_angle_brackets_hide_nothing(self):
        self.finds("libribbon/files/files.h", "#  include <physics/physics.h>\n",
                   "libribbon/files/files.h:1: 'files' may not include 'physics/physics.h'")

    def test_the_player_may_not_include_physics(self):
        self.finds("player/play.cpp", '#include "physics/physics.h"\n',
                   "player/play.cpp:1: 'player' may not include 'physics/physics.h'")

    def test_a_station_may_not_include_a_tool(self):
        self.finds("libribbon/files/files.h", '#include "player/view.h"\n',
                   "libribbon/files/files.h:1: 'files' may not include 'player/view.h'")

    def test_a_way_up_is_found(self):
        self.finds("libribbon/files/files.h", '#include "../physics/physics.h"\n',
                   "libribbon/files/files.h:1: '../physics/physics.h' goes up; name the folder instead")

    def test_a_header_that_is_nowhere_is_found(self):
        self.finds("libribbon/files/files.h", '#include "files/gone.h"\n',
                   "libribbon/files/files.h:1: 'files/gone.h' is no file of libribbon or of 'files'")

    def test_a_second_file_with_the_same_library_is_found(self):
        self.finds("libribbon/physics/physics.cpp", "#include <zstd.h>\n",
                   "libribbon/physics/physics.cpp:1: <zstd.h> is hidden in libribbon/files/files.cpp; "
                   "a library belongs in one .cpp")

    def test_a_library_in_a_header_is_found(self):
        self.finds("libribbon/physics/physics.h", "#include <tbb/parallel_for.h>\n",
                   "libribbon/physics/physics.h:1: <tbb/parallel_for.h> belongs in a .cpp")

    def test_embree_and_osmesa_outside_the_player_are_found(self):
        for header in ("embree3/rtcore.h", "GL/osmesa.h"):
            self.finds("recorder/record.cpp", f"#include <{header}>\n",
                       f"recorder/record.cpp:1: <{header}> belongs in player/ only")

    def test_mesh_export_outside_the_converter_is_found(self):
        self.finds("libribbon/files/files.cpp", "#include <assimp/Exporter.hpp>\n",
                   "libribbon/files/files.cpp:1: <assimp/Exporter.hpp> belongs in converter/ only")

    def test_a_folder_without_a_row_is_found(self):
        self.finds("libribbon/utils/utils.h", "", "libribbon/README.md: 'utils' has no row")

    def test_a_row_without_a_folder_is_found(self):
        self.finds("libribbon/README.md", README + "| `gone` | x | |\n",
                   "libribbon/README.md: 'gone' has a row but no folder")

    def test_a_circle_in_the_table_is_found(self):
        circle = README.replace("| `result` | answers | |", "| `result` | answers | `files` |")
        self.assertIn(
            "libribbon/README.md: 'result' may include itself in a circle",
            violations(CLEAN | {"libribbon/README.md": circle}),
        )


if __name__ == "__main__":
    unittest.main()

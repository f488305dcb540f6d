"""What was measured stays when a long measurement is stopped; part of picture_noise.py and
picture_quality.py."""

import hashlib
import json
from pathlib import Path


def checksum(*files):
    """Of what is in them, whatever they are called."""
    return " ".join(hashlib.sha256(Path(file).read_bytes()).hexdigest()[:16] for file in files)


class KeptResults:
    """A line of JSON in the file for each result: its key, which says all that it depends on, and what
    was measured."""

    def __init__(self, file):
        self.file = Path(file)
        self.results = {}
        if not self.file.exists():
            return
        for line in self.file.read_text().splitlines():
            try:
                key, result = json.loads(line)
                self.results[key] = result
            except ValueError:
                pass  # cut off by the stop

    def of(self, key, measure):
        """What measure() returned for this key, at any time."""
        if key not in self.results:
            self.results[key] = measure()
            with self.file.open("a") as lines:
                lines.write("\n" + json.dumps([key, self.results[key]]))
        return self.results[key]

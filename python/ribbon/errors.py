"""What went wrong in the outside world."""


class Error(Exception):
    """A file, a disk or a recording is not as it should be; str() is one sentence."""

    def __init__(self, place: str, problem: str, remedy: str, may_pass: bool = False) -> None:
        super().__init__((f"{place}: " if place else "") + problem + (f"; {remedy}" if remedy else ""))
        #: Where: "knot.rbn: byte 4096"; may be empty.
        self.place = place
        #: What is wrong.
        self.problem = problem
        #: What to do about it; may be empty.
        self.remedy = remedy
        #: The same may work another time: interrupted, or the disk was full.
        self.may_pass = may_pass

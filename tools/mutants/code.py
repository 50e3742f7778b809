"""The groups of shaders that can be mutated, and the tests of each group."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Code:
    folders: tuple  # folders below glsl
    others: bool    # true if the group consists of all folders except `folders`
    # for drawing: arguments of test_gpu for each group of tests; the first group runs before the scenes are drawn
    tests: tuple
    bar: float      # fraction of mutants that must be caught

    def has(self, file):
        return file.startswith(self.folders) != self.others


KNOWN = {
    "drawing": Code(("draw/",), False, (("--source-file=*gpu/draw/exact/*",),
                                        ("--source-file=*gpu/draw/*", "--source-file-exclude=*gpu/draw/exact/*")), 0.95),
    "simulations": Code(("draw/", "probe/"), True, (), 0.90),
}
chosen = KNOWN["drawing"]


def choose(name):
    global chosen  # pylint: disable=global-statement
    chosen = KNOWN[name]

"""Which shaders are changed, and which tests know them."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Code:
    folders: tuple  # below glsl
    others: bool    # all folders but these
    tests: tuple    # of drawing: arguments of test_gpu, of each group of tests; the first is asked before all scenes were
    bar: float      # of the mutants that have to be caught

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

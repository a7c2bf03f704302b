"""How wrong the two methods' images are, beside how fast they are: short runs of fixed seeds against the kept references."""

import json

from process import output_of

METHODS = ("shlm", "photonmap")
HITS = "1e5"
SEEDS = range(1, 9)
SIZE = ("--width", "96", "--height", "54")  # the references'


def cases(references, scenes):
    """(name, method, scene file, reference file) for every scene that has a reference."""
    found = []
    for reference in sorted(references.glob("*.exr")):
        scene = scenes / (reference.stem + ".glb")
        if scene.exists():
            found += [(f"{reference.stem}/{method}", method, scene, reference) for method in METHODS]
    return found


def relative_rms(program, judge, case, seed):
    """Of the image that `program` draws; `judge` is the shlmbench whose diff measures both revisions. Throws MeasurementFailed."""
    _, method, scene, reference = case
    image = program.parent / "image.exr"  # not where the other's is: render replaces no picture that it did not make itself
    output_of([program, "render", scene, "--method", method, "--hits", HITS, "--seed", str(seed), *SIZE, "--out", image])
    return json.loads(output_of([judge, "diff", image, reference, "--json"]))["relative_rms"]

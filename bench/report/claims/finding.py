"""What became of one of the paper's claims."""

from dataclasses import dataclass, field

NOT_MEASURED, NOT_DECIDED = "not measured", "not decided"
NOT_MEASURED_YET = "not measured yet"
PLAIN = {"confirmed": "holds", "refuted": "fails", "conditional": "holds if"}  # other verdicts say it themselves


@dataclass
class Finding:
    claim: str
    says: str
    verdict: str  # confirmed, refuted, conditional, not decided, not measured yet
    measured: str  # all of it, in words
    incremental: str = ""  # the verdict against flann-incremental; empty where the claim has no such side
    strongest: str = ""  # and against the strongest engine, see baselines.py
    condition: str = ""  # where it is true; what is missing where it is not decided
    plain: str = ""  # the condition in a sentence or two for who has not read the rest; empty where there is none
    figure: str = ""  # one number with its range
    ratios: dict = field(default_factory=dict)  # photon map -> hits -> (least, most) over the scenes of its figure over the light map's
    scenes: tuple = ()  # that it rests on
    runs: tuple = ()  # fewest and most repetitions or seeds of what it rests on


def sentence(text):
    """Of a condition or a name and what is said of it; empty where there is none."""
    return f"{text[0].upper()}{text[1:]}." if text else ""


def not_measured(claim, says):
    return Finding(claim, says, NOT_MEASURED_YET, "")

"""What became of one of the paper's claims."""

from dataclasses import dataclass


@dataclass
class Finding:
    claim: str
    says: str
    verdict: str  # confirmed, refuted, conditional, not decided, not measured yet
    measured: str
    incremental: str = ""  # the verdict against flann-incremental; empty where the claim has no such side
    strongest: str = ""  # and against the strongest engine, see baselines.py


def not_measured(claim, says):
    return Finding(claim, says, "not measured yet", "")

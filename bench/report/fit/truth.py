"""How well a fine light map may stand in for the truth, as it does in `shlmbench fit`.

    bench/report fit-truth STUDY SCENE FINE COARSE

STUDY is the folder of a `shlmbench study` with two seeds or more; of its methods, FINE is what is to stand in for the
truth, F, and COARSE one with a quarter of its texels, Q. Prints for each method C with the most hits its squared bias
by the reference, by F (what F blurs, (Q - F)^2, added), by 2 F - Q, and as bench/experiments/fit/self_estimates.h has it.
All are relative, mean w (C - E)^2; noise is in none of them, as only answers of different seeds are multiplied.
"""

import sys
from pathlib import Path

import numpy as np

from report.study.data import Study, StudyError
from report.study.errors import mean_products, split_of


def difference_sq(answers, others, weight):
    """Mean w (what answers converge to - what the others do)^2; both seeds x points x 3, of the same photons."""
    products = mean_products(answers, others, weight)
    count = len(products)
    return float(products.sum() - np.trace(products)) / (count * (count - 1))


def rows_of(scene, runs, fine, coarse):
    """(method, by the reference, by F, by 2 F - Q, by fit); `runs`: (Run, answers) by method."""
    f, q = runs[fine][1], runs[coarse][1]
    blur_sq = difference_sq(q, f, scene.weight)
    for method, (run, answers) in runs.items():
        by_fine = difference_sq(answers, f, scene.weight) + blur_sq
        by_extrapolated = difference_sq(answers, 2 * f - q, scene.weight)
        truly = split_of(scene, answers, run.seeds).bias_sq
        yield method, truly, by_fine, by_extrapolated, (by_fine + by_extrapolated + blur_sq) / 2


def runs_with_most_hits(study, name):
    runs = {}
    for run, answers in study.runs(name):
        if run.method not in runs or run.hits_asked > runs[run.method][0].hits_asked:
            runs[run.method] = run, answers.astype(float)
    return runs


def table(study, name, fine, coarse):
    if name not in study.scenes:
        raise StudyError(f"the study has no scene {name}")
    runs = runs_with_most_hits(study, name)
    for method in (fine, coarse):
        if method not in runs:
            raise StudyError(f"the study has no {method} for {name}")
    if len({run.seeds for run, _ in runs.values()}) > 1 or len(runs[fine][0].seeds) < 2:
        raise StudyError("all methods need the same seeds, two of them at least")
    lines = ["| method | by the reference | by F, and its blur | by 2 F - Q | by fit |", "| --- | --- | --- | --- | --- |"]
    for method, *squares in rows_of(study.scenes[name], runs, fine, coarse):
        lines.append(" | ".join([f"| {method}", *(f"{1e4 * square:.1f}" for square in squares)]) + " |")
    return "\n".join(lines)


def main(arguments):
    try:
        print(table(Study(Path(arguments[0])), *arguments[1:]))
    except (StudyError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    return 0

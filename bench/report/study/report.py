"""Writes OUT/report.md, OUT/charts, OUT/images and OUT/summary.json from OUT/study.json: bench/report study OUT

Prints who reaches each target first, a line per scene.
"""

import json
import sys

from report.study.best_chart import best_against_time
from report.study.charts import error_against_bytes, error_against_hits, error_against_time, gather_against_hits
from report.study.curves import curves_of
from report.study.data import Study, StudyError
from report.study.findings import findings_of
from report.study.groups import GROUP_TITLES, groups
from report.study.images import picture_rows
from report.study.sections import markdown
from report.study.split_charts import bias_and_variance, error_by_tilt, time_split
from report.study.styles import Styles
from report.study.summary import summary
from report.study.targets import TARGETS, winners
from report.study.text import caption, seed_counts_text
from report.text import seconds_text


class Report:
    """One study with all that is derived from it."""

    def __init__(self, folder):
        self.study = Study(folder)
        self.curves = curves_of(self.study)
        self.findings = {scene: findings_of(curves) for scene, curves in self.curves.items()}
        names = [m for m in self.study.methods if any(m in curves for curves in self.curves.values())]
        methods = [self.study.method(name) for name in names]
        self.groups = groups(methods, self.curves)
        self.styles = Styles(methods)
        self.words = caption(self.study.context, seed_counts_text(self.curves))

    @property
    def folder(self):
        return self.study.folder


def charts(report):
    """Yields (file name without ending, title, sheet)."""
    study, curves, findings, styles, words = (
        report.study,
        report.curves,
        report.findings,
        report.styles,
        report.words,
    )
    title = "The least error within a time"
    yield "best", title, best_against_time(curves, title, words)
    main_groups = {group: names for group, names in report.groups.items() if group != "texels"}
    texels = report.groups.get("texels", [])
    for group, names in main_groups.items():
        title = f"Error against total time: {GROUP_TITLES[group]}"
        yield f"time-{group}", title, error_against_time(study, curves, findings, names, styles, title, words)
    for group, names in main_groups.items():
        title = f"Error against bytes of the finished map: {GROUP_TITLES[group]}"
        yield f"bytes-{group}", title, error_against_bytes(
            study, curves, findings, names, texels, styles, title, words
        )
    for group, names in report.groups.items():
        title = f"Error against hits: {GROUP_TITLES[group]}"
        yield f"hits-{group}", title, error_against_hits(study, curves, findings, names, styles, title, words)
    for group, names in report.groups.items():
        title = f"Bias² and variance against hits: {GROUP_TITLES[group]}"
        yield f"split-{group}", title, bias_and_variance(study, curves, names, title, words)
    every, title = [name for names in main_groups.values() for name in names], "Where the time goes"
    if every:
        yield "phases", title, time_split(curves, every, title, words)
    for group, names in main_groups.items():
        title = f"Gather time per point: {GROUP_TITLES[group]}"
        yield f"gather-{group}", title, gather_against_hits(study, curves, names, styles, title, words)
    title = "Error by tilt of the shading normal"
    if sheet := error_by_tilt(curves, styles, title, words):
        yield "tilt", title, sheet


def save_all(sheets, folder):
    """Saves and drops one sheet after the other; returns Markdown."""
    lines = []
    for name, title, sheet in sheets:
        sheet.save(folder / f"{name}.png")
        lines += [f"**{title}**", "", f"![{title}]({folder.name}/{name}.png)", ""]
    return lines


def winners_text(report, scene):
    def text(target):
        reaches = report.findings[scene].times[target]
        first = winners(reaches)
        return f"{100 * target:g} %: " + (
            f"{' = '.join(first)} {seconds_text(reaches[first[0]].cost)}" if first else "nobody"
        )

    return f"{scene}: " + "; ".join(text(target) for target in TARGETS)


def write(report):
    folder = report.folder
    chart_lines = save_all(charts(report), folder / "charts")
    image_lines = save_all(
        picture_rows(report.study, report.curves, report.groups.get("methods", []), report.words),
        folder / "images",
    )
    derived = summary(report.study, report.curves, report.findings, report.groups)
    (folder / "summary.json").write_text(
        json.dumps(derived, indent=1, allow_nan=False) + "\n", encoding="utf-8"
    )
    (folder / "report.md").write_text(markdown(report, chart_lines, image_lines), encoding="utf-8")


def main(arguments):
    try:
        report = Report(arguments[0])
        if not report.curves:
            raise StudyError(f"{report.folder} has no measured row")
    except StudyError as error:
        print(error, file=sys.stderr)
        return 2
    write(report)
    for scene in report.curves:
        print(winners_text(report, scene))
    print(f"\n{report.folder / 'report.md'}")
    return 0

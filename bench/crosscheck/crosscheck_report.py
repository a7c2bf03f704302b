"""crosscheck.md from the rows of crosscheck.json."""

from agreement import LARGEST_Z


def table(rows):
    lines = [
        "| scene | points | ours W/m^2 | Mitsuba W/m^2 | difference % | standard error % | z | z of R, G, B | rms z of points | rms z of regions "
        "| largest z of a region | verdict |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        channels = ", ".join(f"{z:+.2f}" for z in row["channel_z"])
        lines.append(
            f"| {row['scene']} | {row['points']} | {row['ours']:.5g} | {row['theirs']:.5g} | {100 * row['difference']:+.3f} "
            f"| {100 * row['standard_error']:.3f} | {row['z']:+.2f} | {channels} | {row['rms_z']:.2f} | {row['region_rms_z']:.2f} "
            f"| {row['region_z']:+.2f} of {row['region_z_bound']:.2f} | **{row['verdict']}** |"
        )
    return lines


def reference_table(rows):
    notes = ["commit", "date", "seed", "samples_per_pixel", "relative_error", "fingerprint"]
    lines = [f"| reference | {' | '.join(notes)} |", "|---" * (len(notes) + 1) + "|"]
    for row in rows:
        values = [row["reference"].get(f"shlmbench:{note}", "") for note in notes]
        lines.append(f"| {row['scene']} | {' | '.join(values)} |")
    return lines


def method_table(rows):
    lines = ["| scene | integrator | Russian roulette after | left out by both |", "|---|---|---|---|"]
    for row in rows:
        left_out = ", ".join(row["left_out"]) or "nothing"
        lines.append(f"| {row['scene']} | {row['integrator']} | {row['roulette_after_bounces']} bounces | {left_out} |")
    return lines


def markdown(document):
    rows = document["rows"]
    return "\n".join(
        [
            "# Our reference path tracer and Mitsuba 3",
            "",
            *table(rows),
            "",
            "Mean irradiance over the points that the camera sees. z is a difference over its standard error, from both renderers' variances.",
            f"A scene agrees if z, of all channels and of each, is within {LARGEST_Z:g}, and no region of 8 x 8 pixels passes its bound, which one",
            "in 370 right scenes does by accident. What is compared, and how: bench/crosscheck/README.md.",
            "",
            "## Paths that neither finds",
            "",
            *[f"- {row['scene']}: {row['paths_not_found']}" for row in rows],
            "",
            "## How this was made",
            "",
            *method_table(rows),
            "",
            *[f"- {key}: {value}" for key, value in document["context"].items()],
            "",
            *reference_table(rows),
            "",
        ]
    )

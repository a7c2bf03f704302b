"""The charts with all that belongs to them: choice of axes, filters, legend, table, and the data for the script."""

from dataclasses import asdict

from report.page.charts import COST, ERROR, Charts
from report.page.facets import FACETS, FIRST_FACETS, choices, facts_of
from report.page.markup import Markup, details, escaped, joined, tag
from report.page.measured import seeds_text
from report.page.quantities import COSTS, ERRORS, percent_text
from report.page.words import family_text, origin_text
from report.study.methods import LIGHT_MAP
from report.text import bytes_text, hits_text, number_text, seconds_text

COLUMNS = ("scene", "method", "hits", "seeds", "error", "95 % band", "bias", "noise", "FLIP", "time", "finished bytes", "working bytes")
EXPORTED = (  # to the script and its CSV
    "number", "scene", "method", "hits", "seeds", "error", "error_band", "bias", "bias_band", "noise", "noise_band", "flip", "seconds",
    "bytes", "working", "prepare_seconds", "hits_asked",
)


def pair(cost, error):
    return f"{cost.key}/{error.key}"


def front_finding(study, cost, error, numbers):
    """One sentence about one panel."""
    if not numbers:
        return f"No run has a measured {error.short}."
    rows = [study.rows[n] for n in numbers]
    light = sum(study.family(r.method) == LIGHT_MAP for r in rows)
    best = rows[-1]
    return (
        f"{light} of the {len(rows)} runs that no other beats are {family_text(LIGHT_MAP)}s; the least {error.short} is "
        f"{error.text(error.of(best))}, {best.method}, {cost.text(cost.of(best))}{' hits' * (cost.key == 'hits')}."
    )


def findings(charts):
    """cost/error -> scene -> sentence"""
    return {
        pair(cost, error): {scene: front_finding(charts.study, cost, error, numbers) for scene, numbers in charts.fronts[pair(cost, error)].items()}
        for cost in COSTS
        for error in ERRORS
    }


def options(quantities):
    return joined(tag("option", q.short, value=q.key) for q in quantities)


def axis_controls():
    return tag(
        "p",
        tag("label", "Show ", tag("select", options(ERRORS), id="y")),
        tag("label", " over ", tag("select", options(COSTS), id="x")),
        tag("button", "download these rows as CSV", id="csv", type="button"),
        cls="controls",
    )


def chip(facet, value, count):
    return tag("button", value, " ", tag("small", count), type="button", cls="chip", data_facet=facet, data_value=value, aria_pressed="false")


def filters(study, bright):
    """Chips with the number of runs behind them."""
    of_best = sum(row.method in bright for row in study.rows)
    lines = [
        tag(
            "p",
            tag("span", "show", cls="facet"),
            tag("button", "the best of each kind ", tag("small", of_best), type="button", cls="chip", id="best", aria_pressed="true"),
            tag("button", "all ", tag("small", len(study.rows)), type="button", cls="chip", id="all", aria_pressed="false"),
        )
    ]
    more = []
    for facet, values in choices(study).items():
        chips = [chip(facet, value, count) for value, count in values.items()]
        (lines if facet in FIRST_FACETS else more).append(tag("p", tag("span", FACETS[facet][0], cls="facet"), *chips))
    rest = details("more filters", *more) if more else None
    return tag("div", *lines, rest, cls="filters", role="group", aria_label="filters")


def legend(charts):
    """Every method; those that are grey have no entry."""
    names = sorted(charts.names, key=lambda name: name not in charts.bright)
    items = [
        tag("li", charts.swatch(name), " ", tag("span", name), data_method=charts.names.index(name), hidden=name not in charts.bright) for name in names
    ]
    return tag("ul", *items, cls="legend")


def panel(charts, scene, sentence):
    origin = f"{origin_text(charts.study.context)}, {seeds_text(charts.study.source)}"
    return tag(
        "figure",
        tag("figcaption", tag("h3", scene), tag("p", sentence, cls="finding")),
        charts.panel(scene),
        tag("p", f"Steps: the Pareto front of all runs. Dotted: how theory has the noise fall, from the largest run. {origin}.", cls="origin"),
        cls="chart",
        id=f"chart-{scene}",
    )


def measured_text(value):
    """Of an error: what is lost in the noise is not a number."""
    return "-" if value is None else percent_text(value) if value > 0 else "lost in noise"


def cells(row):
    band = " to ".join(percent_text(end) for end in row.error_band) if row.error_band else "one seed"
    return (
        row.scene, row.method, hits_text(row.hits), row.seeds, measured_text(row.error), band, measured_text(row.bias), measured_text(row.noise),
        number_text(row.flip), seconds_text(row.seconds), bytes_text(row.bytes), "-" if row.working is None else bytes_text(row.working),
    )


def rows_table(study):
    heads = joined(tag("th", name, scope="col", data_column=number) for number, name in enumerate(COLUMNS))
    body = "\n".join(f'<tr id="t{row.number}">' + "".join(f"<td>{escaped(cell)}" for cell in cells(row)) for row in study.rows)
    made = tag("table", tag("thead", tag("tr", heads)), tag("tbody", Markup(body)), id="rows")
    return tag("div", made, cls="scroll tall", tabindex="0", role="region", aria_label="all runs")


def section(charts):
    study = charts.study
    sentences = findings(charts)[pair(COST, ERROR)]
    figures = [panel(charts, scene, sentences[scene]) for scene in study.scenes]  # before the legend, which shows their marks
    scale = (
        "Filled marks are light maps, hollow ones photon maps; they are larger for more texels, more photons or a larger radius. Bars are 95 % bands over seeds. "
        "Both axes are logarithmic and the same for all scenes. Values below the axis lie on its lower edge."
    )
    return joined(
        [
            tag("p", scale, " Time is tracing, insertion, building and the search at all points; preparing a scene once is not in it."),
            tag("div", axis_controls(), filters(study, charts.bright), cls="script-only"),
            legend(charts),
            tag("div", id="pins", cls="pins script-only", aria_live="polite"),
            tag("div", *figures, cls="panels"),
            tag(
                "p",
                "Keys in a chart: arrows go from run to run (left and right by cost, up and down by error), Home and End to the ends, Enter pins a run; "
                "two pinned runs are compared. Escape unpins.",
                cls="script-only origin",
            ),
            details(f"The same {len(study.rows)} runs as a table", rows_table(study), open=True, id="table"),
        ]
    )


def data(charts: Charts):
    """For the script: rows by columns, methods with their facts, axes, fronts."""
    study, scales = charts.study, charts.scales
    values = [asdict(row) for row in study.rows]
    rounded = [[rounded_value(value[key]) for key in EXPORTED] for value in values]
    methods = [{"name": name, "facts": facts_of(study.kinds[name]), "best": name in charts.bright} for name in charts.names]
    return {
        "columns": EXPORTED,
        "rows": [[row[0], row[1], charts.names.index(row[2]), *row[3:]] for row in rounded],
        "methods": methods,
        "scenes": study.scenes,
        "facets": {key: title for key, (title, _) in FACETS.items()},
        "limits": scales.limits,
        "frame": {"left": scales.LEFT, "right": scales.WIDTH - scales.RIGHT, "top": scales.TOP, "bottom": scales.HEIGHT - scales.BOTTOM},
        "labels": {q.key: q.short for q in (*COSTS, *ERRORS)},
        "fronts": charts.fronts,
        "ghosts": charts.ghosts,
        "findings": findings(charts),
        "defaultTexels": study.setting_texels,
    }


def rounded_value(value):
    """Six digits are more than any measurement here has."""
    if isinstance(value, float):
        return float(f"{value:.6g}")
    return [rounded_value(v) for v in value] if isinstance(value, list) else value

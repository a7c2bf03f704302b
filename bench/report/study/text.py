"""What every chart and table of a study says of itself."""

from report.study.bootstrap import CONFIDENCE, RESAMPLES
from report.study.data import EPSILON_SHARE
from report.text import machine_text

METRIC = (
    "error = MSE - v_R: MSE is the mean over seeds, visible points and channels of (I - R)² / (R² + eps), R the "
    f"reference irradiance, eps = {EPSILON_SHARE:g} (mean R)²; v_R is the reference's own noise. Relative RMS = "
    "square root of the error"
)
BANDS = f"{100 * CONFIDENCE:.0f} % by bootstrap over seeds ({RESAMPLES} resamples, Student's t)"


def seed_counts_text(curves_by_scene):
    counts = {
        p.split.seed_count for curves in curves_by_scene.values() for c in curves.values() for p in c.points
    }
    if not counts:
        return "no seeds"
    few, many = min(counts), max(counts)
    return f"{many} seed{'s' * (many != 1)}" if few == many else f"{few} to {many} seeds"


def caption(context, seeds):
    """What every chart and table has to say of itself."""
    settings = context.get("settings", "")
    return (
        f"{METRIC}. {seeds}; bands: {BANDS}; a single seed has no band. {context.get('threads', '?')} threads"
        f"{', ' + str(settings) if settings else ''}. {machine_text(context)}."
    )

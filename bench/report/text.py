"""Numbers and provenance in words, the same in charts and tables."""

import math

NOTHING = "-"


def three_digits(value):
    """1234.5 -> '1230': no exponent where a unit follows."""
    return f"{float(f'{value:.3g}'):g}"


def count_text(number):
    """12345678 -> '12.3 M'"""
    for unit, name in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if number >= unit:
            return f"{three_digits(number / unit)} {name}"
    return f"{number:.3g}"


def is_number(value):
    return value is not None and math.isfinite(value)


def hits_text(hits):
    return count_text(hits).replace(" ", "\u00a0")


def number_text(value, digits=3):
    """Three digits, exponents without padding: 1.23e-4."""
    if not is_number(value):
        return NOTHING
    text = f"{value:.{digits}g}"
    if "e" in text:
        mantissa, exponent = text.split("e")
        text = f"{mantissa}e{int(exponent)}"
    return text


def band_text(value, band, digits=3):
    """1.23e-3 [1.1e-3, 1.4e-3]"""
    if not is_number(value):
        return NOTHING
    return number_text(value, digits) + (
        f" [{number_text(band[0], digits)}, {number_text(band[1], digits)}]" if band else ""
    )


def percent_text(error):
    """Relative RMS of a mean squared error: 0.0004 -> 2 %"""
    return f"{number_text(100 * math.sqrt(error))}\u00a0%" if is_number(error) and error > 0 else NOTHING


def share_text(share):
    """0.0123 -> 1.23 %"""
    return f"{number_text(100 * share)}\u00a0%" if is_number(share) else NOTHING


def seconds_text(seconds):
    if not is_number(seconds):
        return NOTHING
    return f"{three_digits(seconds)}\u00a0s" if seconds >= 1 else f"{number_text(1e3 * seconds)}\u00a0ms"


def bytes_text(count):
    for unit, name in ((2**40, "TiB"), (2**30, "GiB"), (2**20, "MiB"), (2**10, "KiB")):
        if count >= unit:
            return f"{three_digits(count / unit)}\u00a0{name}"
    return f"{count:.0f}\u00a0B"


def machine_text(context):
    libraries = context.get("libraries", {})
    known = [f"{context[key]}" for key in ("machine", "instruction_set", "compiler") if key in context]
    known += [f"{name} {version}" for name, version in libraries.items() if name in ("embree", "flann")]
    return ", ".join(known + [f"commit {context.get('commit', 'unknown')}"])

"""HTML from data: whatever is a plain string is escaped, so that no text of a result can become markup."""

import html
import json


class Markup(str):
    """Text that is HTML already."""


def escaped(part):
    return part if isinstance(part, Markup) else html.escape(str(part), quote=True)


def breakable(text):
    """A method's name, which lines may break behind a slash."""
    return Markup(escaped(text).replace("/", "/<wbr>"))


def joined(parts, between=""):
    return Markup(between.join(escaped(part) for part in parts if part is not None))


def attributes_text(attributes):
    """cls is class, data_x is data-x; True stands alone, False and None are left out."""
    made = []
    for name, value in attributes.items():
        name = "class" if name == "cls" else name.replace("_", "-")
        if value is True:
            made.append(f" {name}")
        elif value is not None and value is not False:
            made.append(f' {name}="{html.escape(str(value), quote=True)}"')
    return "".join(made)


VOID = {"img", "input", "br"}


def tag(name, *children, **attributes):
    start = f"<{name}{attributes_text(attributes)}>"
    return Markup(start if name in VOID else f"{start}{joined(children)}</{name}>")


def table(heads, rows, **attributes):
    """In a box of its own that scrolls. A cell is text or markup; end tags that HTML does without are left out."""
    head = joined(tag("th", head, scope="col") for head in heads)
    body = Markup("\n".join("<tr>" + "".join(f"<td>{escaped(cell)}" for cell in row) for row in rows))
    return scrolling(tag("table", tag("thead", tag("tr", head)), tag("tbody", body), **attributes), "table")


def scrolling(inner, label):
    return tag("div", inner, cls="scroll", tabindex="0", role="region", aria_label=label)


def details(summary, *children, **attributes):
    return tag("details", tag("summary", summary), *children, **attributes)


def link(target, *words):
    return tag("a", *words, href=target)


def script_json(value):
    """JSON that cannot end the script element it stands in, nor start a comment in it."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    for character in "<>&\u2028\u2029":
        text = text.replace(character, f"\\u{ord(character):04x}")
    return Markup(text)

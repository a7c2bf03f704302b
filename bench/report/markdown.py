"""Tables in Markdown."""


def table(heads, rows):
    """Lines. Cells are text."""
    return [
        "| " + " | ".join(heads) + " |",
        "|" + "---|" * len(heads),
        *("| " + " | ".join(row) + " |" for row in rows),
    ]


def table_text(heads, rows):
    return "\n".join(table(heads, rows)) + "\n"

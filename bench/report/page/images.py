"""Images beside the page. Each says its size, so that nothing moves when it arrives."""

from PIL import Image, UnidentifiedImageError

from report.page.markup import tag


def size_of(file):
    """(width, height); None twice for what is no image."""
    try:
        with Image.open(file) as image:
            return image.size
    except (OSError, UnidentifiedImageError):
        return None, None


def image(results, address, words):
    """`address`: from the page. Asked for when it comes into view."""
    width, height = size_of(results.out.parent / address)
    return tag("img", src=address, alt=words, width=width, height=height, loading="lazy", decoding="async")

"""How the results page looks, wide and narrow: page_pictures.py PAGE.html FOLDER writes FOLDER/page-1280.png and FOLDER/page-400.png, the tops of the page."""

import io
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from PIL import Image
from report.browser import Browser, find_browser

TOPS = {1280: 2600, 400: 3600}  # pixels of width -> of height: claims, chooser and on a wide window the first charts


def main(page, folder):
    folder.mkdir(parents=True, exist_ok=True)
    with Browser(find_browser()) as browser:
        for width, height in TOPS.items():
            browser.open(page.resolve().as_uri(), width=width)
            browser.evaluate("Promise.all([...document.images].map(i => { i.loading = 'eager'; return i.decode().catch(() => 0); }))")
            with Image.open(io.BytesIO(browser.picture())) as seen:
                top = seen.convert("RGB").crop((0, 0, width, min(height, seen.height)))
            top.quantize(48, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(folder / f"page-{width}.png", optimize=True)


if __name__ == "__main__":
    if len(sys.argv) != 3 or not find_browser():
        print("usage: page_pictures.py PAGE.html FOLDER, with chromium-headless-shell or chromium installed", file=sys.stderr)
        sys.exit(2)
    main(Path(sys.argv[1]), Path(sys.argv[2]))

"""How an exported page looks in each of its modes: viewer_pictures.py VIEWER.html OUT.png writes a sheet of them."""

import io
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from PIL import Image, ImageDraw
from report.browser import SOFTWARE_GRAPHICS, Browser, find_browser

WIDTH, HEIGHT, PANEL, COLUMNS = 288, 162, 350, 4
HARDWARE, TRADITIONAL = "fa=hardware", "a=1"
MODES = {
    "order 4, exact filter": "", "traditional light map": TRADITIONAL, "order 4 beside the traditional one": "split=0.5&b=1&fb=exact", "hardware filter": HARDWARE,
    "irradiance": "sa=1", "texels and chart borders": "sa=2", "hits": "sa=3", "clamped at zero": "sa=4", "filters differ": "sa=5", "normals": "sa=6",
    "all normals tilted by 40 degrees": "tilt=40", "normal maps off": "strength=0", "normal maps twice": "strength=2", "reference": "a=%3Dreference", "FLIP of the first": "a=!{first}",
}


def seen(browser, page, state, width, height):
    browser.open(page.resolve().as_uri() + "#" + state, width, height)
    browser.evaluate("window.shlmViewer.then(viewer => viewer.drawNow())")
    with Image.open(io.BytesIO(browser.picture(whole=False))) as picture:
        return picture.convert("RGB")


def save(picture, path):
    picture.quantize(64, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(path, optimize=True)


def main(page, out):
    sheet = Image.new("RGB", (COLUMNS * WIDTH, -(-len(MODES) // COLUMNS) * (HEIGHT + 18)), "white")
    pen = ImageDraw.Draw(sheet)
    with Browser(find_browser(), SOFTWARE_GRAPHICS) as browser:
        browser.open(page.resolve().as_uri(), 800, 400)
        first = browser.evaluate("window.shlmViewer.then(viewer => viewer.renderer.choices[0].map.method)")
        for number, (name, state) in enumerate(MODES.items()):
            left, top = number % COLUMNS * WIDTH, number // COLUMNS * (HEIGHT + 18)
            sheet.paste(seen(browser, page, state.format(first=first), 2 * WIDTH + PANEL, 2 * HEIGHT).crop((0, 0, 2 * WIDTH, 2 * HEIGHT)).resize((WIDTH, HEIGHT)), (left, top + 18))
            pen.text((left + 4, top + 3), name, fill="black")
        save(sheet, out)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))

"""A strip of small pictures of one scene: what a point receives by the reference and the methods, and how far they are off."""

import matplotlib.image
import numpy as np

SCALE, GAP = 2, 4  # screen pixels per point; between pictures
ERROR_RANGE = 0.25  # relative: as red or blue as can be
WORDS = (
    "reference, default light map, photon map (irradiance, one exposure); then the signed error of the light map and of the photon map, "
    f"relative to sqrt(R² + eps): red is too bright, blue too dark, at most {100 * ERROR_RANGE:.0f} %"
)


def write_strip(file, scene, size, light_map, photon_map):
    """`size`: (width, height) of the picture that scene.pixel counts in; the maps: points x 3, or None."""
    exposure = 1 / max(float(np.quantile(scene.reference, 0.98)), 1e-30)
    shown = [tone(values, exposure) for values in (scene.reference, light_map, photon_map) if values is not None]
    shown += [signed_error(scene, values) for values in (light_map, photon_map) if values is not None]
    pictures = [placed(colors, scene.pixel, size) for colors in shown]
    gap = np.ones((pictures[0].shape[0], GAP, 3))
    strip = [part for picture in pictures for part in (picture, gap)][:-1]
    file.parent.mkdir(parents=True, exist_ok=True)
    temporary = file.with_name(f".{file.name}")
    matplotlib.image.imsave(temporary, np.concatenate(strip, axis=1), format="png")
    temporary.replace(file)


def tone(values, exposure):
    return np.clip(values * exposure, 0, 1) ** (1 / 2.2)


def signed_error(scene, values):
    """Mean over the channels, white where there is none."""
    relative = ((values - scene.reference) * np.sqrt(scene.weight)).mean(axis=1) / ERROR_RANGE
    strength = np.clip(np.abs(relative), 0, 1)[:, None]
    full = np.where(relative[:, None] > 0, (0.8, 0.1, 0.1), (0.1, 0.2, 0.8))
    return 1 - strength * (1 - full)


def placed(colors, pixel, size):
    """height x width x 3, enlarged; grey where no surface is seen."""
    width, height = size
    picture = np.full((width * height, 3), 0.5)
    picture[pixel] = colors
    # Fewer values make smaller files, and nobody sees the difference.
    picture = np.round(picture.reshape(height, width, 3) * 63) / 63
    return np.kron(picture, np.ones((SCALE, SCALE, 1)))

"""Images of textures as numbers. A variant must be set before this module is imported."""

from functools import lru_cache

import mitsuba as mi
import numpy as np


def linear_of_srgb(encoded):
    """IEC 61966-2-1, for values in [0, 1]."""
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


@lru_cache(maxsize=2)
def linear_texels(image):
    """(height, width, 4) of the encoded bytes of an sRGB image; alpha, which is linear as it is, is 1 where it has none."""
    stream = mi.MemoryStream()
    stream.write(image)
    stream.seek(0)
    bitmap = mi.Bitmap(stream).convert(mi.Bitmap.PixelFormat.RGBA, mi.Struct.Type.UInt8, srgb_gamma=True)
    texels = np.array(bitmap) / 255.0
    texels[..., :3] = linear_of_srgb(texels[..., :3])
    return texels

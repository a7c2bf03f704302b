"""What Mitsuba's own textures leave open, as textures of its own. A variant must be set before this is imported.

"gltf_product": the product of two textures. "gltf_covered": 1 where a texture is at least a cutoff, else 0.
"gltf_wrapped": a texture whose coordinates are multiplied by a matrix and wrapped, each axis in a way of its own.
"gltf_emitted": a texture that does not say that it varies, so that lamps are sampled by area: Mitsuba would choose places in the
texture, of which a surface may show some twice and others not at all.
"""

import drjit as dr
import mitsuba as mi


class _OfTextures(mi.Texture):
    """Behaves as its parts together do."""

    names = ("of",)

    def __init__(self, properties):
        mi.Texture.__init__(self, properties)
        self.parts = [properties.get_unbounded_texture(name) for name in self.names]

    def eval(self, si, active=True):
        return self.value(si, active, lambda part, si, active: part.eval(si, active))

    def eval_1(self, si, active=True):
        return self.value(si, active, lambda part, si, active: part.eval_1(si, active))

    def eval_3(self, si, active=True):
        return self.value(si, active, lambda part, si, active: part.eval_3(si, active))

    def mean(self):
        return mi.Float(0.5)  # only ever decides how often a lobe is sampled

    def is_spatially_varying(self):
        return True

    def to_string(self):
        return type(self).__name__


class Product(_OfTextures):
    names = ("first", "second")

    def value(self, si, active, look_up):
        return look_up(self.parts[0], si, active) * look_up(self.parts[1], si, active)


class Covered(_OfTextures):
    def __init__(self, properties):
        super().__init__(properties)
        self.cutoff = properties["cutoff"]

    def value(self, si, active, look_up):
        return dr.select(look_up(self.parts[0], si, active) >= self.cutoff, mi.Float(1), mi.Float(0))


class Wrapped(_OfTextures):
    """`margin_u`, `margin_v`: half a texel. Nearer to the edge than that only the last texel is seen, or its mirror image."""

    def __init__(self, properties):
        super().__init__(properties)
        self.matrix = [properties[f"uv{i}"] for i in range(6)]
        self.axes = [(properties[f"wrap_{axis}"], properties[f"margin_{axis}"]) for axis in "uv"]

    def value(self, si, active, look_up):
        moved = mi.SurfaceInteraction3f(si)
        u, v, (a, b, c, d, e, f) = si.uv.x, si.uv.y, self.matrix
        moved.uv = mi.Point2f(_wrapped(a * u + b * v + c, *self.axes[0]), _wrapped(d * u + e * v + f, *self.axes[1]))
        return look_up(self.parts[0], moved, active)


def _wrapped(coordinate, wrap, margin):
    if wrap == "repeat":
        return coordinate
    if wrap == "mirror":
        coordinate = 1 - dr.abs(coordinate - 2 * dr.floor(coordinate / 2) - 1)
    return dr.clip(coordinate, margin, 1 - margin)


class Emitted(_OfTextures):
    def value(self, si, active, look_up):
        return look_up(self.parts[0], si, active)

    def is_spatially_varying(self):
        return False


for _name, _kind in {"product": Product, "covered": Covered, "wrapped": Wrapped, "emitted": Emitted}.items():
    mi.register_texture(f"gltf_{_name}", _kind)

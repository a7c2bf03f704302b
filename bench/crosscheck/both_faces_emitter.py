"""An area light that shines from both faces: Mitsuba's own has one. A variant must be set before this is imported."""

import drjit as dr
import mitsuba as mi

# The scalar variants name an emitter by itself.
_pointer = getattr(mi, "EmitterPtr", lambda emitter: emitter)


class BothFaces(mi.Emitter):
    def __init__(self, properties):
        mi.Emitter.__init__(self, properties)
        self.radiance = properties.get_emissive_texture("radiance")
        self.m_flags = mi.EmitterFlags.Surface

    def eval(self, si, active=True):
        return self.radiance.eval(si, active)

    def sample_direction(self, it, sample, active=True):
        place = self.get_shape().sample_direction(it, sample, active)
        active = active & (place.pdf > 0)
        place.emitter = _pointer(self)
        density = dr.select(active, place.pdf, 1)
        return place, dr.select(active, self.eval_direction(it, place, active) / density, 0)

    def pdf_direction(self, it, place, active=True):
        return self.get_shape().pdf_direction(it, place, active)

    def eval_direction(self, it, place, active=True):
        return self.radiance.eval(mi.SurfaceInteraction3f(place, it.wavelengths), active)

    def to_string(self):
        return "BothFaces"


mi.register_emitter("gltf_both_faces", BothFaces)

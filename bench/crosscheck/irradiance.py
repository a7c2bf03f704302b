"""Irradiance at surface points by Mitsuba's path tracer. A variant must be set before this module is imported."""

from dataclasses import dataclass

import drjit as dr
import mitsuba as mi
import numpy as np

from points import lanes, mean_at

# Layers that light may come straight through on its way.
_MOST_LAYERS = 1000


@dataclass(frozen=True)
class Estimate:
    """(points, 3) each: W/m^2 per colour channel, and the variance of that mean."""

    irradiance: np.ndarray
    variance: np.ndarray


@dataclass(frozen=True)
class Method:
    """How Mitsuba traces."""

    see_through: bool = False  # whether anything lets light pass as it comes
    roulette_depth: int = 5  # bounces before chance may end a path

    @property
    def integrator(self):
        """Past holes and thin sheets only `volpath` finds lights by straight lines, and `path` weighs the surfaces round
        holes wrongly."""
        return "volpath" if self.see_through else "path"


def estimate_irradiance(scene, points, batches, samples_per_batch, seed, method=Method(), report=lambda batch: None):
    """E = integral over directions w with n_geometric.w > 0 of L_in(w) max(0, n_shading.w) dw.

    The variance is that of the mean over independent batches, each with a seed of its own."""
    integrator = mi.load_dict(
        {"type": method.integrator, "max_depth": -1, "rr_depth": method.roulette_depth, "hide_emitters": False}
    )
    sampler = mi.load_dict({"type": "independent"})

    def sample(position, shading_normal, geometric_normal):
        # Mitsuba moves the origin of rays off the surface by itself, along the interaction's normal.
        point = mi.Interaction3f(0, 0, dr.zeros(mi.Color0f), position, geometric_normal)
        return _lit_by_emitters(scene, sampler, point, shading_normal, method) + _lit_by_surfaces(
            scene, integrator, sampler, point, shading_normal, method
        )

    mean, square_sum = np.zeros((len(points), 3)), np.zeros((len(points), 3))
    for batch in range(batches):
        sampler.seed(seed * batches + batch, lanes(points, samples_per_batch))
        value = mean_at(points, samples_per_batch, sample)
        step = value - mean
        mean += step / (batch + 1)
        square_sum += step * (value - mean)
        report(batch + 1)
    if not np.isfinite(square_sum).all():
        raise ArithmeticError("Mitsuba gave irradiances that are not finite")
    return Estimate(mean, square_sum / (batches - 1) / batches)


# Emitters that the point sees are found by both of the following, weighted by the balance heuristic (Veach and Guibas 1995):
# close to a large panel sampling its area alone has a variance that no number of samples reveals.


def _lit_by_emitters(scene, sampler, point, shading_normal, method):
    """By sampled places on emitters."""
    solid = not method.see_through
    sample, radiance_over_density = scene.sample_emitter_direction(point, sampler.next_2d(), solid)
    cosine = dr.maximum(dr.dot(shading_normal, sample.d), 0)
    is_above = (dr.dot(point.n, sample.d) > 0) & (cosine > 0)
    if not solid:
        radiance_over_density *= _passed(scene, point.spawn_ray_to(sample.p), is_above & (sample.pdf > 0))
    share = dr.select(sample.delta, 1, _share(sample.pdf, cosine / dr.pi))
    return dr.select(is_above, radiance_over_density * cosine * share, 0)


# Masks are not changed in place (&=): they would change for the caller as well.


def _passed(scene, ray, active):
    """Part of the light that comes through all surfaces along `ray` as it is."""
    passed, end = mi.Color3f(1), ray(ray.maxt)
    for _ in range(_MOST_LAYERS):
        surface = scene.ray_intersect(mi.Ray3f(ray), active)
        active = active & surface.is_valid()
        if not dr.any(active):
            break
        passed = dr.select(active, passed * surface.bsdf().eval_null_transmission(surface, active), passed)
        active = active & (dr.max(passed) > 0)
        ray = surface.spawn_ray_to(end)
    return passed


def _lit_by_surfaces(scene, integrator, sampler, point, shading_normal, method):
    """By what is seen in cosine-distributed directions. Emitters in a mirror or behind glass have no other way to be found
    and count in full."""
    local = mi.warp.square_to_cosine_hemisphere(sampler.next_2d())
    direction = mi.Frame3f(shading_normal).to_world(local)
    is_above = dr.dot(point.n, direction) > 0
    ray = mi.RayDifferential3f(point.spawn_ray(direction))
    radiance, _, _ = integrator.sample(scene, sampler, ray, None, is_above)
    counted_already = _share_of_emitter_sampling(scene, point, ray, local.z / dr.pi, is_above, method)
    return dr.select(is_above, (radiance - counted_already) * dr.pi, 0)


def _share_of_emitter_sampling(scene, point, ray, density, active, method):
    """Of what the first surface along `ray` emits, which was sampled with `density` per steradian; and of what those behind it
    do, as far as their light comes through as it is."""
    share, passed = mi.Color3f(0), mi.Color3f(1)
    for _ in range(_MOST_LAYERS if method.see_through else 1):
        surface = scene.ray_intersect(mi.Ray3f(ray), active)
        share += dr.select(active, passed * _share_of_emitted(scene, point, surface, density, active), 0)
        active = active & surface.is_valid()
        if not method.see_through or not dr.any(active):
            break
        passed = dr.select(active, passed * surface.bsdf().eval_null_transmission(surface, active), passed)
        active = active & (dr.max(passed) > 0)
        ray = surface.spawn_ray(ray.d)
    return share


def _share_of_emitted(scene, point, surface, density, active):
    emitter = surface.emitter(scene, active)
    if emitter is None:  # in the scalar variants only; elsewhere a missing emitter emits zero
        return mi.Color3f(0)
    seen = mi.DirectionSample3f(scene, surface, point)
    other_density = scene.pdf_emitter_direction(point, seen, active)
    return emitter.eval(surface, active) * _share(other_density, density)


def _share(density, other_density):
    """Zero where both are, as for emitters that are hidden."""
    return density / dr.maximum(density + other_density, 1e-30)

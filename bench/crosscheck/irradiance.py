"""Irradiance at surface points by Mitsuba's path tracer. A variant must be set before this module is imported."""

from dataclasses import dataclass

import drjit as dr
import mitsuba as mi
import numpy as np

from points import lanes, mean_at


@dataclass(frozen=True)
class Estimate:
    """(points, 3) each: W/m^2 per colour channel, and the variance of that mean."""

    irradiance: np.ndarray
    variance: np.ndarray


def estimate_irradiance(scene, points, batches, samples_per_batch, seed, report=lambda batch: None):
    """E = integral over directions w with n_geometric.w > 0 of L_in(w) max(0, n_shading.w) dw.

    The variance is that of the mean over independent batches, each with a seed of its own."""
    integrator = mi.load_dict({"type": "path", "max_depth": -1, "hide_emitters": False})
    sampler = mi.load_dict({"type": "independent"})

    def sample(position, shading_normal, geometric_normal):
        # Mitsuba moves the origin of rays off the surface by itself, along the interaction's normal.
        point = mi.Interaction3f(0, 0, dr.zeros(mi.Color0f), position, geometric_normal)
        return _lit_by_emitters(scene, sampler, point, shading_normal) + _lit_by_surfaces(
            scene, integrator, sampler, point, shading_normal
        )

    mean, square_sum = np.zeros((len(points), 3)), np.zeros((len(points), 3))
    for batch in range(batches):
        sampler.seed(seed * batches + batch, lanes(points, samples_per_batch))
        value = mean_at(points, samples_per_batch, sample)
        step = value - mean
        mean += step / (batch + 1)
        square_sum += step * (value - mean)
        report(batch + 1)
    return Estimate(mean, square_sum / (batches - 1) / batches)


def _lit_by_emitters(scene, sampler, point, shading_normal):
    """By emitters that the point sees."""
    sample, radiance_over_density = scene.sample_emitter_direction(point, sampler.next_2d(), True)
    is_above = dr.dot(point.n, sample.d) > 0
    cosine = dr.maximum(dr.dot(shading_normal, sample.d), 0)
    return dr.select(is_above, radiance_over_density * cosine, 0)


def _lit_by_surfaces(scene, integrator, sampler, point, shading_normal):
    """By everything else, in cosine-distributed directions. What the first surface emits is left out: the point sees it.
    What is seen in a mirror or through glass stays, as emitter sampling cannot find it."""
    local = mi.warp.square_to_cosine_hemisphere(sampler.next_2d())
    direction = mi.Frame3f(shading_normal).to_world(local)
    is_above = dr.dot(point.n, direction) > 0
    ray = mi.RayDifferential3f(point.spawn_ray(direction))
    radiance, _, _ = integrator.sample(scene, sampler, ray, None, is_above)
    emitted = _emitted_by_first_surface(scene, ray, is_above)
    return dr.select(is_above, (radiance - emitted) * dr.pi, 0)


def _emitted_by_first_surface(scene, ray, active):
    surface = scene.ray_intersect(ray, active)
    emitter = surface.emitter(scene, active)
    # Only the scalar variants have None; elsewhere a missing emitter evaluates to zero.
    return mi.Color3f(0) if emitter is None else emitter.eval(surface, active)

"""Writes a study whose errors are known: each method has a law for its variance, bias, time and bytes.

The answer of seed i at a point is R + sqrt(R^2 + eps) (bias pattern + sqrt(variance) z_i), so that the
relative variance is `variance` and the relative squared bias `bias_sq`, as the pattern has a mean square of
one. The reference on disk is noisy, as in life.
"""

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

import numpy as np
from known_methods import facts_of

WIDTH, HEIGHT = 128, 72
REFERENCE_VARIANCE = 1e-6  # v_R

CONTEXT = {
    "machine": "synthetic",
    "instruction_set": "AVX2",
    "cores": 2,
    "memory_bytes": 8e9,
    "compiler": "none",
    "flags": "",
    "libraries": {"embree": "3.13", "flann": "1.9"},
    "commit": "0123456789ab",
    "built": "never",
    "date": "never",
    "threads": 2,
    "settings": "synthetic laws",
    "image": [WIDTH, HEIGHT],
}


@dataclass(frozen=True)
class Law:
    """Functions of the hits; relative squares, seconds, bytes."""

    variance: Callable
    bias_sq: Callable
    seconds: Callable = lambda hits: 1e-6 * hits
    gather_seconds: Callable = lambda hits: 0.01
    bytes: Callable = lambda hits: 32e6
    texels: int = 0
    follows_tilt: bool = False  # the bias is where the shading normal is bent


@dataclass(frozen=True)
class Plan:
    methods: dict  # name -> Law
    scenes: tuple = ("cornell",)
    sizes: tuple = (10_000, 100_000, 1_000_000, 10_000_000)
    seeds: int = 8
    points: int = 600
    seeds_of: Callable = None  # (method, hits) -> number of seeds, where not all are there
    has_pictures: bool = False
    tilted: tuple = field(default=("bumpy",))


@dataclass(frozen=True)
class Truth:
    reference: np.ndarray
    epsilon: float
    pattern: np.ndarray
    tilted_pattern: np.ndarray
    pixel: np.ndarray


def write_array(path, values, kind="<f4"):
    path.parent.mkdir(parents=True, exist_ok=True)
    np.asarray(values).astype(kind).tofile(path)


def smooth_irradiance(pixel):
    x, y = (pixel % WIDTH) / WIDTH, (pixel // WIDTH) / HEIGHT
    level = 1.2 + np.sin(5 * x) * np.cos(4 * y) + 2 * np.exp(-40 * ((x - 0.6) ** 2 + (y - 0.4) ** 2))
    return level[:, None] * np.array([1.0, 0.9, 0.75])


def write_scene(folder, name, plan, generator):
    pixel = np.sort(generator.choice(WIDTH * HEIGHT, plan.points, replace=False))
    reference = smooth_irradiance(pixel)
    epsilon = 0.01 * np.mean(reference) ** 2
    scale_sq = reference**2 + epsilon
    tilt = generator.uniform(0, 66, plan.points) if name in plan.tilted else np.zeros(plan.points)
    raw = folder / "raw" / name
    write_array(
        raw / "reference.f32",
        reference + np.sqrt(REFERENCE_VARIANCE * scale_sq) * generator.normal(size=reference.shape),
    )
    write_array(raw / "variance.f32", REFERENCE_VARIANCE * scale_sq)
    write_array(raw / "tilt.f32", tilt)
    write_array(raw / "pixel.u32", pixel, "<u4")
    pattern = np.where(generator.uniform(size=reference.shape) < 0.5, -1.0, 1.0)
    bent = np.maximum(tilt, 1e-3)[:, None] ** 1.5
    return Truth(reference, epsilon, pattern, pattern * bent / np.sqrt(np.mean(bent**2)), pixel)


def answers_of(law, truth, hits, generator):
    pattern = truth.tilted_pattern if law.follows_tilt else truth.pattern
    noise = generator.normal(size=truth.reference.shape)
    deviation = np.sqrt(law.bias_sq(hits)) * pattern + np.sqrt(law.variance(hits)) * noise
    return truth.reference + np.sqrt(truth.reference**2 + truth.epsilon) * deviation


def picture(truth, values):
    image = np.zeros((HEIGHT * WIDTH, 3))
    image[truth.pixel] = np.clip(values / 4, 0, 1) ** (1 / 2.2)
    return image.reshape(HEIGHT, WIDTH, 3)


def write_pictures(path, truth, values):
    import matplotlib.image

    matplotlib.image.imsave(path.with_suffix(".png"), picture(truth, values))
    error = np.abs(values - truth.reference) / truth.reference.mean()
    matplotlib.image.imsave(path.with_name(path.name + "-flip.png"), picture(truth, 4 * error))


def row_of(scene, method, law, hits, seed, path, generator):
    jitter = generator.uniform(0.97, 1.03)
    return {
        "scene": scene,
        **facts_of(method),
        "texels": law.texels,
        "hits_asked": hits,
        "hits": hits,
        "seed": seed,
        "photons_emitted": hits // 3,
        "trace_seconds": 0.6 * law.seconds(hits) * jitter,
        "insert_seconds": 0.1 * law.seconds(hits) * jitter,
        "build_seconds": 0.3 * law.seconds(hits) * jitter,
        "gather_seconds": law.gather_seconds(hits) * jitter,
        "bytes": law.bytes(hits),
        "prepare_seconds": 0.25,
        "prepare_bytes": 3 * 2**20,
        "insert_bytes": 2 * law.bytes(hits),
        "hits_rejected": 0,
        **({"flip": np.sqrt(law.variance(hits) + law.bias_sq(hits))} if seed == 1 else {}),
        "answers": path,
    }


def write_study(folder, plan, random_seed=1):
    """Writes the folder; returns scene -> Truth."""
    folder, generator, rows, truths = Path(folder), np.random.default_rng(random_seed), [], {}
    for scene in plan.scenes:
        truth = truths[scene] = write_scene(folder, scene, plan, generator)
        if plan.has_pictures:
            import matplotlib.image

            matplotlib.image.imsave(folder / "raw" / scene / "reference.png", picture(truth, truth.reference))
        for method, law in plan.methods.items():
            for hits in plan.sizes:
                for seed in range(1, (plan.seeds_of(method, hits) if plan.seeds_of else plan.seeds) + 1):
                    path = f"raw/{scene}/{method.replace('/', '-')}/{hits}-{seed}.f32"
                    values = answers_of(law, truth, hits, generator)
                    write_array(folder / path, values)
                    rows.append(row_of(scene, method, law, hits, seed, path, generator))
                    if plan.has_pictures and seed == 1:
                        write_pictures(folder / Path(path).with_name(f"{hits}"), truth, values)
    entries = {
        s: {
            "points": plan.points,
            "raw": f"raw/{s}",
            "reference": f"{s}.exr",
            "reference_error": REFERENCE_VARIANCE**0.5,
        }
        for s in plan.scenes
    }
    write_json(folder, rows, entries)
    return truths


def write_json(folder, rows, entries):
    document = {"context": CONTEXT, "scenes": entries, "rows": rows}
    (Path(folder) / "study.json").write_text(json.dumps(document), encoding="utf-8")

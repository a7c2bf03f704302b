"""Scenes that others made: which files of a folder to measure, and who is to be credited for them."""

import json
import re
import shlex
import struct
from dataclasses import dataclass, field
from pathlib import Path

from report.study.data import StudyError

ENDINGS = (".gltf", ".glb")
SKIPPED_FOLDER = "hostile"  # files that are broken on purpose
LIST = "scenes.txt"
LIGHT_OPTIONS, CAMERA_OPTIONS = ("--sky", "--sun"), ("--camera",)
CREDIT_KEYS = {"title": "title", "author": "author", "source": "source", "licence": "licence", "license": "licence"}
# A line that names somebody: "Copyright (c) 2020 ...", "... by Ann Example", "Donated by ...".
HOLDER = r"^.*(?:[Cc]opyright (?:\([Cc]\)|©)? ?\d{4}|\bby [A-Z][\w.-]+ [A-Z]|[Dd]onated by [A-Z]).*$"
JSON_CHUNK = 0x4E4F534A


@dataclass(frozen=True)
class FoundScene:
    name: str  # of its own among all, and fit for a file's name
    file: Path
    options: tuple = ()  # --sky, --sun and --camera with their values
    credit: dict = field(default_factory=dict)  # title, author, source, licence: what is known of them


def find_scenes(folder):
    """(scenes to measure, files without light), both in order. Of X.gltf and X.lit.gltf the second is taken.

    FOLDER/scenes.txt, if there, has lines of a file and its options, such as "hall/hall.glb --sky 1,1,1"; its files come with that
    light and camera. Raises StudyError with one line for a folder or list that is of no use."""
    folder = Path(folder)
    if not folder.is_dir():
        raise StudyError(f"{folder} is no folder")
    options = read_list(folder)
    files = [f for f in sorted(folder.rglob("*")) if f.suffix.lower() in ENDINGS and f.is_file()]
    files = [f for f in files if SKIPPED_FOLDER not in f.relative_to(folder).parts[:-1]]
    files = [f for f in files if f in options or not has_lit_copy(f, files)]
    dark = [f for f in files if f not in options and not has_light(f)]
    names = names_of([f for f in files if f not in dark], folder)
    scenes = [FoundScene(name, f, options.get(f, ()), credit_of(f.parent)) for f, name in names.items()]
    if not scenes:
        raise StudyError(f"{folder} has no glTF scene with light in it")
    return scenes, dark


def read_list(folder):
    """{file: options}"""
    try:
        lines = (folder / LIST).read_text(encoding="utf-8").splitlines()
    except FileNotFoundError:
        return {}
    except (OSError, ValueError) as error:
        raise StudyError(f"{folder / LIST} cannot be read: {error}") from error
    found = {}
    for number, line in enumerate(lines, 1):
        try:
            words = shlex.split(line, comments=True)
        except ValueError as error:
            raise StudyError(f"{folder / LIST}, line {number}: {error}") from error
        if not words:
            continue
        file, options = folder / words[0], tuple(words[1:])
        if not file.is_file():
            raise StudyError(f"{folder / LIST}, line {number}: there is no {words[0]}")
        if len(options) % 2 or any(o not in LIGHT_OPTIONS + CAMERA_OPTIONS for o in options[::2]):
            raise StudyError(f"{folder / LIST}, line {number}: options are --sky, --sun and --camera with a value each")
        found[file] = options
    return found


def has_lit_copy(file, files):
    return not file.stem.endswith(".lit") and any(file.with_name(f"{file.stem}.lit{e}") in files for e in ENDINGS)


def has_light(file):
    """Whether the file says so; true where it cannot be read, so that the reason shows later."""
    document = document_of(file)
    if document is None:
        return True
    try:
        materials, extensions = document.get("materials", []), document.get("extensions", {})
        emits = any(max(m.get("emissiveFactor", [0])) > 0 and "KHR_materials_unlit" not in m.get("extensions", {}) for m in materials)
        return emits or bool(extensions.get("KHR_lights_punctual", {}).get("lights"))
    except (AttributeError, TypeError, ValueError):
        return True


def document_of(file):
    """The JSON of a .gltf or .glb file; None where there is none."""
    try:
        with open(file, "rb") as stream:
            start = stream.read(20)
            if start[:4] == b"glTF":
                length, kind = struct.unpack_from("<II", start, 12)
                return json.loads(stream.read(length)) if kind == JSON_CHUNK else None
            return json.loads(start + stream.read())
    except (OSError, ValueError, struct.error):
        return None


def names_of(files, folder):
    """{file: name}: the file's own where no other has it, else its path."""
    stems = [file.stem for file in files]
    paths = ["-".join(file.relative_to(folder).with_suffix("").parts) for file in files]
    names = {}
    for file, stem, path in zip(files, stems, paths):
        name = stem if stems.count(stem) == 1 else path if paths.count(path) == 1 else path + file.suffix
        names[file] = re.sub(r"[^\w.-]", "_", name)
    return names


def credit_of(folder):
    """From NOTE.md and the licence texts beside a scene, whatever their form."""
    names = sorted(folder.iterdir(), key=lambda f: (f.name != "NOTE.md", f.name))
    texts = [text_of(f) for f in names if re.search(r"^note|licen[cs]e|copying", f.name, re.IGNORECASE) and f.is_file()]
    credit = {}
    for text in texts:
        for key, value in re.findall(r"^[\s*#-]*(\w+)[ \w]*:[ \t]*(\S.*)$", text, re.MULTILINE):
            if key.lower() in CREDIT_KEYS:
                credit.setdefault(CREDIT_KEYS[key.lower()], plain(value))
    if "author" not in credit:
        holders = [plain(line) for text in texts for line in re.findall(HOLDER, text, re.MULTILINE)]
        if holders:
            credit["author"] = holders[0]
    return credit


def text_of(file):
    try:
        return file.read_text(encoding="utf-8", errors="replace")[:100_000]
    except OSError:
        return ""


def plain(text, longest=200):
    """One line for a table."""
    text = re.sub(r"\s+", " ", text.replace("|", "/").replace("`", "").strip(" \\"))
    return text if len(text) <= longest else text[: longest - 3] + "..."

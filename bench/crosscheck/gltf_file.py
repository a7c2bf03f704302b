"""A binary glTF file: its JSON and the arrays and images that the JSON points at (glTF 2.0, section 4.4)."""

import base64
import json
import struct
from pathlib import Path

import numpy as np

from input_error import InputError

_JSON_CHUNK, _BINARY_CHUNK = 0x4E4F534A, 0x004E4942
_COMPONENT = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
_WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class GlbFile:
    """The document of FILE, and the bytes behind it. Sparse accessors and external files are refused."""

    def __init__(self, file):
        self.name = Path(file).name
        chunks = _chunks(file)
        self.document = json.loads(chunks[_JSON_CHUNK])
        self._binary = chunks.get(_BINARY_CHUNK, b"")

    def refuse(self, what):
        raise InputError(f"{self.name}: {what}")

    def list_of(self, name):
        return self.document.get(name, [])

    def array(self, accessor_index):
        """(count, width) array of an accessor in its own type; normalised integers as floats."""
        accessor = self.document["accessors"][accessor_index]
        if "sparse" in accessor or "bufferView" not in accessor:
            self.refuse(f"accessors/{accessor_index} is sparse, which is not converted")
        view = self.document["bufferViews"][accessor["bufferView"]]
        component = np.dtype(_COMPONENT[accessor["componentType"]])
        width = _WIDTH[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", width * component.itemsize)
        strides = (stride, component.itemsize)
        values = np.ndarray((accessor["count"], width), component, self._binary, start, strides)
        if accessor.get("normalized"):
            return np.maximum(values / np.float32(np.iinfo(component).max), np.float32(-1))
        return values

    def image(self, image_index):
        """The encoded bytes of an image."""
        image = self.document["images"][image_index]
        if "bufferView" in image:
            view = self.document["bufferViews"][image["bufferView"]]
            start = view.get("byteOffset", 0)
            return self._binary[start : start + view["byteLength"]]
        if not image["uri"].startswith("data:"):
            self.refuse(f"images/{image_index} is a file of its own, which is not converted")
        return base64.b64decode(image["uri"].partition(",")[2])


def _chunks(file):
    try:
        data = Path(file).read_bytes()
    except OSError as error:
        raise InputError(f"{file}: cannot be read: {error.strerror}") from error
    if data[:4] != b"glTF":
        raise InputError(f"{file}: not a binary glTF file")
    chunks, at = {}, 12
    while at + 8 <= len(data):
        length, kind = struct.unpack_from("<II", data, at)
        chunks[kind] = data[at + 8 : at + 8 + length]
        at += 8 + length
    if _JSON_CHUNK not in chunks:
        raise InputError(f"{file}: has no JSON chunk")
    return chunks

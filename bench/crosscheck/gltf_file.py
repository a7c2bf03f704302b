"""A glTF file, .gltf or .glb: its JSON and the arrays and images that the JSON points at (glTF 2.0, section 3.6)."""

import base64
import binascii
import json
import struct
from pathlib import Path
from urllib.parse import unquote

import numpy as np

from input_error import InputError

_JSON_CHUNK, _BINARY_CHUNK = 0x4E4F534A, 0x004E4942
_COMPONENT = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
_WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class GltfFile:
    """The document of FILE, and the bytes behind it."""

    def __init__(self, file):
        self.path = Path(file)
        self.document, self._binary = _contents(self.path)
        self._buffers = {}

    def refuse(self, what):
        raise InputError(f"{self.path.name}: {what}")

    def list_of(self, name):
        return self.document.get(name, [])

    def array(self, accessor_index):
        """(count, width) array of an accessor in its own type; normalised integers as floats."""
        accessor = self.document["accessors"][accessor_index]
        component = np.dtype(_COMPONENT[accessor["componentType"]])
        shape = (accessor["count"], _WIDTH[accessor["type"]])
        values = np.zeros(shape, component)  # what an accessor without bytes of its own is made of
        if "bufferView" in accessor:
            values = self._view(accessor, shape, component)
        if "sparse" in accessor:
            values = self._with_sparse_values(values.copy(), accessor["sparse"])
        if accessor.get("normalized"):
            return np.maximum(values / np.float32(np.iinfo(component).max), np.float32(-1))
        return values

    def image(self, image_index):
        """The encoded bytes of an image."""
        image = self.document["images"][image_index]
        if "bufferView" in image:
            return self._bytes_of_view(image["bufferView"])
        return self._bytes_of_uri(image["uri"])

    def _with_sparse_values(self, values, sparse):
        index_type = np.dtype(_COMPONENT[sparse["indices"]["componentType"]])
        indices = self._view(sparse["indices"], (sparse["count"], 1), index_type)
        values[indices[:, 0]] = self._view(sparse["values"], (sparse["count"], values.shape[1]), values.dtype)
        return values

    def _view(self, place, shape, component):
        """`place`: has bufferView and byteOffset."""
        view = self.document["bufferViews"][place["bufferView"]]
        stride = view.get("byteStride", shape[1] * component.itemsize)
        data = self._bytes_of_view(place["bufferView"])
        return np.ndarray(shape, component, data, place.get("byteOffset", 0), (stride, component.itemsize))

    def _bytes_of_view(self, view_index):
        view = self.document["bufferViews"][view_index]
        start, data = view.get("byteOffset", 0), self._buffer(view["buffer"])
        if start < 0 or start + view["byteLength"] > len(data):
            self.refuse(f"bufferViews/{view_index} ends behind its buffer")
        return data[start : start + view["byteLength"]]

    def _buffer(self, index):
        if index not in self._buffers:
            buffer = self.document["buffers"][index]
            self._buffers[index] = memoryview(self._bytes_of_uri(buffer["uri"]) if "uri" in buffer else self._binary)
        return self._buffers[index]

    def _bytes_of_uri(self, uri):
        """Of a data URI, or of a file beside this one."""
        if uri.startswith("data:"):
            head, _, body = uri.partition(",")
            try:
                return base64.b64decode(body, validate=True) if head.endswith(";base64") else unquote(body).encode("latin-1")
            except (binascii.Error, UnicodeEncodeError) as error:
                self.refuse(f"a data URI cannot be decoded: {error}")
        try:
            return (self.path.parent / unquote(uri)).read_bytes()
        except OSError as error:
            self.refuse(f"{uri} cannot be read: {error.strerror}")


def _contents(path):
    """(document, binary chunk)"""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from error
    chunks = _chunks(data) if data[:4] == b"glTF" else {_JSON_CHUNK: data}
    try:
        document = json.loads(chunks[_JSON_CHUNK])
    except (KeyError, ValueError) as error:
        raise InputError(f"{path}: has no JSON that can be read") from error
    if not isinstance(document, dict) or "asset" not in document:
        raise InputError(f"{path}: is not glTF")
    return document, chunks.get(_BINARY_CHUNK, b"")


def _chunks(data):
    chunks, at = {}, 12
    while at + 8 <= len(data):
        length, kind = struct.unpack_from("<II", data, at)
        chunks.setdefault(kind, data[at + 8 : at + 8 + length])
        at += 8 + length
    return chunks

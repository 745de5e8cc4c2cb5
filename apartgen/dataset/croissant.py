"""Metadata of a data set in Croissant 1.0, by which search engines and loaders know its files and fields."""

import hashlib
from pathlib import Path
from typing import Any

from apartgen.dataset.store import HOMES, MANIFEST, Store
from apartgen.version import __version__

_CONTEXT = {
    "@language": "en", "@vocab": "https://schema.org/", "sc": "https://schema.org/",
    "cr": "http://mlcommons.org/croissant/", "dct": "http://purl.org/dc/terms/", "citeAs": "cr:citeAs",
    "column": "cr:column", "conformsTo": "dct:conformsTo", "data": {"@id": "cr:data", "@type": "@json"},
    "dataType": {"@id": "cr:dataType", "@type": "@vocab"}, "examples": {"@id": "cr:examples", "@type": "@json"},
    "extract": "cr:extract", "field": "cr:field", "fileProperty": "cr:fileProperty", "fileObject": "cr:fileObject",
    "fileSet": "cr:fileSet", "format": "cr:format", "includes": "cr:includes", "isLiveDataset": "cr:isLiveDataset",
    "jsonPath": "cr:jsonPath", "key": "cr:key", "md5": "cr:md5", "parentField": "cr:parentField", "path": "cr:path",
    "recordSet": "cr:recordSet", "references": "cr:references", "regex": "cr:regex", "repeated": "cr:repeated",
    "replace": "cr:replace", "separator": "cr:separator", "source": "cr:source", "subField": "cr:subField",
    "transform": "cr:transform",
}
_COLUMNS = {"id": "sc:Text", "prompt": "sc:Text", "seed": "sc:Integer", "split": "sc:Text", "area": "sc:Float",
            "certified": "sc:Boolean", "signature": "sc:Text", "shard": "sc:Text", "sha256": "sc:Text",
            "error": "sc:Text"}


def metadata(store: Store) -> dict[str, Any]:
    """The metadata as JSON-LD."""
    made = sum("shard" in row for row in store.rows())
    return {
        "@context": _CONTEXT, "@type": "sc:Dataset", "name": store.folder.resolve().name,
        "description": f"{made} furnished apartments made by apartgen {__version__}, each drawn from its prompt.",
        "conformsTo": "http://mlcommons.org/croissant/1.0", "version": "1.0.0", "isLiveDataset": False,
        "license": "https://creativecommons.org/publicdomain/zero/1.0/",
        "distribution": [_file(store.manifest), {
            "@type": "cr:FileSet", "@id": "homes", "name": "homes", "description": "one artifact a line",
            "encodingFormat": "application/gzip", "includes": f"{HOMES}/*.jsonl.gz"}],
        "recordSet": [{"@type": "cr:RecordSet", "@id": "rows", "name": "rows", "key": {"@id": "rows/id"},
                       "field": [_field(name, kind) for name, kind in _COLUMNS.items()]}],
    }


def _file(path: Path) -> dict[str, Any]:
    with open(path, "rb") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
    return {"@type": "cr:FileObject", "@id": MANIFEST, "name": MANIFEST, "contentUrl": MANIFEST,
            "contentSize": f"{path.stat().st_size} B", "encodingFormat": "application/jsonlines", "sha256": digest}


def _field(name: str, kind: str) -> dict[str, Any]:
    return {"@type": "cr:Field", "@id": f"rows/{name}", "name": name, "dataType": kind,
            "source": {"fileObject": {"@id": MANIFEST}, "extract": {"jsonPath": f"$.{name}"}}}

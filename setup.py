"""The folders at the top level are installed as parts of one package, so that no general name is taken."""

from setuptools import find_namespace_packages, setup

PARTS = {"apartgen": "apartgen", "apartgen_cli": "apartgen_cli",
         "apartgen.schemas": "schemas", "apartgen.stages": "stages"}

setup(
    package_dir=PARTS,
    packages=[name + (f".{inner}" if inner else "") for name, folder in PARTS.items()
              for inner in ["", *find_namespace_packages(folder, exclude=["*__pycache__*"])]],
)

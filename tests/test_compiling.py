"""What is compiled is said once a process."""

import logging
import subprocess
import sys

from apartgen.stages import compiling


def test_compiling_is_said_once(caplog):
    said = compiling._Said()
    with caplog.at_level(logging.INFO, "apartgen"):
        for _ in range(3):
            said.on_start(None)
    assert len(caplog.records) == 1 and "compiling" in caplog.text


def test_linear_algebra_is_not_loaded_with_what_is_compiled_and_can_be():
    """In a process of its own: .16 s of every command."""
    loaded = ("import sys, apartgen.stages.scene.lens; assert 'scipy.linalg' not in sys.modules;"
              "import scipy.linalg.cython_blas as blas; from numba.np.linalg import ensure_blas; ensure_blas();"
              "assert 'dgemm' in blas.__pyx_capi__")
    subprocess.run([sys.executable, "-c", loaded], check=True, timeout=60)

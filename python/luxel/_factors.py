# SPDX-License-Identifier: Apache-2.0
"""View factors."""
import os

import numpy as np

from . import _core
from ._errors import Stopped
from ._options import call, documented, given, options_of
from ._scene import scene_of


def factor_options():
    return options_of("viewfactors")


class ViewFactors:
    """View factors between n elements: F[i, j] is the part of the diffuse power leaving i that arrives at j directly.

    Sparse rows. Arrays are read-only views. scipy.sparse.csr_matrix(factors.csr()) is the matrix.
    """

    def __init__(self, handle):
        self._handle = handle

    def __len__(self):
        return len(self._handle)

    def __repr__(self):
        return f"<luxel.ViewFactors between {len(self)} {self.between}: {len(self.data)} factors>"

    @property
    def names(self):
        """Names of the elements; of patches their numbers; of backs with ":back"."""
        return tuple(self._handle.names)

    @property
    def between(self):
        """What elements are: "groups", "objects", "materials" or "patches"."""
        return self._handle.between

    @property
    def areas(self):
        """(n,) float64, m²."""
        return self._handle.areas

    @property
    def data(self):
        """(k,) float64: the factors above 0, row by row."""
        return self._handle.data

    @property
    def data_error(self):
        """(k,) float32: standard errors of `data`."""
        return self._handle.data_error

    @property
    def indices(self):
        """(k,) uint32: columns of `data`, ascending in each row."""
        return self._handle.indices

    @property
    def indptr(self):
        """(n + 1,) uint64: row i is data[indptr[i]:indptr[i + 1]]."""
        return self._handle.indptr

    def csr(self):
        """(data, indices, indptr), as scipy.sparse.csr_matrix takes them; give it shape=(n, n) where the last columns may be
        empty."""
        return self.data, self.indices, self.indptr

    def csr_error(self):
        """The same of the standard errors."""
        return self.data_error, self.indices, self.indptr

    def toarray(self):
        """(n, n) float64, dense. 8 n² bytes."""
        dense = np.zeros((len(self), len(self)))
        rows = np.repeat(np.arange(len(self)), np.diff(self.indptr.astype(np.int64)))
        dense[rows, self.indices] = self.data
        return dense

    @property
    def environment(self):
        """(n,) float64: the part that leaves the scene. Rows of factors, environment, backs and dropped sum to 1."""
        return self._handle.environment

    @property
    def environment_error(self):
        """(n,) float32: its standard error."""
        return self._handle.environment_error

    @property
    def backs(self):
        """(n,) float64: the part that meets backs which are no elements."""
        return self._handle.backs

    @property
    def dropped(self):
        """(n,) float64: the sum of factors below min_factor."""
        return self._handle.dropped

    @property
    def triangles(self):
        """(n,) uint32, between patches: the scene's triangle of each; else empty."""
        return self._handle.triangles

    @property
    def centres(self):
        """(n, 3) float32, m, between patches; else empty."""
        return self._handle.centres

    @property
    def enforced(self):
        """Whether row sums and reciprocity were made exact (enforce=True)."""
        return self._handle.enforced

    @property
    def error(self):
        """Root mean square standard error of the factors; 0 where exact or read from a file."""
        return self._handle.error

    @property
    def rays(self):
        """Number of rays traced."""
        return self._handle.rays

    def save(self, path):
        """Writes .h5 (whole, for load_view_factors()), .csv or .mtx."""
        self._handle.write(os.fspath(path))


@documented(factor_options)
def view_factors(scene, *, threads=None, progress=None, **options):
    """View factors between the groups, objects, materials or patches of a scene, with obstruction.

    scene: a path, a Scene, or an object with `vertices` and `faces`. Returns ViewFactors. The options are those of the
    command `luxel viewfactors`. Raises InputError where the factors would need more memory than there is.
    """
    loaded, rest = scene_of(scene, options, "view_factors", threads, progress)
    handle = _core.view_factors(loaded._handle, given(factor_options(), "view_factors", rest), call(threads, progress))
    if handle is None:
        raise Stopped("stopped before there were any factors")
    return ViewFactors(handle)


def load_view_factors(path):
    """Reads view factors from an .h5 file. Raises InputError or FormatError."""
    return ViewFactors(_core.read_view_factors(os.fspath(path)))

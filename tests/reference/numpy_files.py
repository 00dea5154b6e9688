"""Writes the files in tests/reference/numpy with NumPy: what its own reader and ours must agree on."""
import os

import numpy as np

os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "numpy"))
a = np.array([[0, 1.5, -2.25], [0.1, 2.5, 1e-3], [0.2, 3.5, 7]])
np.save("f8.npy", a)
np.save("f8_fortran.npy", np.asfortranarray(a))
np.save("f4_big_endian.npy", a.astype(">f4"))
np.save("i2.npy", (a * 4).astype("<i2"))

rows = np.zeros(3, dtype=[("t", "<f8"), ("w", "<f4", (3,)), ("X", ">f8", (2, 2)), ("note", "<U5"), ("n", "u1")])
rows["t"] = [0, 0.5, 1]
rows["w"] = a
rows["X"] = np.arange(12).reshape(3, 2, 2)
rows["note"] = "abc"
rows["n"] = [1, 2, 255]
np.save("structured.npy", rows)

nested = np.zeros(2, dtype=[("t", "<f8"), ("rates", [("x", "<f8"), ("y", "<f8")])])
nested["rates"]["y"] = [5, 6]
np.save("nested.npy", nested)

padded = np.zeros(2, dtype=np.dtype([("n", "i1"), ("t", "<f8")], align=True))
padded["t"] = [1, 2]
np.save("padded.npy", padded)

np.save("objects.npy", np.array([[1, "a"], [2, None]], dtype=object))
np.save("one_dimension.npy", a[0])
np.save("complex.npy", a.astype(complex))
np.save("no_rows.npy", a[:0])
for version in (2, 3):
    with open(f"version{version}.npy", "wb") as file:
        np.lib.format.write_array(file, a, version=(version, 0))

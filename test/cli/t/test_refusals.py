"""test_refusals.py - does what build/tess advises work?

Of each format that it knows, but does not read, a file of the same five points:
the command that its message has is run, and what that writes is read.  Each name
in formats.c is here.
"""
import contextlib
import importlib.util
import io
import os
import pickle
import re
import shutil
import subprocess
import sys

import pytest

np = pytest.importorskip("numpy")
SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "src",
                      "read", "formats.c")
P = np.array([(0, 0, 0), (1, 0, 0), (0, 1.5, 0), (0, 0, -2),
              (.134, .25, -.5)])
UP = P + (0, 0, 2)  # in a crystal's cell
LINES = "".join("%g %g %g\n" % tuple(p) for p in P)


def put(name, text):
    with open(name, "w") as f:
        f.write(text)


def got(name):
    with open(name, "rb") as f:
        return f.read()


def run(*command):
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)


def packed(*command):
    """by a program that compresses"""
    return command[0], lambda: subprocess.run(
        command, input=LINES.encode(), check=True, stdout=subprocess.PIPE).stdout


def npz():
    np.savez("made.npz", points=P)
    return got("made.npz")


def zipped():
    import zipfile
    with zipfile.ZipFile("made.zip", "w") as z:
        z.writestr("points.txt", LINES)
    return got("made.zip")


def hdf5():
    import h5py
    with h5py.File("made.h5", "w") as f:
        f["points"] = P
    return got("made.h5")


def netcdf():
    from scipy.io import netcdf_file
    with netcdf_file("made.nc", "w") as f:
        f.createDimension("row", 5)
        for k in range(3):
            f.createVariable("xyz"[k], "d", ("row",))[:] = P[:, k]
    return got("made.nc")


def by_meshio(ending, **more):
    def make():
        import meshio
        name = "made." + ending
        with contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()):
            meshio.Mesh(P, [("tetra", np.array([[0, 1, 2, 3], [0, 1, 2, 4]]))]
                        ).write(name, **more)
        return got(name)
    return "meshio", make, P, ending


def by_assimp(form):
    def make():
        put("made.obj", "".join("v %g %g %g\n" % tuple(p) for p in P) +
            "f 1 2 3\nf 1 2 4\nf 2 3 5\n")
        run("assimp", "export", "made.obj", "made.out", "-f" + form)
        return got("made.out")
    return "assimp", make, P, form[:3]


def by_ase(form):
    def make():
        import ase
        import ase.io
        ase.io.write("made.out", ase.Atoms("C5", UP, cell=[9, 9, 9], pbc=True),
                     format=form)
        return got("made.out")
    return "ase", make, UP, {"vasp": "poscar"}.get(form, form)


def mmcif():
    import gemmi
    s, model, chain = gemmi.Structure(), gemmi.Model("1"), gemmi.Chain("A")
    for k, p in enumerate(P):
        r, a = gemmi.Residue(), gemmi.Atom()
        r.name, r.seqid = "ALA", gemmi.SeqId(str(k + 1))
        a.name, a.element, a.pos = "CA", gemmi.Element("C"), gemmi.Position(*p)
        r.add_atom(a)
        chain.add_residue(r)
    model.add_chain(chain)
    s.add_model(model)
    return s.make_mmcif_document().as_string().encode()


def step():
    put("made.geo", 'SetFactory("OpenCASCADE"); Box(1) = {0, 0, 0, 1, 2, 3};')
    run("gmsh", "-0", "made.geo", "-o", "made.step")
    return got("made.step")


def by_gdal(form, ending):
    def make():
        put("made.asc", ESRI.decode())
        run("gdal_translate", "-q", "-of", form, "made.asc", "made.out")
        return got("made.out")
    return "gdal_translate", make, CELLS, ending


def by_ogr(form, ending):
    def make():
        name = "refused." + ending  # (others may belong to it)
        if os.path.exists(name):
            os.remove(name)
        put("made.csv", "x,y,z\n" + LINES.replace(" ", ","))
        run("ogr2ogr", "-f", form, name, "made.csv", *(w for c in "XYZ" for w in (
            "-oo", "%s_POSSIBLE_NAMES=%s" % (c, c.lower()))))
        return got(name)
    return "ogr2ogr", make, P, ending


ESRI = b"ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n"
SDF = ("points\n\n\n  5  0  0  0  0  0  0  0  0  0999 V2000\n" + "".join(
    "%10.4f%10.4f%10.4f C   0  0\n" % tuple(p) for p in P) +
    "M  END\n$$$$\n").encode()


def mol2():
    put("made.sdf", SDF.decode())
    run("obabel", "made.sdf", "-O", "made.mol2")
    return got("made.mol2")


SAID = object()  # what is said is no command
BOX, CELLS = [(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 3)], [
    (.5, 1.5, 1), (1.5, 1.5, 2), (.5, .5, 3), (1.5, .5, 4)]

# name in formats.c: (the program that the command needs, what makes a file, its
# points, its ending); there may be several
TESTS = {
    "compressed by gzip": [packed("gzip")],
    "compressed by bzip2": [packed("bzip2")],
    "compressed by xz": [packed("xz")],
    "compressed by zstd": [packed("zstd")],
    "compressed by lz4": [packed("lz4")],
    "compressed by compress": [packed("compress")],
    "a spreadsheet": SAID, "MATLAB's": SAID, "PDF": SAID, "PostScript": SAID,
    "a web page": SAID, "JSON or the like": SAID, "Tecplot's": SAID,
    "a pointer of Git LFS": SAID, "LAMMPS's data": SAID, "parquet": SAID,
    "Arrow's": SAID, "OpenFOAM's": SAID,
    "no text, nor a binary format that is known": SAID,
    "GOCAD's, of a grid or a well": SAID, "one CTD cast of CCHDO's": SAID,
    "IRAP's grid": SAID, "Fluent's profile or plot": SAID,
    "Fluent's mesh": SAID,
    "NumPy's .npz": [("numpy", npz)],
    "a zip archive": [("unzip", zipped)],
    "Python's pickle": [("numpy", lambda: pickle.dumps(P, 4))],
    "HDF5, MATLAB 7.3 or netCDF 4": [("h5py", hdf5)],
    "netCDF": [("xarray", netcdf)],
    "an ESRI grid": [("gdal_translate", lambda: ESRI, CELLS, "asc")],
    "TIFF": [by_gdal("GTiff", "tif")],
    "Surfer's grid": [by_gdal("GSAG", "grd"), by_gdal("GSBG", "grd"),
                      by_gdal("GS7BG", "grd")],
    "a shapefile": [by_ogr("ESRI Shapefile", "shp")],
    "a GeoPackage or SQLite's": [by_ogr("GPKG", "gpkg")],
    "LAZ": [("laszip", None)], "E57": [("CloudCompare", None)],
    "PTX": [("CloudCompare", None)], "GRO": [("gmx", None)],
    "glTF": [by_assimp("glb2")], "FBX": [("assimp", None)],
    "DXF": [("assimp", None)],
    "VTK's": [by_meshio("vtk")], "XML, perhaps VTK's": [by_meshio("vtu")],
    "Gmsh's": [by_meshio("msh", file_format="gmsh"),
               by_meshio("msh", file_format="gmsh22", binary=False)],
    "Abaqus's": [by_meshio("inp")],
    "STEP": [("gmsh", step, BOX, "step")], "IGES": [("gmsh", None)],
    "CIF": [by_ase("cif")], "POSCAR": [by_ase("vasp")],
    "mmCIF": [("gemmi", mmcif, P, "cif")],
    "SDF": [("obabel", lambda: SDF, P, "sdf")], "MOL2": [("obabel", mol2, P, "mol2")],
}


MODULES = {"numpy", "h5py", "xarray", "meshio"}
# for which there must be what makes a file, and runs the command
CASES = [pytest.param(name, *test, id="%s: %s" % (name, test[0]))
         for name, tests in TESTS.items() if tests is not SAID for test in tests
         if test[1] and (importlib.util.find_spec(test[0]) if test[0] in MODULES
                         else shutil.which(test[0]))]


def points(tess, name):
    """what is read there, or said"""
    done = tess("-q", "-node", "out.node", name)
    if done.code:
        return done.err
    with open("out.node") as f:
        return np.unique(np.round(np.array(
            [s.split()[1:4] for s in f][1:], float), 4), axis=0)


def test_each_name_in_formats_c_is_here():
    with open(SOURCE) as f:
        assert set(re.findall(r'(?:NOT_READ|TOLD)\("([^"]*)"', f.read())) == set(
            TESTS)


# (hardly anything of it is this program's)
@pytest.mark.long
@pytest.mark.parametrize("name, need, make, want, ending", [
    pytest.param(*case.values, *(P, "dat")[len(case.values) - 3:], id=case.id)
    for case in CASES])
def test_advice_gives_the_points(tess, name, need, make, want, ending):
    file = "refused." + ending
    data = make()
    with open(file, "wb") as f:
        f.write(data)
    said = points(tess, file)
    found = re.match(r"tess: [^:]*: is (.*), which is not read: (.*)\n$", said)
    assert found and found[1] == name
    command = found[2].split(", or in ParaView")[0].split("; ")[0]
    written = re.findall(r"G\.\w+", command)
    if command.startswith(("numpy", "xarray", "pandas")):
        command = "import numpy, importlib, importlib.util\n" + "".join(
            "if importlib.util.find_spec('%s'): import %s\n" % (m, m)
            for m in ("meshio", "h5py", "xarray", "pandas")) + command.replace(
                "'F'", repr(file))
        command = [sys.executable, "-W", "ignore", "-c", command]
    else:
        command = re.sub(r"\bF\b", file, command)
        if "| tess ..." in command:
            command = command.replace("| tess ...", "> G.txt")
            written = ["G.txt"]
        command = ["sh", "-c", command]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True)
    assert done.returncode == 0, (command[-1], done.stdout, done.stderr)
    got, want = points(tess, written[0]), np.unique(np.round(want, 4), axis=0)
    assert not isinstance(got, str)
    # (a mesh of edges and faces has more)
    assert all(np.isclose(got, w, atol=2e-4).all(1).any() for w in want)
    assert want.shape != P.shape or len(got) == len(want) or need == "gdal_translate"

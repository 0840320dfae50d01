"""What pyproject.toml cannot say: the C files become a library that tess89
loads by ctypes, so that one wheel serves all versions of Python.

The C files are where the checkout has them, or in an sdist's own folder c,
which they are copied into when it is made.
"""
import os
import shutil
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:
    try:
        from wheel.bdist_wheel import bdist_wheel
    except ImportError:  # then only an sdist can be made
        bdist_wheel = None

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
FOLDERS = [os.path.join(HERE, "c")]
if not os.path.isdir(FOLDERS[0]):
    FOLDERS = [TOP, os.path.join(TOP, "test", "recipes")]
SOURCES = ["tess.c", "hhpred.c", "many.c", "slopes.c", "natural.c", "derived.c",
           "iso.c"]
HEADERS = ["tess.h", "hhpred.h", "recipes.h"]
CALLS = ["tess_size", "tess_resume", "tess_hull", "tess_check", "tr_many",
         "tr_average", "tr_slopes", "tr_stars", "tr_edges", "tr_dual",
         "tr_iso"]


def copied(folder, names):
    """The C files in a folder."""
    os.makedirs(folder, exist_ok=True)
    for name in names:
        found = [f for f in FOLDERS if os.path.exists(os.path.join(f, name))]
        if not found:
            raise SystemExit("tess89: no %s in %s" % (name,
                                                      " or ".join(FOLDERS)))
        shutil.copy2(os.path.join(found[0], name), folder)


class build_library(build_ext):
    def get_ext_filename(self, name):
        return (os.path.join(*name.split(".")) +
                (".dll" if os.name == "nt" else ".so"))

    def get_export_symbols(self, ext):
        return CALLS

    def build_extension(self, ext):
        folder = os.path.join(self.build_temp, "c")
        copied(folder, SOURCES + HEADERS)
        ext.sources = [os.path.join(folder, name) for name in SOURCES]
        ext.depends = [os.path.join(folder, name) for name in HEADERS]
        if self.compiler.compiler_type != "msvc":
            ext.extra_compile_args = ["-O3", "-g0"]
            ext.libraries = ["m"]
        if sys.platform.startswith("linux"):
            # its calls are its own, whatever else the program has loaded
            ext.extra_link_args = ["-Wl,-Bsymbolic"]
        super().build_extension(ext)


class sdist_with_c(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        copied(os.path.join(base_dir, "c"), SOURCES + HEADERS + ["LICENSE"])


commands = {"build_ext": build_library, "sdist": sdist_with_c}
if bdist_wheel:
    class wheel_for_all(bdist_wheel):
        def get_tag(self):
            return ("py3", "none") + super().get_tag()[2:]

    commands["bdist_wheel"] = wheel_for_all

setup(ext_modules=[Extension("tess89._library", [])], cmdclass=commands)

"""Setuptools builds all.  Where pip's environment for building has none, that
beside pip does, or that of the Python which a venv is made of: no network is
needed if it is installed there, with wheel if it is older than 70.1."""
import subprocess
import sys

NEEDS = """
import setuptools.build_meta
if int(setuptools.__version__.split(".")[0]) < 61: raise ImportError
try: import setuptools.command.bdist_wheel
except ImportError: import wheel
"""
BUILD = """
import sys
from setuptools import build_meta
name = getattr(build_meta, sys.argv[1])(sys.argv[2])
print("built", name, file=sys.stderr)
"""


def inside():
    try:
        exec(NEEDS, {})
    except ImportError:
        return False
    return True


def beside():
    """A command that runs Python with setuptools, or None."""
    for python in sys.executable, getattr(sys, "_base_executable", None):
        # -I: without what pip puts before Python's own packages
        if python and not subprocess.run([python, "-I", "-c", NEEDS],
                                         stderr=subprocess.DEVNULL).returncode:
            return [python, "-I", "-c"]
    return None


def needed(config_settings=None):
    """What pip has to fetch."""
    return [] if inside() or beside() else ["setuptools>=61", "wheel"]


get_requires_for_build_sdist = get_requires_for_build_wheel = needed
get_requires_for_build_editable = needed


def build(call, folder):
    if inside():
        from setuptools import build_meta
        return getattr(build_meta, call)(folder)
    done = subprocess.run(beside() + [BUILD, call, folder],
                          stderr=subprocess.PIPE, universal_newlines=True)
    sys.stderr.write(done.stderr)
    if done.returncode:
        raise SystemExit(done.returncode)
    return done.stderr.strip().split("\n")[-1].split("built ")[1]


def build_sdist(sdist_directory, config_settings=None):
    return build("build_sdist", sdist_directory)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    return build("build_wheel", wheel_directory)


def build_editable(wheel_directory, config_settings=None,
                   metadata_directory=None):
    return build("build_editable", wheel_directory)

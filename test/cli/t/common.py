# common.py - what scripts of tests of build/tess, the first argument, share.
import subprocess
import sys

import numpy as np

TESS = sys.argv[1]


def test(name, good):
    print("ok      " + name if good else "FAILED  " + name, flush=True)


def run(*arguments):
    return subprocess.run([TESS] + [str(a) for a in arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=200)


def tess(*arguments):
    """What it said, if it did not fail."""
    done = run(*arguments)
    if done.returncode != 0:
        print("FAILED  tess %s: %s" % (arguments, done.stderr))
        sys.exit(1)
    return done


def near(a, b, most):
    """Within most of each other, NaN at the same places."""
    return a.shape == b.shape and bool(
        np.all(np.isnan(a) == np.isnan(b)) and
        np.all(np.abs(a - b)[~np.isnan(a)] <= most))

"""Once imported, the compiler optimises less than for a user, which changes no bit of a result.

gcc also watches: who leaves an array, or reads what was never written, does not get away with it.
With TURNBUCKLE_COVERAGE, a folder, it measures what of the C is run, and builds in there. Imported
by conftest.py; by pytest in the guest, which cannot compile, to find the same libraries.
"""

import os
from pathlib import Path

import turnbuckle.codegen.compile

#: An illegal instruction beyond an array; large numbers in what was not initialised.
WATCHFUL = (
    "-fsanitize=bounds-strict",
    "-fsanitize-undefined-trap-on-error",
    "-ftrivial-auto-var-init=pattern",
)

if folder := os.environ.get("TURNBUCKLE_COVERAGE"):
    turnbuckle.codegen.compile.FLAGS = (*turnbuckle.codegen.compile.FLAGS, "-O0", "--coverage")
    turnbuckle.codegen.compile.LIBRARIES = Path(folder)
else:
    turnbuckle.codegen.compile.FLAGS = (*turnbuckle.codegen.compile.FLAGS, "-O1")
    turnbuckle.codegen.compile.GCC_FLAGS = (*turnbuckle.codegen.compile.GCC_FLAGS, *WATCHFUL)

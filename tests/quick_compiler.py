"""Once imported, the compiler optimises less than for a user, which changes no bit of a result.

With TURNBUCKLE_COVERAGE, a folder, it measures what of the C is run, and builds in there. Imported
by conftest.py; by pytest in the guest, which cannot compile, to find the same libraries.
"""

import os
from pathlib import Path

import codegen.compile

if folder := os.environ.get("TURNBUCKLE_COVERAGE"):
    codegen.compile.FLAGS = (*codegen.compile.FLAGS, "-O0", "--coverage")
    codegen.compile.LIBRARIES = Path(folder)
else:
    codegen.compile.FLAGS = (*codegen.compile.FLAGS, "-O1")

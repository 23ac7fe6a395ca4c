"""Once imported, the compiler optimises less than for a user, which changes no bit of a result.

Imported by conftest.py; by pytest in the guest, which cannot compile, to find the same libraries.
"""

import codegen.compile

codegen.compile.FLAGS = (*codegen.compile.FLAGS, "-O1")

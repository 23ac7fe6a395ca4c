"""How nearly numbers of a machine file are the same."""

import sys

# A product of two rounded numbers may miss an exact limit by this much.
ROUNDING = 4 * sys.float_info.epsilon

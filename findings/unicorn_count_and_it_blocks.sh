#!/usr/bin/env bash
# A step of one instruction runs four of them when it meets an IT block.
#
# Package   Unicorn 2.1.4 (Python).
# Input     emu_start(..., count=N) on a Cortex-M: movs, cmp, ittt eq, three adds that the block
#           guards, two adds after it.
# Expected  N instructions are run, as they are in the same code without the IT.
# Seen      A count of 3 stops behind the whole block: six instructions are run, and six reach
#           UC_HOOK_CODE. Counts of 3, 4, 5 and 6 all end at the same place. A time base or a
#           deadline counted in instructions is short by up to four at each block that a count
#           ends in, and single steps skip the inside of it.
# Documents The header: count is "the number of instructions to be emulated".
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check unicorn==2.1.4

cd "$work"
venv/bin/python - <<'PYTHON'
import struct

import unicorn
from unicorn import UC_ARCH_ARM, UC_HOOK_CODE, UC_MODE_MCLASS, UC_MODE_THUMB, Uc
from unicorn.arm_const import UC_ARM_REG_R0

START = 0x0800_0000
MOVS, CMP, ITTT_EQ, NOP, ADDS_1, ADDS_8 = 0x2000, 0x2800, 0xBF02, 0xBF00, 0x3001, 0x3008


def run(middle, count):
    """The instructions that a count runs, and r0 behind them."""
    code = [MOVS, CMP, middle, ADDS_1, ADDS_1, ADDS_1, ADDS_8, ADDS_8]
    machine = Uc(UC_ARCH_ARM, UC_MODE_THUMB | UC_MODE_MCLASS)
    machine.mem_map(START, 0x1000)
    machine.mem_write(START, struct.pack("<8H", *code))
    seen = []
    machine.hook_add(UC_HOOK_CODE, lambda _machine, address, _size, _data: seen.append(address))
    machine.emu_start(START | 1, START + 16, count=count)
    return len(seen), machine.reg_read(UC_ARM_REG_R0)


print("Unicorn", unicorn.__version__)
counts = range(1, 9)
without = [run(NOP, count) for count in counts]
block = [run(ITTT_EQ, count) for count in counts]
for count, (ran, r0), (ran_it, r0_it) in zip(counts, without, block, strict=True):
    print(f"count {count}: with a nop {ran} run, r0 {r0}; with the IT {ran_it} run, r0 {r0_it}")

if [ran for ran, _ in without] != list(counts):
    raise SystemExit("Plain instructions are not counted as they were.")
if block[2:6] != [(6, 3)] * 4 or block[6] != (7, 11):
    raise SystemExit("The behaviour has changed.")
PYTHON

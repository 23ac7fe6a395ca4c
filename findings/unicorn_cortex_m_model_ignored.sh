#!/usr/bin/env bash
# A Cortex-M0 that divides, adds floats and runs ARMv8-M: every M-class model is a Cortex-M33.
#
# Package   Unicorn 2.1.4 (Python).
# Input     ctl_set_cpu_model() before anything else, in the modes THUMB | MCLASS (as Cortex-M
#           examples open it) and THUMB alone; one instruction each run.
# Expected  Instructions that the chosen core has not are UC_ERR_INSN_INVALID: a Cortex-M0 has
#           neither UDIV nor VADD, a Cortex-M4 has no LDA. Or the call is refused.
# Seen      With MCLASS the call succeeds, ctl_get_cpu_model() then answers Cortex-M33, and all
#           three run, so that firmware built for the wrong core passes its tests. Without MCLASS
#           the very same model is taken and the instructions are refused.
# Documents The header calls MCLASS "ARM's Cortex-M series". Asked for another M core, the
#           maintainers advise ctl_set_cpu_model() together with this mode.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check unicorn==2.1.4

cd "$work"
venv/bin/python - <<'PYTHON'
import unicorn
from unicorn import UC_ARCH_ARM, UC_MODE_MCLASS, UC_MODE_THUMB, Uc, UcError, arm_const

INSTRUCTIONS = {
    "udiv r0, r0, r1": "b0fbf1f0",
    "vadd.f32 s0, s0, s1": "30ee200a",
    "lda r0, [r2]": "d2e8af0f",
}


def runs(mode, model, code):
    """Whether one instruction runs on the model, and the model that the emulator names."""
    machine = Uc(UC_ARCH_ARM, mode)
    machine.ctl_set_cpu_model(model)
    machine.mem_map(0x0800_0000, 0x1000)
    machine.mem_map(0x2000_0000, 0x1000)
    machine.mem_write(0x0800_0000, code)
    machine.reg_write(arm_const.UC_ARM_REG_R2, 0x2000_0000)
    try:
        machine.emu_start(0x0800_0001, 0x0800_0000 + len(code))
    except UcError:
        return False, machine.ctl_get_cpu_model()
    return True, machine.ctl_get_cpu_model()


print("Unicorn", unicorn.__version__)
names = {getattr(arm_const, f"UC_CPU_ARM_CORTEX_{name}"): name for name in ("M0", "M4", "M33")}
table = {}
for mode in ("THUMB", "THUMB | MCLASS"):
    flags = UC_MODE_THUMB | (UC_MODE_MCLASS if "MCLASS" in mode else 0)
    for model, name in names.items():
        results = [runs(flags, model, bytes.fromhex(code)) for code in INSTRUCTIONS.values()]
        table[mode, name] = [ran for ran, _ in results] + [names[results[0][1]]]
        ran = dict(zip([*INSTRUCTIONS, "model"], table[mode, name], strict=True))
        print(f"{mode}, {name} asked: {ran}")

if table["THUMB", "M0"] != [False] * 3 + ["M0"] or table["THUMB", "M4"] != [
    True,
    True,
    False,
    "M4",
]:
    raise SystemExit("Without MCLASS the models are not what they were.")
if any(table["THUMB | MCLASS", name] != [True] * 3 + ["M33"] for name in names.values()):
    raise SystemExit("The behaviour has changed.")
PYTHON

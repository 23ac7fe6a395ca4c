"""The drives by another hand as a library; and that their tests find what is wrong with them."""

from __future__ import annotations

import ctypes
import re
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import peer_drives
import pytest
import test_peer_adapter as adapter
import test_peer_motion as motion
import test_peer_network as network
import test_peer_objects as objects
import test_peer_pdo as pdo
import test_peer_power as power
import test_peer_wire as wire
from peer_bench import Bench, Refused
from peer_drives import SOURCES, Library, sources

Check = Callable[[Library], object]
STRICT = ("-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")

SPEED = Path(__file__).parent / "peer_speed.c"
AT_SYNC = """    answer_sync(d);
    for (unsigned n = 0; n < PDOS; n++) {
        if (d->rpdo[n].fresh && d->value[rpdo_id(n) + 1] <= SYNCHRONOUS_MOST) {
            apply(d, n);
        }
    }
    servo_output(d, 0.0);
"""


@dataclass(frozen=True)
class Defect:
    """What stands in a file, what stands there instead, and a test that finds it."""

    file: str
    right: str
    wrong: str
    check: Check


DEFECTS = {
    "the toggle bit of an upload is not checked": Defect(
        "sdo.c",
        "if ((request[0] & TOGGLE) != t->toggle) {\n        abort_running",
        "if (false) {\n        abort_running",
        lambda library: objects.test_a_wrong_toggle_bit_ends_the_transfer(Bench(library)),
    ),
    "the toggle bit of a download is not checked": Defect(
        "sdo.c",
        "if ((request[0] & TOGGLE) != t->toggle) {\n        return",
        "if (false) {\n        return",
        lambda library: objects.test_a_wrong_toggle_bit_ends_the_transfer(Bench(library)),
    ),
    "an RPDO is applied at once": Defect(
        "pdo.c",
        "if (d->value[rpdo_id(n) + 1] > SYNCHRONOUS_MOST) {",
        "if (d->value[rpdo_id(n) + 1] >= 0) {",
        pdo.test_a_synchronous_rpdo_is_applied_at_the_next_sync,
    ),
    "an RPDO is applied with every SYNC after": Defect(
        "pdo.c",
        "    d->rpdo[n].fresh = false;\n    for (unsigned k",
        "    for (unsigned k",
        pdo.test_an_rpdo_of_before_is_not_applied_again,
    ),
    "a SYNC is answered with what it brought about": Defect(
        "pdo.c",
        AT_SYNC,
        AT_SYNC.replace("    answer_sync(d);\n", "")
        + "    objects_refresh(d);\n    answer_sync(d);\n",
        pdo.test_a_tpdo_says_what_was_before_the_rpdo_of_the_same_sync,
    ),
    "a valid PDO can be mapped anew": Defect(
        "pdo.c",
        "return ABORT_STATE; /* a mapping",
        "return ABORT_NONE; /* a mapping",
        lambda library: pdo.test_a_valid_pdo_keeps_its_identifier_mapping_and_inhibit_time(
            Bench(library)
        ),
    ),
    "heartbeats are never missed": Defect(
        "nmt.c",
        "            heartbeat_lost(d);",
        "            (void)heartbeat_lost;",
        lambda library: network.test_a_heartbeat_missed_is_an_emergency_after_the_time_set(
            Bench(library)
        ),
    ),
    "a fault is reset without an edge": Defect(
        "cia402.c",
        "(risen & FAULT_RESET) != 0",
        "(word & FAULT_RESET) != 0",
        power.test_a_fault_is_reset_by_a_rising_edge_only,
    ),
    "a lost master's fault is reset like any other": Defect(
        "cia402.c",
        "|| w->state != PEER_FAULT || w->latched",
        "|| w->state != PEER_FAULT",
        network.test_the_fault_of_a_missed_heartbeat_is_reset_only_after_reset_communication,
    ),
    "the check sequence has another polynomial": Defect(
        "bits.c",
        "0x4599U",
        "0x4D99U",
        wire.test_any_frame_has_the_remainder_and_the_stuff_bits_of_the_standard,
    ),
    "a stuff bit begins no run": Defect(
        "bits.c",
        "last ^= 1U;\n            run = 1;",
        "last = 2;\n            run = 0;",
        wire.test_any_frame_has_the_remainder_and_the_stuff_bits_of_the_standard,
    ),
    "the highest identifier wins": Defect(
        "bits.c",
        "append(to, frame->id, 11);",
        "append(to, ~frame->id, 11);",
        wire.test_drives_that_answer_one_sync_go_in_the_order_of_their_identifiers,
    ),
    "a frame arrives when its last bit starts the gap": Defect(
        "bus.c",
        "bits_time(bits - 3,",
        "bits_time(bits,",
        lambda library: wire.test_a_frame_takes_its_bits_and_its_answer_comes_after_the_gap(
            library, 1_000_000, 1000
        ),
    ),
    "a position stops at the end of 32 bits": Defect(
        "servo.c",
        "return (int32_t)((uint32_t)(int64_t)counts + (uint32_t)d->servo.shift);",
        "return (int32_t)fmin(fmax(counts + d->servo.shift, INT32_MIN), INT32_MAX);",
        lambda library: motion.test_positions_wrap_at_32_bits_wherever_they_start(
            library, 2**31 - 3
        ),
    ),
    "the current has no limit": Defect(
        "servo.c",
        "s->limited = given != wanted;\n    return given;",
        "s->limited = given != wanted;\n    return wanted;",
        lambda library: motion.test_torque_is_per_mille_of_the_rated_up_to_the_current_limit(
            library, 2001, 2.0
        ),
    ),
    "homing does not wait for its threshold": Defect(
        "homing.c",
        "if (fabs(s->current_averaged) >= (double)d->value[O_HOME_CURRENT]) {",
        "if (fabs(s->demand_rate) > 0.0) {",
        lambda library: motion.test_homing_ends_at_the_stop_its_method_seeks(library, -3, 2.0, 0),
    ),
    "an adapter answers when it is asked not to": Defect(
        "adapter.c",
        "if (b->config.variation.acknowledgement != PEER_ACK_NONE) {\n        put_line",
        "if (true) {\n        put_line",
        adapter.test_without_acknowledgements_nothing_is_refused_aloud_either,
    ),
}


@pytest.fixture(scope="module")
def parts(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Each C file of the drives compiled, by name."""
    folder = tmp_path_factory.mktemp("parts")
    return {path.name: compiled_part(path, folder) for path in sources()}


def compiled_part(path: Path, folder: Path) -> Path:
    target = folder / f"{path.stem}.o"
    command = ["gcc", "-std=c11", "-O1", "-fPIC", f"-I{SOURCES}", "-c", str(path)]
    subprocess.run([*command, "-o", str(target)], check=True)
    return target


def with_defect(parts: dict[str, Path], defect: Defect, folder: Path) -> Library:
    """The drives with a piece of one file replaced."""
    text = (SOURCES / defect.file).read_text()
    assert text.count(defect.right) == 1
    (folder / defect.file).write_text(text.replace(defect.right, defect.wrong))
    part = compiled_part(folder / defect.file, folder)
    others = [str(path) for name, path in parts.items() if name != defect.file]
    shared = folder / "defect.so"
    subprocess.run(["gcc", "-shared", "-o", str(shared), str(part), *others, "-lm"], check=True)
    return Library(shared)


@pytest.mark.parametrize("name", DEFECTS)
def test_a_defect_is_found(parts: dict[str, Path], tmp_path: Path, name: str) -> None:
    library = with_defect(parts, DEFECTS[name], tmp_path)
    with pytest.raises((AssertionError, Refused, TimeoutError, pytest.fail.Exception)):
        DEFECTS[name].check(library)


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("path", sorted(SOURCES.glob("*.[ch]")), ids=lambda path: path.name)
def test_the_drives_compile_without_a_warning(path: Path, compiler: str) -> None:
    command = [compiler, *STRICT, "-O2", "-x", "c", "-c", str(path), "-o", "/dev/null"]
    subprocess.run(command, check=True)


def test_the_public_header_can_be_used_from_cpp() -> None:
    command = ["g++", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c++"]
    subprocess.run([*command, str(SOURCES / "peer_drives.h")], check=True)


def test_the_drives_keep_no_state_and_call_nothing_but_memory_and_mathematics(
    parts: dict[str, Path],
) -> None:
    defined, called, takers = set(), set(), []
    for name, part in parts.items():
        listed = subprocess.run(["nm", str(part)], check=True, capture_output=True, text=True)
        symbols = re.findall(r" ([A-Za-z]) (\S+)$", listed.stdout, re.MULTILINE)
        assert [symbol for kind, symbol in symbols if kind in "BbDdCcGgSs"] == []
        defined |= {symbol for kind, symbol in symbols if kind in "TR"}
        wanted = {symbol for kind, symbol in symbols if kind == "U"}
        takers += [name] * len(wanted & {"malloc", "calloc", "realloc"})
        called |= wanted
    memory = {"calloc", "free", "memcpy", "memset", "memmove", "memcmp"}
    mathematics = {"floor", "fmin", "fmax", "llround"}
    assert called - defined <= memory | mathematics | {"_GLOBAL_OFFSET_TABLE_"}
    assert takers == ["peer.c"], "memory is taken in peer_new() only"


STRUCTURES = {
    "peer_frame": peer_drives.RawFrame,
    "peer_variation": peer_drives.Variation,
    "peer_drive": peer_drives.Drive,
    "peer_bus_variation": peer_drives.BusVariation,
    "peer_bus": peer_drives.Bus,
    "peer_timing": peer_drives.Timing,
    "peer_config": peer_drives.Config,
    "peer_counters": peer_drives.Counters,
    "peer_bus_counters": peer_drives.BusCounters,
}


def test_python_has_the_structures_of_the_header(tmp_path: Path) -> None:
    lines = []
    for name, structure in STRUCTURES.items():
        lines.append(f'_Static_assert(sizeof({name}) == {ctypes.sizeof(structure)}, "{name}");')
        for field, *_ in structure._fields_:
            offset = getattr(structure, field).offset
            lines.append(f'_Static_assert(offsetof({name}, {field}) == {offset}, "{field}");')
    path = tmp_path / "layout.c"
    path.write_text('#include "peer_drives.h"\n' + "\n".join(lines))
    subprocess.run(["gcc", "-std=c11", f"-I{SOURCES}", "-fsyntax-only", str(path)], check=True)
    header = (SOURCES / "peer_drives.h").read_text()
    declared = re.findall(r"^[a-z][\w ]*\W(peer_\w+)\(", header, re.MULTILINE)
    assert set(declared) == set(peer_drives.SIGNATURES)


def test_eight_drives_at_1_khz_take_less_than_a_twentieth_of_their_time(tmp_path: Path) -> None:
    """Of the processor's time, so that it does not matter what else runs."""
    program = tmp_path / "speed"
    files = [str(SPEED), *map(str, sources())]
    command = ["gcc", "-std=c11", "-O2", f"-I{SOURCES}", "-o", str(program), *files, "-lm"]
    subprocess.run(command, check=True)
    said = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout
    assert float(said) > 20, "times faster than real time"

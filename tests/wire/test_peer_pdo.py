"""PDOs of the drives by another hand: configuration and SYNC, against CiA 301."""

from __future__ import annotations

import itertools
import struct

import pytest
from peer_bench import CST, ENABLE, PRE_OPERATIONAL, START, Bench, Refused, drive, varied
from peer_drives import MICROSECOND, MILLISECOND, Frame, Library, Timing

INVALID = 0x80000000
NO_OBJECT, NO_SUB, NOT_MAPPABLE, MAP_LENGTH = 0x06020000, 0x06090011, 0x06040041, 0x06040042
RANGE, STATE, COUNT_FIRST, NMT_STATE = 0x06090030, 0x08000022, 0x06010003, 0x0F00FFC0


@pytest.fixture(scope="module")
def library() -> Library:
    return Library()


@pytest.fixture
def bench(library: Library) -> Bench:
    return Bench(library)


def refused(bench: Bench, index: int, sub: int, value: int) -> int:
    before = bench.peer.object(0, index, sub)
    with pytest.raises(Refused) as refusal:
        bench.write(index, sub, value)
    assert bench.peer.object(0, index, sub) == before
    return refusal.value.code


def test_the_procedure_of_the_standard_sets_every_pdo(bench: Bench) -> None:
    for n in (1, 2, 3, 4):
        bench.map_pdo("rpdo", n, n, [0x60400010, 0x60710010, 0x607A0020])
        bench.map_pdo("tpdo", n, n, [0x60410010, 0x60640020, 0x60770010])
        assert bench.read(0x1400 + n - 1, 1) == 0x101 + 0x100 * n
        assert bench.read(0x1800 + n - 1, 1) == 0x40000081 + 0x100 * n
        assert bench.read(0x1A00 + n - 1, 0) == 3
        assert bench.read(0x1A00 + n - 1, 3) == 0x60770010


@pytest.mark.parametrize(
    "identifier",
    [0, 1, 0x101, 0x180, 0x581, 0x5FF, 0x601, 0x67F, 0x6E0, 0x701, 0x77F, 0x780, 0x7FF],
)
def test_a_restricted_identifier_is_refused(bench: Bench, identifier: int) -> None:
    bench.write(0x1400, 1, INVALID | 0x201)
    bench.write(0x1800, 1, INVALID | 0x40000181)
    assert refused(bench, 0x1400, 1, identifier) == RANGE
    assert refused(bench, 0x1800, 1, 0x40000000 | identifier) == RANGE


def test_a_valid_pdo_keeps_its_identifier_mapping_and_inhibit_time(bench: Bench) -> None:
    assert refused(bench, 0x1400, 1, 0x202) == STATE
    assert refused(bench, 0x1800, 1, 0x40000182) == STATE
    assert refused(bench, 0x1800, 3, 0) == STATE
    assert refused(bench, 0x1600, 0, 0) == STATE
    assert refused(bench, 0x1A00, 1, 0x60640020) == STATE
    bench.write(0x1400, 1, 0x201)  # the same
    bench.write(0x1400, 1, INVALID | 0x202)
    bench.write(0x1400, 1, 0x202)


def test_extended_identifiers_and_remote_requests_are_refused(bench: Bench) -> None:
    bench.write(0x1400, 1, INVALID | 0x201)
    bench.write(0x1800, 1, INVALID | 0x40000181)
    assert refused(bench, 0x1400, 1, 0x20000201) == RANGE
    assert refused(bench, 0x1800, 1, 0x60000181) == RANGE
    assert refused(bench, 0x1800, 1, 0x00000181) == RANGE


@pytest.mark.parametrize(
    ("type_", "legal"),
    [
        (0, True),
        (1, True),
        (240, True),
        (241, False),
        (251, False),
        (252, False),
        (253, False),
        (254, True),
        (255, True),
    ],
)
def test_a_transmission_type_is_of_the_standards_table(
    bench: Bench, type_: int, legal: bool
) -> None:
    for index in (0x1402, 0x1802):
        if legal:
            bench.write(index, 2, type_)
            assert bench.read(index, 2, signed=False) == type_
        else:
            assert refused(bench, index, 2, type_) == RANGE


@pytest.mark.parametrize(
    ("entry", "code"),
    [
        (0x72340010, NO_OBJECT),
        (0x00050008, NO_OBJECT),  # no dummy mapping
        (0x60400110, NO_SUB),
        (0x60410010, NOT_MAPPABLE),  # into the wrong direction
        (0x10170010, NOT_MAPPABLE),
        (0x60850020, None),
        (0x60400008, NOT_MAPPABLE),  # not as long
    ],
)
def test_what_cannot_be_received_is_not_mapped(bench: Bench, entry: int, code: int | None) -> None:
    bench.write(0x1400, 1, INVALID | 0x201)
    assert refused(bench, 0x1600, 1, 0x60710010) == COUNT_FIRST
    bench.write(0x1600, 0, 0)
    if code is None:
        bench.write(0x1600, 1, entry)
    else:
        assert refused(bench, 0x1600, 1, entry) == code


def test_what_cannot_be_sent_is_not_mapped(bench: Bench) -> None:
    bench.write(0x1A01, 0, 0)
    assert refused(bench, 0x1A01, 1, 0x60400010) == NOT_MAPPABLE
    assert refused(bench, 0x1A01, 1, 0x60760020) == NOT_MAPPABLE
    bench.write(0x1A01, 1, 0x603F0010)
    bench.write(0x1A01, 2, 0x30D10220)
    bench.write(0x1A01, 3, 0x32000110)
    bench.write(0x1A01, 0, 3)


def test_a_mapping_has_at_most_eight_bytes_and_only_what_there_is(bench: Bench) -> None:
    bench.write(0x1A01, 0, 0)
    for sub, entry in enumerate([0x60640020, 0x60640020, 0x60410010], start=1):
        bench.write(0x1A01, sub, entry)
    assert refused(bench, 0x1A01, 0, 3) == MAP_LENGTH
    assert refused(bench, 0x1A01, 0, 4) == NO_OBJECT
    assert refused(bench, 0x1A01, 0, 13) == MAP_LENGTH
    bench.write(0x1A01, 0, 2)


def test_parameters_are_not_for_writing_while_operational(bench: Bench) -> None:
    bench.nmt(START)
    for index, sub in ((0x1400, 1), (0x1402, 2), (0x1600, 0), (0x1801, 3), (0x1A03, 1)):
        assert refused(bench, index, sub, 0) == NMT_STATE


def setpoint(bench: Bench, torque: int) -> None:
    bench.send(0x201, struct.pack("<Hh", ENABLE, torque))
    bench.wait(0.5)


def sync(bench: Bench) -> None:
    bench.send(0x80)
    bench.wait(0.5)


def test_a_synchronous_rpdo_is_applied_at_the_next_sync(library: Library) -> None:
    bench = Bench(library).enabled()
    setpoint(bench, 100)
    bench.wait(5)
    assert bench.peer.torque(0) == 0
    sync(bench)
    assert bench.peer.torque(0) == pytest.approx(0.1 * 0.09)
    bench.wait(5)
    assert bench.read(0x6071) == 100


def test_a_tpdo_says_what_was_before_the_rpdo_of_the_same_sync(library: Library) -> None:
    bench = Bench(library)
    bench.configure()
    bench.map_pdo("tpdo", 1, 1, [0x60410010, 0x60770010])
    bench.nmt(START)
    seen = []
    for word in (6, 7, 15, 15, 15, 15):
        bench.cycle(struct.pack("<Hh", word, 100))
        seen.append(struct.unpack("<Hh", bench.frames(0x181)[-1].data))
    states = [word & 0x6F for word, _ in seen]
    assert states == [0x40, 0x40, 0x21, 0x23, 0x27, 0x27], "applied at k+1, seen at k+2"
    bench.cycle(struct.pack("<Hh", 15, -50))
    torques = []
    for _ in range(3):
        bench.cycle(struct.pack("<Hh", 15, -50))
        torques.append(struct.unpack("<Hh", bench.frames(0x181)[-1].data)[1])
    assert torques == [100, -50, -50]


def test_only_the_newest_of_several_rpdos_is_applied(library: Library) -> None:
    bench = Bench(library).enabled()
    for torque in (100, 200, -300):
        setpoint(bench, torque)
    sync(bench)
    assert bench.peer.object(0, 0x6071) == -300
    counted = bench.peer.counted(0)
    sync(bench)
    assert bench.peer.counted(0).doubled == counted.doubled
    assert counted.doubled == 1


def test_an_rpdo_of_before_is_not_applied_again(library: Library) -> None:
    bench = Bench(library).enabled()
    setpoint(bench, 100)
    sync(bench)
    bench.write(0x6071, 0, 50)
    sync(bench)
    assert bench.peer.object(0, 0x6071) == 50


def test_an_asynchronous_rpdo_is_applied_at_once(bench: Bench) -> None:
    bench.configure()
    bench.write(0x1400, 2, 255)
    bench.nmt(START)
    setpoint(bench, 321)
    assert bench.peer.object(0, 0x6071) == 321


@pytest.mark.parametrize("state", [PRE_OPERATIONAL, 0x02])
def test_pdos_pass_only_while_operational(bench: Bench, state: int) -> None:
    bench.configure()
    bench.nmt(START)
    bench.nmt(state)
    count = len(bench.frames(0x181))
    setpoint(bench, 100)
    sync(bench)
    assert len(bench.frames(0x181)) == count
    assert bench.peer.object(0, 0x6071) == 0


def test_stray_rpdos_of_the_factory_act_until_they_are_made_invalid(bench: Bench) -> None:
    bench.nmt(START)
    bench.send(0x401, struct.pack("<Hi", 6, 1234))
    bench.wait(1)
    assert bench.peer.object(0, 0x6040) == 6 and bench.peer.object(0, 0x607A) == 1234
    bench.nmt(PRE_OPERATIONAL)
    bench.configure()
    bench.nmt(START)
    bench.send(0x401, struct.pack("<Hi", 7, 4321))
    bench.wait(1)
    assert bench.peer.object(0, 0x6040) == 6


def test_an_invalid_pdo_is_neither_sent_nor_received(bench: Bench) -> None:
    bench.configure()
    bench.write(0x1400, 1, INVALID | 0x201)
    bench.write(0x1800, 1, INVALID | 0x40000181)
    bench.nmt(START)
    setpoint(bench, 7)
    sync(bench)
    sync(bench)
    assert bench.frames(0x181) == [] and bench.peer.object(0, 0x6071) == 0


def test_an_rpdo_with_less_than_is_mapped_is_an_error_and_one_with_more_is_not(
    library: Library,
) -> None:
    bench = Bench(library).enabled()
    bench.send(0x201, struct.pack("<Hhi", ENABLE, 55, -1))
    sync(bench)
    assert bench.peer.object(0, 0x6071) == 55 and bench.frames(0x81) == []
    bench.send(0x201, b"\x0f\0")
    bench.wait(50)
    assert bench.frames(0x81)[0].data[:2] == b"\x10\x82"
    assert bench.peer.counted(0).short_pdos == 1
    assert not bench.peer.object(0, 0x6041) & 4


@pytest.mark.parametrize("every", [1, 2, 3, 10])
def test_a_synchronous_tpdo_comes_with_every_nth_sync(bench: Bench, every: int) -> None:
    bench.configure()
    bench.map_pdo("tpdo", 2, every, [0x603F0010, 0x32000110])
    bench.nmt(START)
    came = []
    for k in range(1, 31):
        if 0x281 in bench.cycle(b"\0\0\0\0"):
            came.append(k)
    assert came == list(range(every, 31, every))
    assert len(bench.frames(0x181)) == 30


def test_an_acyclic_tpdo_comes_with_a_sync_after_a_change(bench: Bench) -> None:
    bench.configure()
    bench.map_pdo("tpdo", 2, 0, [0x60410010])
    bench.nmt(START)
    for _ in range(5):
        bench.cycle(b"\0\0\0\0")
    assert len(bench.frames(0x281)) == 1
    bench.command(6)
    assert len(bench.frames(0x281)) == 2


def test_an_event_driven_tpdo_comes_at_the_start_and_at_changes_but_not_more_often_than_allowed(
    library: Library,
) -> None:
    for jitter in (0, 3 * MILLISECOND):
        bench = Bench(library, [varied(status_toggle=0x80, inhibit_jitter=jitter)])
        bench.write(0x1800, 1, INVALID | 0x40000181)
        bench.write(0x1800, 3, 50)
        bench.write(0x1800, 1, 0x40000181)
        bench.nmt(START)
        assert bench.frames(0x181) == [Frame(0x181, b"\x40\x02")]
        for _ in range(400):
            sync(bench)  # each sample of the statusword is another
        at = [time for time, frame in bench.heard if frame.id == 0x181]
        between = [b - a for a, b in itertools.pairwise(at)]
        assert min(between) >= 5 * MILLISECOND
        assert (max(between) > 6 * MILLISECOND) == (jitter > 0)


def test_positions_are_sampled_at_the_sync(library: Library) -> None:
    bench = Bench(library).ready()
    quarter = 0.5 * 3.141592653589793
    start = bench.peer.now
    bench.peer.turn(0, start, 0.0)
    bench.peer.turn(0, start + MILLISECOND, quarter)
    bench.peer.run(start + 400 * MICROSECOND)
    bench.send(0x80)
    bench.wait(3)
    position = int.from_bytes(bench.frames(0x181)[-1].data[2:], "little", signed=True)
    on_wire = library.bits(Frame(0x80)) - 3
    assert position == (400 + on_wire) * 500 // 1000


def test_answers_take_up_to_their_delay_in_any_order(library: Library) -> None:
    def orders(any_order: bool, worst: bool = False) -> set[tuple[int, ...]]:
        timing = Timing(answer_delay=300 * MICROSECOND, seed=5, worst=worst)
        bench = Bench(library, [varied(any_order=any_order)], timing)
        bench.configure()
        bench.map_pdo("tpdo", 2, 1, [0x603F0010])
        bench.map_pdo("tpdo", 3, 1, [0x60770010])
        bench.nmt(START)
        found = set()
        for _ in range(50):
            bench.heard.clear()
            start = bench.peer.now
            bench.cycle(b"\0\0\0\0")
            found.add(tuple(frame.id for _, frame in bench.heard))
            least = 300 * MICROSECOND if worst else 0
            assert all(time - start > least for time, _ in bench.heard)
        return found

    assert orders(False) == {(0x181, 0x281, 0x381)}
    assert len(orders(True)) > 3
    assert orders(True, worst=True) == {(0x181, 0x281, 0x381)}


def test_setpoints_lost_doubled_and_late_are_counted(library: Library) -> None:
    timing = Timing(setpoint_deadline=400 * MICROSECOND)
    bench = Bench(library, timing=timing).enabled()
    before = bench.peer.counted(0)
    target = struct.pack("<Hh", ENABLE, 0)
    for _ in range(10):
        bench.cycle(target)
    bench.cycle(target, period=0.8)
    bench.send(0x201, target)  # a second one, 0.8 ms after the SYNC
    bench.wait(0.2)
    bench.cycle()
    bench.cycle()  # and none at all
    bench.cycle(target)
    after = bench.peer.counted(0)
    assert after.syncs - before.syncs == 14
    assert after.setpoints - before.setpoints == 13
    assert after.doubled - before.doubled == 1
    assert after.late - before.late == 1
    assert after.lost - before.lost == 2
    assert 800 * MICROSECOND < after.latest_setpoint < 900 * MICROSECOND
    assert before.lost == 0 == before.doubled == before.late


def test_drives_may_share_one_rpdo(library: Library) -> None:
    bench = Bench(library, [drive(node=1), drive(node=2)])
    slots = ([0x60710010, 0x60680010], [0x60680010, 0x60710010])
    for number, entries in enumerate(slots):
        bench.configure(number=number)
        bench.map_pdo("rpdo", 2, 1, entries, number)
        bench.write(0x1401, 1, INVALID | 0x3FF, number)
        bench.write(0x1401, 1, 0x3FF, number)
    bench.nmt(START)
    bench.send(0x3FF, struct.pack("<hh", 11, -22))
    sync(bench)
    assert [bench.peer.object(number, 0x6071) for number in (0, 1)] == [11, -22]


def test_a_target_out_of_range_and_a_mode_that_is_none_stay_out(bench: Bench) -> None:
    bench.configure(CST)
    bench.map_pdo("rpdo", 2, 1, [0x60600008])
    bench.nmt(START)
    bench.send(0x301, b"\x07")
    sync(bench)
    assert bench.peer.object(0, 0x6060) == CST

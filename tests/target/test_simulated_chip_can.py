"""The CAN controllers of the simulated chip, and the buses that they are on."""

from itertools import pairwise

import peer_drives
import pytest
from compiled_firmware import image, report
from frames import classic_frames
from hypothesis import given, settings
from stm32g474 import Chip, Frame
from stm32g474.frame import bits_of, worst_bits_of

MICROSECOND, MILLISECOND = 1_000, 1_000_000
#: A controller on its bus: queue mode, everything into the first FIFO.
START = "clock_170(); can_pins(); can_configure(1, ONE_MEGABIT, QUEUE, 0); can_start(1);"
#: Until it takes part: the crystal, the PLL, and eleven bits.
STARTED = 3 * MILLISECOND
SEND = START + "can_send(1, 0x201, 4, 0x04030201, 0);"
SENT = Frame(0x201, bytes([1, 2, 3, 4]))
#: Sends 0x201 for ever, as fast as it goes, and reports PSR, ECR, CCCR and IR each time.
SEND_ALL = f"""{START}
    for (;;) {{
        if (CAN(1, TXBRP) == 0) {{ can_put(1, 0, 0x201, 4, 0x04030201, 0); }}
        REPORT[0] = CAN(1, PSR);
        REPORT[1] = CAN(1, ECR);
        REPORT[2] = CAN(1, CCCR);
        REPORT[3] = CAN(1, IR);
        REPORT[4] = CAN(1, TXBRP);
    }}"""
WAIT = START + " for (;;) { REPORT[0] = CAN(1, PSR); REPORT[1] = CAN(1, ECR); }"
BUS_OFF, PASSIVE, WARNING = 0x80, 0x20, 0x40


def chip(body: str, until: int = STARTED, more: str = "") -> Chip:
    """A chip that has run a firmware for a time [ns]."""
    made = Chip(image(body, more))
    made.run_until(until)
    return made


@settings(max_examples=200)
@given(classic_frames())
def test_frames_are_as_long_as_by_another_hand(message: object) -> None:
    """The bits of tests/wire/peer_drives, less the three between frames."""
    identifier, data = message.arbitration_id, bytes(message.data)  # type: ignore[attr-defined]
    extended, remote = message.is_extended_id, message.is_remote_frame  # type: ignore[attr-defined]
    length = message.dlc  # type: ignore[attr-defined]
    ours = Frame(identifier, data, extended, remote, length)
    theirs = peer_drives.Frame(identifier, data, extended, remote, length)
    library = peer_drives.Library()
    assert bits_of(ours) + 3 == library.bits(theirs)
    assert worst_bits_of(ours) + 3 == library.bits_worst(theirs)


def test_a_frame_takes_its_bits_on_the_wire() -> None:
    made = chip(SEND_ALL, 5 * MILLISECOND)
    times = [sent.time for sent in made.buses[0].taken()]
    assert len(times) > 15
    steps = {later - sooner for sooner, later in pairwise(times)}
    assert min(steps) >= (bits_of(SENT) + 3) * MICROSECOND
    assert min(steps) < (bits_of(SENT) + 6) * MICROSECOND


def test_a_bus_with_the_longest_frames_is_slower() -> None:
    made = Chip(image(SEND_ALL))
    made.buses[0].worst_stuffing = True
    made.run_until(5 * MILLISECOND)
    first, second, *_ = made.buses[0].taken()
    assert second.time - first.time >= (worst_bits_of(SENT) + 3) * MICROSECOND


def test_each_controller_is_on_its_own_bus() -> None:
    body = "clock_170(); can_pins();" + "".join(
        f"can_configure({n}, ONE_MEGABIT, QUEUE, 0); can_start({n}); can_send({n}, {n}, 0, 0, 0);"
        for n in (1, 2, 3)
    )
    made = chip(body)
    assert [[s.frame for s in bus.taken()] for bus in made.buses] == [
        [Frame(1)],
        [Frame(2)],
        [Frame(3)],
    ]


def test_the_bit_rate_is_that_of_prescaler_and_segments() -> None:
    made = chip(START)
    assert made.fdcan[0].bit_rate == pytest.approx(1e6)
    assert made.fdcan[0].understands


def test_a_bus_can_have_another_bit_rate() -> None:
    half = SEND.replace("ONE_MEGABIT", "1U << 25 | 19U << 16 | 13U << 8 | 1U")
    made = Chip(image(half), bit_rates=(500e3, 1e6, 1e6))
    made.run_until(STARTED)
    assert [sent.frame for sent in made.buses[0].taken()] == [SENT]


RECEIVE = f"""{START}
    for (uint32_t n = 0;;) {{
        uint32_t const s = CAN(1, RXF0S);
        REPORT[0] = s;
        if ((s & 15) == 0) {{ continue; }}
        uint32_t const at = RX0 + 72 * (s >> 8 & 3);
        REPORT[1] = RAM(1, at);
        REPORT[2] = RAM(1, at + 4);
        REPORT[3] = RAM(1, at + 8);
        CAN(1, RXF0A) = s >> 8 & 3;
        REPORT[4] = ++n;
        REPORT[4 + n] = REPORT[1] >> 18;
    }}"""


def test_a_frame_of_another_node_is_received_when_it_has_passed() -> None:
    made = chip(RECEIVE)
    made.buses[0].deliver(Frame(0x181, b"\x11\x22\x33\x44"))
    made.run_for((bits_of(Frame(0x181, b"\x11\x22\x33\x44")) - 2) * MICROSECOND)
    assert report(made, 0) & 15 == 0
    made.run_for(6 * MICROSECOND)
    assert report(made, 4) == 1
    assert report(made, 1) == 0x181 << 18
    assert report(made, 2) & 0xF0000 == 4 << 16
    assert report(made, 2) >> 31, "no filter matched"
    assert report(made, 3) == 0x44332211


def test_frames_come_in_the_order_of_their_identifiers() -> None:
    made = chip(RECEIVE)
    for identifier in (0x300, 0x100, 0x200):
        made.buses[0].deliver(Frame(identifier))
    made.run_for(MILLISECOND)
    assert [report(made, 5 + n) for n in range(3)] == [0x100, 0x200, 0x300]


def test_a_frame_delivered_for_later_waits_for_its_time() -> None:
    made = chip(RECEIVE)
    made.buses[0].deliver(Frame(0x181), made.time + MILLISECOND)
    made.run_for(MILLISECOND)
    assert report(made, 4) == 0 or made.buses[0].log == []
    made.run_for(MILLISECOND)
    assert len(made.buses[0].log) == 1


def test_a_fourth_frame_is_lost() -> None:
    made = chip(WAIT)
    for number in range(4):
        made.buses[0].deliver(Frame(0x100 + number))
    made.run_for(MILLISECOND)
    fifo = made.bus_read(0x40006490)
    assert fifo & 15 == 3 and fifo >> 24 & 3 == 3, "full, and one lost"
    assert made.bus_read(0x40006450) & 4
    assert made.bus_read(0x4000A400 + 0xB0) >> 18 == 0x100


def test_a_fourth_frame_replaces_the_first_when_that_is_chosen() -> None:
    body = START.replace("QUEUE, 0)", "QUEUE, 1U << 9)") + "for (;;) { }"
    made = chip(body)
    for number in range(4):
        made.buses[0].deliver(Frame(0x100 + number))
    made.run_for(MILLISECOND)
    fifo = made.bus_read(0x40006490)
    assert fifo & 15 == 3 and fifo >> 8 & 3 == 1
    assert made.bus_read(0x4000A400 + 0xB0) >> 18 == 0x103


FILTERS = """clock_170(); can_pins();
    /* all others are rejected; three standard filters, one extended */
    can_configure(1, ONE_MEGABIT, QUEUE, 2U << 4 | 2U << 2 | 3U << 16 | 1U << 24);
    RAM(1, STANDARD) = 2U << 30 | 1U << 27 | 0x180U << 16 | 0x780U; /* 0x180 to 0x1FF: first */
    RAM(1, STANDARD + 4) = 1U << 30 | 2U << 27 | 0x581U << 16 | 0x582U; /* these two: second */
    RAM(1, STANDARD + 8) = 0U << 30 | 3U << 27 | 0x700U << 16 | 0x77FU; /* a range: rejected */
    RAM(1, EXTENDED) = 1U << 29 | 0x1234567U; RAM(1, EXTENDED + 4) = 2U << 30 | 0x1FFFFFFFU;
    can_start(1);
    for (;;) { REPORT[0] = CAN(1, RXF0S); REPORT[1] = CAN(1, RXF1S); }"""


@pytest.mark.parametrize(
    ("frame", "first", "second", "match"),
    [
        (Frame(0x181), 1, 0, 0),
        (Frame(0x1FF), 1, 0, 0),
        (Frame(0x200), 0, 0, None),
        (Frame(0x581), 0, 1, 1),
        (Frame(0x582), 0, 1, 1),
        (Frame(0x583), 0, 0, None),
        (Frame(0x701), 0, 0, None),
        (Frame(0x1234567, extended=True), 1, 0, 0),
        (Frame(0x1234566, extended=True), 0, 0, None),
        (Frame(0x181, extended=True), 0, 0, None),
    ],
    ids=lambda value: f"{value.identifier:x}" if isinstance(value, Frame) else None,
)
def test_filters_sort_frames(frame: Frame, first: int, second: int, match: int | None) -> None:
    made = chip(FILTERS)
    made.buses[0].deliver(frame)
    made.run_for(MILLISECOND)
    assert (report(made, 0) & 15, report(made, 1) & 15) == (first, second)
    if match is not None:
        at = 0xB0 if first else 0x188
        assert made.bus_read(0x4000A400 + at + 4) >> 24 == match


@pytest.mark.parametrize(
    ("settings", "frame", "stored"),
    [
        (0, Frame(0x181, remote=True, length=8), 0x181 << 18 | 1 << 29),
        (2, Frame(0x181, remote=True, length=8), None),
        (1, Frame(0x181, remote=True, length=8), 0x181 << 18 | 1 << 29),
        (1, Frame(0x181, extended=True, remote=True, length=1), None),
        (0, Frame(0x181, extended=True, remote=True, length=1), 0x181 | 3 << 29),
        (3, Frame(0x181, bytes(8)), 0x181 << 18),
    ],
)
def test_remote_frames_are_told_apart_or_rejected(
    settings: int, frame: Frame, stored: int | None
) -> None:
    made = chip(START.replace("QUEUE, 0", f"QUEUE, {settings}"))
    made.buses[0].deliver(frame)
    made.run_for(MILLISECOND)
    if stored is None:
        assert made.bus_read(0x40006490) & 15 == 0
    else:
        assert made.bus_read(0x4000A400 + 0xB0) == stored
        assert made.bus_read(0x4000A400 + 0xB4) >> 16 & 15 == frame.length


#: Until the controller takes part, which it does after eleven bits.
JOIN = "wait_us(20);"
PUT_THREE = (
    "can_put(1, 0, 0x300, 0, 0, 0); can_put(1, 1, 0x100, 0, 0, 0); can_put(1, 2, 0x200, 0, 0, 0);"
)


@pytest.mark.parametrize(
    ("mode", "order"),
    [("QUEUE", [0x300, 0x100, 0x200]), ("0", [0x300, 0x100, 0x200])],
)
def test_the_first_of_three_requests_starts_at_once(mode: str, order: list[int]) -> None:
    made = chip(START.replace("QUEUE", mode) + JOIN + PUT_THREE)
    assert [sent.frame.identifier for sent in made.buses[0].taken()] == order


@pytest.mark.parametrize(
    ("mode", "order"), [("QUEUE", [0x100, 0x200, 0x300]), ("0", [0x300, 0x100, 0x200])]
)
def test_a_queue_sends_by_identifier_and_a_fifo_in_order(mode: str, order: list[int]) -> None:
    """The requests are there before the controller is on the bus."""
    start = START.replace("QUEUE", mode).replace(
        "can_start(1);", f"CAN(1, CCCR) = 1; {PUT_THREE} can_start(1);"
    )
    made = chip(start)
    assert [sent.frame.identifier for sent in made.buses[0].taken()] == order


def test_the_smaller_identifier_of_all_nodes_wins() -> None:
    made = Chip(image(START + PUT_THREE))
    made.run_until(2 * MILLISECOND)
    for identifier in (0x080, 0x180, 0x280):
        made.buses[0].deliver(Frame(identifier), 2_100_000)
    made.run_until(STARTED)
    order = [frame.identifier for _, _, frame in made.buses[0].log]
    assert sorted(order[1:]) == order[1:]
    assert len(order) == 6


def test_two_nodes_with_one_identifier_destroy_each_other() -> None:
    body = START + JOIN + "can_put(1, 1, 0x100, 8, 0, 0); can_put(1, 0, 0x181, 1, 1, 0);"
    made = Chip(image(body))
    while made.buses[0].idle:
        made.run_for(MICROSECOND)
    made.buses[0].deliver(Frame(0x181, b"\2"))
    made.run_for(MILLISECOND)
    assert made.buses[0].errors > 5
    assert [sent.frame.identifier for sent in made.buses[0].taken()] == [0x100]
    assert made.bus_read(0x40006440) & 0xFF >= 40


def test_a_pending_frame_is_cancelled() -> None:
    made = chip(START + JOIN + PUT_THREE + "CAN(1, TXBCR) = 4;")
    assert [sent.frame.identifier for sent in made.buses[0].taken()] == [0x300, 0x100]
    assert made.bus_read(0x400064D8) == 4
    assert made.bus_read(0x400064D4) == 3
    assert made.bus_read(0x400064C8) == 0


def test_a_request_cancelled_in_the_midst_of_a_fifo_leaves_a_hole() -> None:
    body = START.replace("QUEUE", "0") + JOIN + PUT_THREE
    made = chip(body + "CAN(1, TXBCR) = 2; REPORT[0] = CAN(1, TXFQS); wait_us(300);")
    assert report(made, 0) & 0x200007 == 0x200000, "full: its places are in order"
    assert [sent.frame.identifier for sent in made.buses[0].taken()] == [0x300, 0x200]


def test_the_free_level_of_a_queue_is_always_zero() -> None:
    made = chip(START + "REPORT[0] = CAN(1, TXFQS);")
    assert report(made, 0) == 0


def test_of_equal_identifiers_the_lower_buffer_goes_first_however_new() -> None:
    made = chip(
        START + JOIN + "can_put(1, 0, 0x100, 1, 0, 0); can_put(1, 1, 0x100, 1, 1, 0);"
        "while (CAN(1, TXBRP) & 1) { } can_put(1, 0, 0x080, 0, 0, 0); "
        "can_put(1, 2, 0x100, 1, 2, 0); wait_us(20);"
        "while (CAN(1, TXBRP) & 1) { } can_put(1, 0, 0x100, 1, 3, 0); wait_us(400);"
    )
    order = [sent.frame.data for sent in made.buses[0].taken() if sent.frame.data]
    assert sorted(order) == [b"\0", b"\1", b"\2", b"\3"]
    assert order.index(b"\3") < order.index(b"\2")


def test_a_frame_on_the_wire_is_sent_although_it_is_cancelled() -> None:
    made = chip(START + "can_put(1, 1, 0x100, 0, 0, 0); wait_us(20); CAN(1, TXBCR) = 2;")
    assert len(made.buses[0].taken()) == 1
    assert (made.bus_read(0x400064D8), made.bus_read(0x400064D4)) == (2, 2)


def test_frames_are_stamped_with_their_bit() -> None:
    body = START.replace("can_start", "CAN(1, 0x20) = 1; can_start") + JOIN + "CAN(1, 0x24) = 0;"
    made = chip(body)
    made.run_until(4 * MILLISECOND)
    begin = made.bus_read(0x40006424)
    made.buses[0].deliver(Frame(0x181))
    made.run_for(MILLISECOND)
    assert made.bus_read(0x40006424) - begin in (1000, 1001)
    stamp = made.bus_read(0x4000A4B4) & 0xFFFF
    assert stamp - begin == pytest.approx(bits_of(Frame(0x181)), abs=1)


def test_events_tell_what_was_sent() -> None:
    body = START + "RAM(1, TX) = 0x123U << 18; RAM(1, TX + 4) = 0x5AU << 24 | 1U << 23;"
    made = chip(body + "CAN(1, TXBAR) = 1;")
    assert made.bus_read(0x400064E4) & 7 == 1
    assert made.bus_read(0x4000A400 + 0x260) == 0x123 << 18
    assert made.bus_read(0x4000A400 + 0x264) >> 22 == 0x5A << 2 | 1


def test_without_anyone_to_acknowledge_it_sends_for_ever_and_stays_passive() -> None:
    made = Chip(image(SEND_ALL))
    made.buses[0].acknowledged = False
    made.run_until(20 * MILLISECOND)
    assert report(made, 0) & (PASSIVE | WARNING | BUS_OFF) == PASSIVE | WARNING
    assert report(made, 1) & 0xFF == 128
    assert report(made, 4) == 1
    assert made.buses[0].taken() == []
    made.buses[0].acknowledged = True
    made.run_for(MILLISECOND)
    assert len(made.buses[0].taken()) > 3
    assert report(made, 1) & 0xFF < 128


def test_attempts_without_acknowledgement_take_their_bits() -> None:
    """To the slot of the acknowledgement, flags and delimiter, the gap; passive ones wait more."""
    made = chip(SEND_ALL)
    made.buses[0].acknowledged = False
    attempt = bits_of(SENT) - 8 + 20 + 3
    made.run_for(16 * attempt * MICROSECOND)
    assert made.buses[0].errors in (15, 16)
    made.run_for(MILLISECOND)
    before = made.buses[0].errors
    made.run_for(40 * (attempt + 8) * MICROSECOND)
    assert made.buses[0].errors - before in (40, 41)


def test_an_unacknowledged_frame_is_sent_once_when_that_is_chosen() -> None:
    body = START.replace("can_start", "CAN(1, CCCR) |= 1U << 6; can_start")
    made = Chip(
        image(body + "can_put(1, 0, 0x100, 0, 0, 0); for (;;) { REPORT[0] = CAN(1, PSR); }")
    )
    made.buses[0].acknowledged = False
    made.run_until(5 * MILLISECOND)
    assert made.bus_read(0x400064C8) == 0
    assert (made.bus_read(0x400064D8), made.bus_read(0x400064D4)) == (1, 0)
    assert made.bus_read(0x40006440) & 0xFF == 8


def test_a_destroyed_frame_is_sent_again() -> None:
    made = Chip(image(SEND))
    made.buses[0].disturb(2)
    made.run_until(STARTED)
    assert made.buses[0].errors == 2
    assert [sent.frame for sent in made.buses[0].taken()] == [SENT]
    assert made.bus_read(0x40006440) & 0xFF == 15, "twice eight, less one"


def test_a_destroyed_frame_of_another_node_counts_and_comes_again() -> None:
    made = chip(RECEIVE)
    made.buses[0].disturb()
    made.buses[0].deliver(Frame(0x181))
    made.run_for(MILLISECOND)
    assert report(made, 4) == 1
    assert made.bus_read(0x40006450) & 1 << 21, "an error in the arbitration phase"


def test_bus_off_sets_init_and_ends_only_by_software() -> None:
    made = chip(SEND_ALL)
    made.buses[0].disturb(32)
    made.run_for(10 * MILLISECOND)
    assert report(made, 0) & BUS_OFF
    assert report(made, 2) & 1
    assert report(made, 4) == 1, "the request stays"
    made.buses[0].taken()
    made.run_for(50 * MILLISECOND)
    assert made.buses[0].taken() == []


RECOVER = SEND_ALL.replace(
    "REPORT[4]",
    """if (CAN(1, CCCR) & 1) { REPORT[5] = TIM2(0x24); can_start(1);
           while (CAN(1, PSR) & 0x80) { }
           REPORT[6] = TIM2(0x24); }
       REPORT[4]""",
).replace("for (;;)", "wait_us(1); for (;;)", 1)


def test_recovery_takes_129_times_eleven_recessive_bits() -> None:
    made = chip(RECOVER)
    made.buses[0].disturb(32)
    made.run_for(10 * MILLISECOND)
    assert 129 * 11 - 1 <= report(made, 6) - report(made, 5) <= 129 * 11 + 3
    assert report(made, 1) & 0x7FFF == 0
    assert len(made.buses[0].taken()) > 3, "what was pending is sent"


def test_traffic_of_others_lengthens_recovery() -> None:
    made = chip(RECOVER)
    made.buses[0].disturb(32)
    while not made.fdcan[0].bus_off:
        made.run_for(10 * MICROSECOND)
    frame = Frame(0x700, bytes(8))
    for _ in range(40):
        made.buses[0].deliver(frame)
    made.run_for(20 * MILLISECOND)
    # A frame is one sequence of eleven bits, at its end, as the gap to the next is.
    expected = 40 * (bits_of(frame) + 3) + (129 - 40) * 11
    assert expected - 200 <= report(made, 6) - report(made, 5) <= expected + 60


def test_a_bus_that_stays_dominant_takes_a_sender_off_and_no_recovery_ends() -> None:
    made = chip(RECOVER)
    made.run_for(60_000)
    made.buses[0].stuck_dominant = True
    made.run_for(20 * MILLISECOND)
    assert made.bus_read(0x40006444) & BUS_OFF
    assert made.fdcan[0].bus_off
    made.buses[0].stuck_dominant = False
    made.buses[0].taken()
    made.run_for(3 * MILLISECOND)
    assert not made.fdcan[0].bus_off
    assert len(made.buses[0].taken()) > 3


def test_a_bus_that_stays_dominant_makes_a_listener_passive() -> None:
    made = chip(WAIT)
    made.buses[0].stuck_dominant = True
    made.run_for(5 * MILLISECOND)
    assert report(made, 0) & PASSIVE
    assert report(made, 1) >> 15 & 1
    assert not report(made, 0) & BUS_OFF


def test_after_a_bus_was_dominant_nobody_sends_for_eleven_bits() -> None:
    made = chip(WAIT)
    made.buses[0].stuck_dominant = True
    made.buses[0].deliver(Frame(0x181))
    made.run_for(MILLISECOND)
    released = made.time
    made.buses[0].stuck_dominant = False
    made.run_for(MILLISECOND)
    ((passed, _, frame),) = made.buses[0].log
    assert passed - released == (11 + bits_of(frame)) * MICROSECOND


@pytest.mark.parametrize(
    "nbtp",
    [
        "1U << 25 | 19U << 16 | 13U << 8 | 1U",  # half the rate
        "1U << 25 | 9U << 16 | 14U << 8 | 1U",  # a quantum too long
        "1U << 25 | 9U << 16 | 4U << 8 | 10U",  # sampled before the other end is heard
    ],
)
def test_other_bits_than_those_of_the_bus_end_in_bus_off(nbtp: str) -> None:
    made = Chip(image(SEND_ALL.replace("ONE_MEGABIT", nbtp)))
    made.run_until(12 * MILLISECOND)
    assert made.fdcan[0].bus_off
    assert made.buses[0].taken() == []


def test_a_listener_with_other_bits_disturbs_until_it_is_passive() -> None:
    made = chip(WAIT.replace("ONE_MEGABIT", "1U << 25 | 19U << 16 | 13U << 8 | 1U"))
    made.buses[0].deliver(Frame(0x181, bytes(8)))
    made.run_for(40 * MILLISECOND)
    assert made.buses[0].errors >= 100
    assert [frame for _, _, frame in made.buses[0].log] == [Frame(0x181, bytes(8))]
    assert made.bus_read(0x40006490) & 15 == 0
    assert report(made, 0) & PASSIVE


def test_the_internal_oscillator_is_too_far_off_for_a_megabit() -> None:
    """64 quanta of 16 MHz; within the jump width for a chip that is right, not for one at 0.8 %."""
    body = START.replace("clock_170();", "RCC(RCC_APB1ENR1) |= 1;").replace(
        "ONE_MEGABIT", "0U << 25 | 0U << 16 | 12U << 8 | 1U"
    )
    right, wrong = (Chip(image(body), hsi=hsi) for hsi in (16e6, 16.128e6))
    for made in (right, wrong):
        made.run_until(MILLISECOND)
    assert right.fdcan[0].understands
    assert not wrong.fdcan[0].understands


def test_a_cut_wire_looks_like_a_dead_bus() -> None:
    made = chip(SEND_ALL)
    made.buses[0].taken()
    made.buses[0].cut = True
    made.run_for(10 * MILLISECOND)
    made.buses[0].deliver(Frame(0x181))
    made.run_for(10 * MILLISECOND)
    assert report(made, 0) & PASSIVE
    assert made.bus_read(0x40006490) & 15 == 0


def test_a_lost_frame_never_comes() -> None:
    made = chip(RECEIVE)
    made.buses[0].lose()
    made.buses[0].deliver(Frame(0x181))
    made.buses[0].deliver(Frame(0x182))
    made.run_for(MILLISECOND)
    assert [frame.identifier for _, _, frame in made.buses[0].log] == [0x182]


@pytest.mark.parametrize(("enable", "flags"), [(0, 0), (1, 1 << 7)])
def test_a_frame_sent_is_flagged_only_where_that_is_enabled(enable: int, flags: int) -> None:
    made = chip(START + f"CAN(1, 0xDC) = {enable};" + PUT_THREE)
    assert len(made.buses[0].taken()) == 3
    assert made.bus_read(0x40006450) == flags


def test_flags_tell_a_change_of_the_error_state_and_are_cleared_by_ones() -> None:
    made = chip(WAIT)
    flags = []
    for tec, rec in ((95, 0), (96, 0), (127, 0), (128, 0), (128, 0), (100, 128), (0, 0), (256, 0)):
        made.fdcan[0].set_errors(tec, rec)
        flags.append(made.bus_read(0x40006450) >> 17)
        made.bus_write(0x40006450, 0xFFFFFF)
    passive, warning, off = 1, 2, 4
    assert flags == [0, warning, 0, passive, 0, 0, passive | warning, passive | warning | off]


def test_a_flag_is_cleared_alone() -> None:
    made = chip(WAIT)
    for number in range(4):
        made.buses[0].deliver(Frame(0x100 + number))
    made.run_for(MILLISECOND)
    made.bus_write(0x40006450, 4)
    assert made.bus_read(0x40006450) == 3
    assert not made.bus_read(0x40006490) >> 25 & 1


@pytest.mark.parametrize(
    ("spoil", "code"),
    [("acknowledged", 3), ("disturbed", 4)],
)
def test_the_last_error_tells_what_went_wrong(spoil: str, code: int) -> None:
    made = chip(SEND_ALL)
    if spoil == "acknowledged":
        made.buses[0].acknowledged = False
    else:
        made.buses[0].disturb(3)
    seen = set()
    for _ in range(300):
        made.run_for(MICROSECOND)
        seen.add(report(made, 0) & 7)
    assert code in seen
    assert not seen & {1, 2, 5, 6}


def test_reading_the_last_error_clears_it() -> None:
    made = chip(START)
    made.fdcan[0].receive_failed(stuff_error=True)
    assert made.bus_read(0x40006444) & 7 == 1
    assert made.bus_read(0x40006444) & 7 == 7
    assert made.bus_read(0x40006440) >> 16 == 1
    assert made.bus_read(0x40006440) >> 16 == 0


def test_setting_cce_forgets_requests_and_fifos() -> None:
    made = chip(
        START + PUT_THREE + "CAN(1, CCCR) |= 1; while (!(CAN(1, CCCR) & 1)) { }CAN(1, CCCR) |= 2;"
    )
    assert made.bus_read(0x400064C8) == 0
    made.run_for(MILLISECOND)
    assert len(made.buses[0].taken()) <= 1


def test_counted_identifiers_answer_a_sync_in_time() -> None:
    """A listener answers as drives do; the chip's cycle goes on beside."""
    body = START + "for (;;) { can_send(1, 0x80, 0, 0, 0); wait_us(1000); }"
    made = Chip(image(body))
    bus = made.buses[0]
    bus.listeners.append(lambda sent: bus.deliver(Frame(0x181, bytes(8))))
    made.run_until(20 * MILLISECOND)
    syncs = [time for time, own, _ in bus.log if own]
    assert all(999_000 < later - sooner < 1_004_000 for sooner, later in pairwise(syncs[1:]))
    assert len(syncs) > 15


def test_a_reset_in_the_midst_of_a_frame_breaks_it_off() -> None:
    made = chip(SEND_ALL)
    while made.buses[0].idle:
        made.run_for(MICROSECOND)
    made.buses[0].taken()
    made.buses[0].deliver(Frame(0x181))
    made.reset("pin")
    made.run_for(MILLISECOND)
    assert made.buses[0].errors == 1
    assert [(own, frame.identifier) for _, own, frame in made.buses[0].log][-1] == (False, 0x181)


def test_error_counters_can_be_set() -> None:
    made = chip(WAIT)
    made.fdcan[0].set_errors(130, 5)
    made.run_for(MILLISECOND)
    assert report(made, 0) & (PASSIVE | WARNING | BUS_OFF) == PASSIVE | WARNING
    assert report(made, 1) & 0x7FFF == 130 | 5 << 8

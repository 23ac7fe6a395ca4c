"""Defects that a driver of the board can have, for seeding: what differs from outside.

Written without a look at the driver. Each is a kind: its source patch is chosen where it is seeded.
A defect counts as found when a test of the firmware on the simulated chip fails, or the chip
refuses. `shown_by` names what proves that the chip itself tells the wrong use from the right one: a
use of test_simulated_chip_refuses.py, or a test of the simulated chip.
"""

from dataclasses import dataclass
from enum import Enum


class Seen(Enum):
    """Where a defect shows."""

    REFUSED = "the chip refuses: ChipFault"
    BUS = "frames on the bus: which, when, in which order"
    STATE = "what the firmware tells of itself: counters, states, results"
    RESET = "resets of the chip, and the cause that is told"
    LINE = "bytes on the serial line"


@dataclass(frozen=True)
class DriverDefect:
    """A kind of defect."""

    wrong: str
    seen: Seen
    differs: str
    shown_by: str


#: Start: clocks, voltage, pins, memory.
START = (
    DriverDefect(
        "boost mode is not switched on, or by the wrong bit of PWR_CR5 (it is bit 8)",
        Seen.REFUSED,
        "PWR_CR5: reserved bits changed, or 170 MHz with at most 150 MHz",
        "170 MHz without boost",
    ),
    DriverDefect(
        "the flash has a wait state too few for 170 MHz",
        Seen.REFUSED,
        "FLASH_ACR when the clock is raised",
        "too few wait states",
    ),
    DriverDefect(
        "the wait states are raised after the clock, not before it",
        Seen.REFUSED,
        "FLASH_ACR or PWR_CR5 at the write to RCC_CFGR",
        "too few wait states",
    ),
    DriverDefect(
        "the clock goes above 80 MHz in one step, or the half step is left at once",
        Seen.REFUSED,
        "RCC_CFGR",
        "170 MHz in one step",
    ),
    DriverDefect(
        "a factor or a divider of the PLL is off by one",
        Seen.BUS,
        "the controller understands no frame and is bus-off after 32 of its own; SYNC never comes",
        "test_other_bits_than_those_of_the_bus_end_in_bus_off",
    ),
    DriverDefect(
        "the crystal is waited for without an end",
        Seen.STATE,
        "with a crystal that never swings the firmware reports nothing instead of its cause",
        "test_a_crystal_that_never_swings_is_never_ready",
    ),
    DriverDefect(
        "without a crystal the internal oscillator is taken in silence",
        Seen.BUS,
        "bits are 0.8 % off: error frames on every bus instead of a start that is refused",
        "test_the_internal_oscillator_is_too_far_off_for_a_megabit",
    ),
    DriverDefect(
        "a pin of a controller has another function: FDCAN3 needs AF11, the others AF9",
        Seen.REFUSED,
        "FDCAN when INIT is cleared",
        "the wrong function of a pin",
    ),
    DriverDefect(
        "the clock of a peripheral is not on when it is used first",
        Seen.REFUSED,
        "the first access",
        "a controller without its clock",
    ),
    DriverDefect(
        "floating point is used before CPACR is written",
        Seen.REFUSED,
        "NOCP at the first such instruction",
        "floating point that is off",
    ),
)

#: Setting up a controller.
SETUP = (
    DriverDefect(
        "CCE is set without waiting for INIT",
        Seen.REFUSED,
        "FDCAN_CCCR",
        "CCE before INIT is read back",
    ),
    DriverDefect(
        "a segment of the bit time is written as it is, not less one",
        Seen.BUS,
        "no frame is understood; bus-off",
        "test_other_bits_than_those_of_the_bus_end_in_bus_off",
    ),
    DriverDefect(
        "the sample point is early, as with the two segments exchanged",
        Seen.BUS,
        "error frames on a bus with a long way to its other end",
        "test_other_bits_than_those_of_the_bus_end_in_bus_off",
    ),
    DriverDefect(
        "the kernel clock stays at the crystal while the bit timing is for PCLK1",
        Seen.BUS,
        "the bit rate is 24/170 of the wanted one: bus-off, and REC of silent nodes rises",
        "test_other_bits_than_those_of_the_bus_end_in_bus_off",
    ),
    DriverDefect(
        "the message RAM of the second and third controller is taken 0x400 apart, not 0x350",
        Seen.BUS,
        "frames of FDCAN2 and 3 are what the RAM held; the last buffers lie outside: refused",
        "beyond the message RAM",
    ),
    DriverDefect(
        "an element is taken as 64 or 16 bytes long, not 72",
        Seen.BUS,
        "every buffer but the first sends what the RAM held at power-on",
        "test_each_controller_is_on_its_own_bus",
    ),
    DriverDefect(
        "the message RAM is not cleared, and a filter more is enabled than written",
        Seen.STATE,
        "some identifiers vanish, others after the next power-on",
        "test_filters_sort_frames",
    ),
    DriverDefect(
        "frames that match no filter are rejected",
        Seen.STATE,
        "nothing is received: every drive is missing",
        "test_filters_sort_frames",
    ),
    DriverDefect(
        "automatic retransmission is off",
        Seen.BUS,
        "a frame that was destroyed once never comes: a setpoint or a SYNC is missing",
        "test_an_unacknowledged_frame_is_sent_once_when_that_is_chosen",
    ),
    DriverDefect(
        "two controllers are exchanged",
        Seen.BUS,
        "the frames of a bus are on another one",
        "test_each_controller_is_on_its_own_bus",
    ),
    DriverDefect(
        "what was set up is not read back",
        Seen.STATE,
        "with a bit of NBTP, RXGFC or TXBC that sticks, the start succeeds instead of naming it",
        "test_a_register_bit_can_stick",
    ),
)

#: Sending.
SENDING = (
    DriverDefect(
        "a standard identifier is not shifted to bit 18",
        Seen.REFUSED,
        "message RAM at the request",
        "an identifier at bit 0",
    ),
    DriverDefect(
        "bytes are packed in the other order, or a length code of another place",
        Seen.BUS,
        "data of frames are reversed in words; lengths are wrong",
        "test_a_frame_takes_its_bits_on_the_wire",
    ),
    DriverDefect(
        "a buffer is taken without a look at what is pending",
        Seen.REFUSED,
        "message RAM or TXBAR; only with three frames waiting",
        "a buffer whose frame is pending",
    ),
    DriverDefect(
        "stores are made twice: compiled without -fno-move-loop-stores",
        Seen.REFUSED,
        "TXBAR: pending already",
        "a request that is pending already",
    ),
    DriverDefect(
        "a FIFO is used in place of the queue",
        Seen.BUS,
        "a SYNC that follows an SDO request onto a busy bus comes after it, not before it",
        "test_a_queue_sends_by_identifier_and_a_fifo_in_order",
    ),
    DriverDefect(
        "with no buffer free, a frame is dropped and the result says that all is well",
        Seen.STATE,
        "on a dead bus nothing is counted as full; the fourth frame is missing later",
        "test_without_anyone_to_acknowledge_it_sends_for_ever_and_stays_passive",
    ),
    DriverDefect(
        "pending frames are not cancelled when the bus stops or is off",
        Seen.BUS,
        "after recovery a setpoint is sent that is older than the recovery",
        "test_recovery_takes_129_times_eleven_recessive_bits",
    ),
    DriverDefect(
        "the free level is asked of a queue, where it is always zero",
        Seen.BUS,
        "nothing is ever sent",
        "test_the_free_level_of_a_queue_is_always_zero",
    ),
    DriverDefect(
        "two frames of one identifier are in the queue at once",
        Seen.BUS,
        "the newer one, in the lower buffer, overtakes: segments or setpoints in a wrong order",
        "test_of_equal_identifiers_the_lower_buffer_goes_first_however_new",
    ),
    DriverDefect(
        "cancelling is not waited for: the buffer is written while its frame is on the wire",
        Seen.REFUSED,
        "message RAM: pending",
        "a buffer whose frame is pending",
    ),
)

#: Receiving.
RECEIVING = (
    DriverDefect(
        "an element is given back before it is read",
        Seen.REFUSED,
        "message RAM: not filled",
        "an element that was given back",
    ),
    DriverDefect(
        "the put index is given back in place of the get index, or the index is not counted on",
        Seen.REFUSED,
        "RXF0A: not in the FIFO; or one frame is received again and again",
        "giving back what is not there",
    ),
    DriverDefect(
        "one frame is taken in each turn of the loop, or none during a long computation",
        Seen.STATE,
        "three frames in a row and a fourth: one is lost",
        "test_a_fourth_frame_is_lost",
    ),
    DriverDefect(
        "a lost frame is not counted, or its flag is not cleared and it is counted for ever",
        Seen.STATE,
        "RF0L: the counter of lost frames stays, or goes on without frames",
        "test_a_fourth_frame_is_lost",
    ),
    DriverDefect(
        "flags are cleared by reading IR, or-ing and writing back",
        Seen.STATE,
        "all flags are cleared by the first: a lost frame beside another flag is never counted",
        "test_a_fourth_frame_is_lost",
    ),
    DriverDefect(
        "the second FIFO is never emptied",
        Seen.STATE,
        "with filters into both, those frames never arrive and then are lost",
        "test_filters_sort_frames",
    ),
    DriverDefect(
        "extended and remote frames are taken as standard data frames",
        Seen.STATE,
        "a frame 0x181 with 29 bits is taken for the one of a drive",
        "test_filters_sort_frames",
    ),
)

#: Errors of a bus.
ERRORS = (
    DriverDefect(
        "bus-off is never left: INIT is not cleared",
        Seen.BUS,
        "silence for ever after 32 destroyed frames",
        "test_bus_off_sets_init_and_ends_only_by_software",
    ),
    DriverDefect(
        "bus-off is left at once and again, without a pause",
        Seen.BUS,
        "with a node that destroys everything, 32 frames come in each 4 ms",
        "test_recovery_takes_129_times_eleven_recessive_bits",
    ),
    DriverDefect(
        "bus-off is taken for error passive, or the other way round",
        Seen.STATE,
        "bits 7, 6 and 5 of PSR: the state told on a dead bus and after 32 destroyed frames",
        "test_without_anyone_to_acknowledge_it_sends_for_ever_and_stays_passive",
    ),
    DriverDefect(
        "the counters of errors sent and received are exchanged",
        Seen.STATE,
        "ECR on a dead bus: 128 and 0",
        "test_without_anyone_to_acknowledge_it_sends_for_ever_and_stays_passive",
    ),
    DriverDefect(
        "PSR is read twice, the second time for its last error",
        Seen.STATE,
        "the last error is always 7, no change",
        "test_reading_the_last_error_clears_it",
    ),
    DriverDefect(
        "the end of bus-off is waited for without an end",
        Seen.RESET,
        "on a bus that stays dominant the loop stands still and the watchdog resets the chip",
        "test_a_bus_that_stays_dominant_takes_a_sender_off_and_no_recovery_ends",
    ),
    DriverDefect(
        "one bus that is off stops the work on the others",
        Seen.BUS,
        "no frames on the healthy buses",
        "test_each_controller_is_on_its_own_bus",
    ),
)

#: Time, watchdog, resets, the serial line.
BOARD = (
    DriverDefect(
        "the prescaler of the timer is written without an update",
        Seen.BUS,
        "the cycle is 170 times too fast until the counter ends",
        "test_a_prescaler_counts_from_the_next_update_on",
    ),
    DriverDefect(
        "times are compared, not their difference",
        Seen.BUS,
        "when the counter ends (32 bits of microseconds: 71.6 minutes), cycles stop or rush",
        "test_the_timer_and_the_chip_agree_on_the_time",
    ),
    DriverDefect(
        "the watchdog is never started, or its registers are written without the key",
        Seen.RESET,
        "a loop that stands still is never reset; or refused",
        "the watchdog without its key",
    ),
    DriverDefect(
        "the watchdog is fed where the loop waits, not where a cycle was done",
        Seen.RESET,
        "a loop that waits for ever is never reset",
        "test_the_watchdog_resets_unless_it_is_fed",
    ),
    DriverDefect(
        "the timeout of the watchdog is short for a fast slow oscillator",
        Seen.RESET,
        "at 34 kHz it resets a healthy loop",
        "test_a_fast_slow_oscillator_bites_sooner",
    ),
    DriverDefect(
        "the flags of resets are not removed, or removed before they are read",
        Seen.RESET,
        "the cause told after a second reset is that of the first; or none is told",
        "test_the_cause_of_a_reset_is_told_until_it_is_removed",
    ),
    DriverDefect(
        "the divider of the serial line is for another clock",
        Seen.LINE,
        "refused on a line of a given rate; bytes come too fast or too slow",
        "test_a_line_of_another_rate_is_refused",
    ),
    DriverDefect(
        "a byte is written without waiting for room",
        Seen.REFUSED,
        "TDR: a byte is lost",
        "a byte into a full port",
    ),
    DriverDefect(
        "sending to the line waits until all has been sent",
        Seen.BUS,
        "cycles come late while a long answer is sent",
        "test_bytes_go_in_and_out_at_the_rate_of_the_line",
    ),
    DriverDefect(
        "an overrun of the line is not cleared",
        Seen.LINE,
        "told for ever, or the rest of a command is taken for a whole one",
        "test_bytes_that_nobody_takes_are_overrun",
    ),
)

DEFECTS = (*START, *SETUP, *SENDING, *RECEIVING, *ERRORS, *BOARD)

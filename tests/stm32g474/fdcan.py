"""A CAN controller (FDCAN of the G4, a Bosch M_CAN), classic frames only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from stm32g474.frame import Frame
from stm32g474.gpio import need_pins
from stm32g474.message_ram import ELEMENT, RX_FIFO, TX_BUFFER, TX_EVENT, Message, MessageRam
from stm32g474.peripheral import Access, Peripheral, Register, Registers
from stm32g474.requests import BUFFERS, Requests
from stm32g474.schedule import Event

if TYPE_CHECKING:
    from stm32g474.bus import Bus
    from stm32g474.chip import Chip

#: CCCR.
INIT, CCE, ASM, CSA, CSR, MON, DAR, TEST = (1 << bit for bit in range(8))
FDOE, BRSE, PXHD, EFBI, TXP, NISO = 1 << 8, 1 << 9, 1 << 12, 1 << 13, 1 << 14, 1 << 15
#: Bits that are only set with INIT and CCE; ASM and MON may be cleared at any time.
PROTECTED = DAR | TEST | FDOE | BRSE | PXHD | EFBI | TXP | NISO
#: PSR.LEC.
NO_ERROR, STUFF, FORM, ACKNOWLEDGE, BIT_ONE, BIT_ZERO, CHECKSUM, UNCHANGED = range(8)
#: PSR.ACT.
SYNCHRONISING, IDLE, RECEIVER, TRANSMITTER = range(4)
#: IR.
NEW, FULL, LOST = 1, 2, 4
HPM, TC, TCF, TFE, TEFN, TEFF, TEFL = 1 << 6, 1 << 7, 1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12
ELO, EP, EW, BO, PEA = 1 << 16, 1 << 17, 1 << 18, 1 << 19, 1 << 21
DEPTH = 3
#: Sequences of eleven recessive bits that end the state bus-off.
RECOVERY = 129
#: Clocks of the kernel until INIT has arrived there and is read back.
ARRIVAL = 6
QUEUE = 1 << 24


@dataclass
class _Fifo:
    """Get index, put index and fill level of a ring of three."""

    get: int = 0
    fill: int = 0

    @property
    def put(self) -> int:
        return (self.get + self.fill) % DEPTH

    @property
    def full(self) -> bool:
        return self.fill == DEPTH

    def holds(self, index: int) -> bool:
        """Whether an element is filled."""
        return (index - self.get) % DEPTH < self.fill

    def add(self) -> int:
        """The place of one element more."""
        place = self.put
        self.fill += 1
        return place

    def release(self, index: int) -> None:
        """An element and those before it are free again."""
        count = (index - self.get) % DEPTH + 1
        self.get = (index + 1) % DEPTH
        self.fill -= count


class Fdcan(Peripheral):
    """FDCAN1, 2 or 3."""

    REGISTERS: ClassVar[Registers] = {
        "CREL": Register(0x000, reset=0x32141218, access=Access.READ),
        "ENDN": Register(0x004, reset=0x87654321, access=Access.READ),
        "DBTP": Register(0x00C, 0x009F1FFF, 0x00000A33),
        "TEST": Register(0x010, 0x000000F0, lasting=False),
        "RWD": Register(0x014, 0x0000FFFF),
        "CCCR": Register(0x018, 0x0000F3FF, 0x00000001),
        "NBTP": Register(0x01C, 0xFFFFFF7F, 0x06000A03),
        "TSCC": Register(0x020, 0x000F0003),
        "TSCV": Register(0x024, 0x0000FFFF, lasting=False),
        "TOCC": Register(0x028, 0xFFFF0007, 0xFFFF0000),
        "TOCV": Register(0x02C, 0x0000FFFF, 0x0000FFFF),
        "ECR": Register(0x040, 0x00FFFFFF, access=Access.READ),
        "PSR": Register(0x044, 0x007F7FFF, 0x00000707, access=Access.READ),
        "TDCR": Register(0x048, 0x00007F7F),
        "IR": Register(0x050, 0x00FFFFFF, access=Access.STROBE),
        "IE": Register(0x054, 0x00FFFFFF),
        "ILS": Register(0x058, 0x0000007F),
        "ILE": Register(0x05C, 0x00000003),
        "RXGFC": Register(0x080, 0x0F1F033F),
        "XIDAM": Register(0x084, 0x1FFFFFFF, 0x1FFFFFFF),
        "HPMS": Register(0x088, 0x00009FC7, access=Access.READ),
        "RXF0S": Register(0x090, 0x0303030F, access=Access.READ),
        "RXF0A": Register(0x094, 0x00000007),
        "RXF1S": Register(0x098, 0x0303030F, access=Access.READ),
        "RXF1A": Register(0x09C, 0x00000007),
        "TXBC": Register(0x0C0, QUEUE),
        "TXFQS": Register(0x0C4, 0x00230307, 0x00000003, access=Access.READ),
        "TXBRP": Register(0x0C8, 0x00000007, access=Access.READ),
        "TXBAR": Register(0x0CC, 0x00000007),
        "TXBCR": Register(0x0D0, 0x00000007),
        "TXBTO": Register(0x0D4, 0x00000007, access=Access.READ),
        "TXBCF": Register(0x0D8, 0x00000007, access=Access.READ),
        "TXBTIE": Register(0x0DC, 0x00000007),
        "TXBCIE": Register(0x0E0, 0x00000007),
        "TXEFS": Register(0x0E4, 0x03030307, access=Access.READ),
        "TXEFA": Register(0x0E8, 0x00000003),
        # Of all three controllers, and only there in the first.
        "CKDIV": Register(0x100, 0x0000000F),
    }

    def __init__(self, chip: Chip, number: int, bus: Bus, ram: MessageRam) -> None:
        self.number, self.bus, self.ram = number, bus, ram
        bus.node = self
        self.rx = [_Fifo(), _Fifo()]
        self.events = _Fifo()
        self._arriving: Event | None = None
        self._quiet: Event | None = None
        self._wanted = INIT
        self._understands: bool | None = None
        self._clear()
        super().__init__(chip, f"FDCAN{number}", 0x40006000 + 0x400 * number, ("APB1ENR1", 25))

    def _clear(self) -> None:
        self.tec = self.rec = self.logged = 0
        self.bus_off = self.takes_part = False
        self._recovered = self._stamped = 0
        self._last = UNCHANGED
        self._active: int | None = None
        self._restart_tables()

    def _restart_tables(self) -> None:
        """FIFOs and requests as after a reset, which setting CCE does too."""
        self.requests = Requests()
        self.rx[0], self.rx[1], self.events = _Fifo(), _Fifo(), _Fifo()
        self.ram.attach(self)

    def reset(self) -> None:
        """As after a reset: off the bus."""
        super().reset()
        self._clear()
        self.bus.withdraw()
        for event in (self._arriving, self._quiet):
            if event:
                event.cancel()
        self._arriving = self._quiet = None

    # -- state --------------------------------------------------------------------------------

    @property
    def configurable(self) -> bool:
        """Whether protected registers are written."""
        return self.values["CCCR"] & (INIT | CCE) == INIT | CCE

    @property
    def stopped(self) -> bool:
        """Whether INIT is set."""
        return bool(self.values["CCCR"] & INIT)

    @property
    def passive(self) -> bool:
        """Error passive: it sends no dominant error flags."""
        return self.tec > 127 or self.rec > 127

    @property
    def warned(self) -> bool:
        """Error counters have reached the warning limit."""
        return self.tec > 95 or self.rec > 95

    @property
    def bit_time(self) -> tuple[int, int, int, int]:
        """Prescaler, quanta before and after the sample point, and the jump width [quanta]."""
        nbtp = self.values["NBTP"]
        before, after = (nbtp >> 8 & 0xFF) + 2, (nbtp & 0x7F) + 1
        return (nbtp >> 16 & 0x1FF) + 1, before, after, (nbtp >> 25) + 1

    @property
    def kernel(self) -> float:
        """Clock of the bit timing [Hz]."""
        divider = self.chip.fdcan[0].values["CKDIV"]
        return self.chip.rcc.fdcan / (2 * divider or 1)

    @property
    def bit_rate(self) -> float:
        """Bits a second as they are set."""
        prescaler, before, after, _ = self.bit_time
        return self.kernel / (prescaler * (before + after))

    @property
    def understands(self) -> bool:
        """Whether its bits are near enough to those of the bus, and sampled late enough."""
        if self._understands is None:
            self._understands = self._compare_bits()
        return self._understands

    def _compare_bits(self) -> bool:
        _, before, after, jump = self.bit_time
        quanta = before + after
        tolerance = min(jump / (20 * quanta), min(before - 1, after) / (2 * (13 * quanta - after)))
        off = abs(self.bit_rate / self.bus.bit_rate - 1)
        sampled = before / quanta * 1e9 / self.bit_rate if self.bit_rate else 0.0
        return off <= tolerance and sampled >= self.bus.round_trip

    def clocks_changed(self) -> None:
        """ChipFault when the kernel clock goes away or is too fast while it is on the bus."""
        self._understands = None
        if not self.stopped:
            self._check_kernel("CCCR")

    def _check_kernel(self, register: str) -> None:
        if not self.kernel:
            raise self.refuse(register, "the kernel clock is off (RCC_CCIPR FDCANSEL)")
        if self.chip.rcc.fdcan > 1.001 * self.chip.rcc.pclk1:
            raise self.refuse(register, "the kernel clock is faster than the bus clock PCLK1")

    # -- configuration ------------------------------------------------------------------------

    def _protected(self, name: str) -> None:
        if not self.configurable:
            raise self.refuse(name, "written without INIT and CCE in CCCR: the write is ignored")

    def write_CCCR(self, value: int) -> None:
        before = self.values["CCCR"]
        self._check_kernel("CCCR")
        self._check_control(before, value)
        if self._arriving and value & INIT != self._wanted:
            raise self.refuse("CCCR", "INIT is changed before its last value was read back")
        if (value ^ before) & INIT and not self._arriving:
            self._wanted = value & INIT
            self._arriving = self.chip.after(self._arrival(), self._arrived)
        kept = before & (INIT | CSA)
        self.values["CCCR"] = value & ~(INIT | CSA) | kept
        if value & CCE and not before & CCE:
            self._restart_tables()
        if (value ^ before) & CSR:
            self.chip.after(self._arrival(), self._stop_clock)

    def _check_control(self, before: int, value: int) -> None:
        if value & CCE and not before & INIT:
            raise self.refuse("CCCR", "CCE is set before INIT is read back: it stays clear")
        protected = (value ^ before) & PROTECTED | value & ~before & (ASM | MON)
        if protected and not self.configurable:
            text = f"bits {protected:#x} are changed without INIT and CCE: the write is ignored"
            raise self.refuse("CCCR", text)
        if value & (TEST | MON | ASM | FDOE | BRSE | NISO):
            text = "test, monitoring, restricted and FD operation are not part of this model"
            raise self.refuse("CCCR", text)

    def _arrival(self) -> int:
        return int(ARRIVAL * 1e9 / self.kernel) + 1

    def _arrived(self) -> None:
        self._arriving = None
        if self._wanted:
            self._leave()
        else:
            self.values["CCCR"] &= ~(INIT | CCE)
            self._join()
        self.changed()

    def _leave(self) -> None:
        """Off the bus at once; requests stay."""
        self.values["CCCR"] |= INIT
        self.takes_part = False
        if self._quiet:
            self._quiet.cancel()
            self._quiet = None
        self.bus.withdraw()
        self._active = None

    def _stop_clock(self) -> None:
        if self.values["CCCR"] & CSR:
            self._leave()
            self.values["CCCR"] |= CSA
        else:
            self.values["CCCR"] &= ~CSA
        self.changed()

    def _join(self) -> None:
        self._understands = None
        self._check_start()
        self._recovered = 0
        self._listen(max(self.chip.time, self.bus.recessive_since))

    def check_pins(self) -> None:
        """ChipFault when it is on the bus and its pins are not."""
        if not self.stopped:
            need_pins(self.chip, self.name, ("RX", "TX"))

    def _check_start(self) -> None:
        self._check_kernel("CCCR")
        self.check_pins()
        _, before, after, jump = self.bit_time
        if self.values["NBTP"] >> 8 & 0xFF == 0:
            raise self.refuse("NBTP", "NTSEG1 0 is not allowed")
        if self.values["NBTP"] & 0x7F == 0:
            raise self.refuse("NBTP", "NTSEG2 0 is not allowed")
        if jump > min(before - 1, after):
            raise self.refuse("NBTP", "the jump width is longer than a phase it lengthens")

    def write_NBTP(self, value: int) -> None:
        self._protected("NBTP")
        self.values["NBTP"] = value

    def write_DBTP(self, value: int) -> None:
        self._protected("DBTP")
        self.values["DBTP"] = value

    def write_TDCR(self, value: int) -> None:
        self._protected("TDCR")
        self.values["TDCR"] = value

    def write_RWD(self, value: int) -> None:
        self._protected("RWD")
        if value & 0xFF:
            raise self.refuse("RWD", "the watchdog of the message RAM is not part of this model")

    def write_TEST(self, _value: int) -> None:
        raise self.refuse("TEST", "test mode is not part of this model")

    def write_TSCC(self, value: int) -> None:
        self._protected("TSCC")
        if value & 3 == 2:
            raise self.refuse("TSCC", "the external time stamp is not part of this model")
        self.values["TSCC"] = value

    def write_TOCC(self, value: int) -> None:
        self._protected("TOCC")
        if value & 1:
            raise self.refuse("TOCC", "the timeout counter is not part of this model")
        self.values["TOCC"] = value

    def write_RXGFC(self, value: int) -> None:
        self._protected("RXGFC")
        if value >> 16 & 0x1F > 28:
            raise self.refuse("RXGFC", "LSS: there are 28 standard filters")
        if value >> 24 & 0xF > 8:
            raise self.refuse("RXGFC", "LSE: there are 8 extended filters")
        self.values["RXGFC"] = value

    def write_XIDAM(self, value: int) -> None:
        self._protected("XIDAM")
        self.values["XIDAM"] = value

    def write_TXBC(self, value: int) -> None:
        self._protected("TXBC")
        self.values["TXBC"] = value

    def write_CKDIV(self, value: int) -> None:
        if self.number != 1:
            raise self.refuse("CKDIV", "only FDCAN1 has the divider of all three")
        self._protected("CKDIV")
        self.values["CKDIV"] = value

    # -- status -------------------------------------------------------------------------------

    def read_PSR(self) -> int:
        if self.bus_off or self.stopped or not self.takes_part:
            activity = SYNCHRONISING
        elif self.bus.idle:
            activity = IDLE
        else:
            activity = TRANSMITTER if self._active is not None else RECEIVER
        value = self._last | activity << 3 | self.passive << 5 | self.warned << 6
        last = self._last
        self._last = UNCHANGED
        self._psr_lasts = last == UNCHANGED
        return value | self.bus_off << 7 | 0x700

    def kind_of(self, key: str) -> int:
        # What is cleared by reading is another value the next time.
        changing = (key == "PSR" and not self._psr_lasts) or (key == "ECR" and self._logged_read)
        return 0 if changing else super().kind_of(key)

    _psr_lasts = True
    _logged_read = False

    def read_ECR(self) -> int:
        self._logged_read = self.logged > 0
        value = min(self.tec, 255) | min(self.rec, 127) << 8 | (self.rec > 127) << 15
        value |= self.logged << 16
        self.logged = 0
        return value

    def read_IR(self) -> int:
        return self.values["IR"]

    def write_IR(self, value: int) -> None:
        self.values["IR"] &= ~value

    def read_TSCV(self) -> int:
        return self.time_stamp

    @property
    def time_stamp(self) -> int:
        """Bits, divided, since it was set to zero."""
        if self.values["TSCC"] & 3 != 1:
            return 0
        divider = (self.values["TSCC"] >> 16 & 0xF) + 1
        return int((self.chip.time - self._stamped) * self.bit_rate / 1e9 / divider) & 0xFFFF

    def write_TSCV(self, _value: int) -> None:
        """Any value sets it to zero."""
        self._stamped = self.chip.time

    # -- receiving ----------------------------------------------------------------------------

    def receive(self, frame: Frame) -> None:
        """A frame of another node has passed without error."""
        if not self.takes_part:
            return
        if self.rec > 127:
            self.rec = 120
        elif self.rec:
            self.rec -= 1
        self._last = NO_ERROR
        self._note_limits()
        target, match = self.ram.accept(frame, self.values["RXGFC"], self.values["XIDAM"])
        if target is not None:
            self._store(frame, target, match)
        self.changed()

    def _store(self, frame: Frame, number: int, match: int | None) -> None:
        fifo, shift = self.rx[number], 3 * number
        if fifo.full:
            self.values["IR"] |= LOST << shift
            if not self.values["RXGFC"] >> (9 - number) & 1:
                return
            fifo.release(fifo.get)
        place = fifo.add()
        base = RX_FIFO[number] + ELEMENT * place
        self.ram.store(base, Message.of(frame), match, self.time_stamp)
        self.values["IR"] |= (NEW | (FULL if fifo.full else 0)) << shift

    def _fifo_status(self, number: int) -> int:
        fifo = self.rx[number]
        lost = self.values["IR"] >> 3 * number & LOST
        return fifo.fill | fifo.get << 8 | fifo.put << 16 | fifo.full << 24 | bool(lost) << 25

    def read_RXF0S(self) -> int:
        return self._fifo_status(0)

    def read_RXF1S(self) -> int:
        return self._fifo_status(1)

    def write_RXF0A(self, value: int) -> None:
        self._acknowledge(0, value)

    def write_RXF1A(self, value: int) -> None:
        self._acknowledge(1, value)

    def _acknowledge(self, number: int, index: int) -> None:
        if not (index < DEPTH and self.rx[number].holds(index)):
            raise self.refuse(f"RXF{number}A", f"element {index} is not in the FIFO")
        self.rx[number].release(index)
        self.values[f"RXF{number}A"] = index

    # -- sending ------------------------------------------------------------------------------

    @property
    def queued(self) -> bool:
        """By identifier, not in the order of the requests."""
        return bool(self.values["TXBC"] & QUEUE)

    @property
    def pending(self) -> int:
        """Buffers that are to be sent, as bits."""
        return self.requests.pending

    def read_TXFQS(self) -> int:
        return self.requests.status(self.queued)

    def read_TXBRP(self) -> int:
        return self.requests.pending

    def read_TXBCR(self) -> int:
        return self.requests.cancelling

    def read_TXBTO(self) -> int:
        return self.requests.occurred

    def read_TXBCF(self) -> int:
        return self.requests.cancelled

    def write_TXBAR(self, value: int) -> None:
        if self.values["CCCR"] & CCE:
            raise self.refuse("TXBAR", "written while CCE is set: the request is ignored")
        if value & self.pending:
            raise self.refuse("TXBAR", f"buffers {value & self.pending:#x} are pending already")
        for buffer in range(BUFFERS):
            if value >> buffer & 1:
                self._request(buffer)
        if self.takes_part:
            self.bus.request()

    def _request(self, buffer: int) -> None:
        put = self.requests.put
        if not self.queued and not self.requests.level:
            raise self.refuse("TXBAR", "the FIFO is full")
        if not self.queued and buffer != put:
            text = f"buffer {buffer} is requested, but the FIFO's put index is {put}"
            raise self.refuse("TXBAR", text)
        self.requests.add(buffer, self.ram.message(TX_BUFFER + ELEMENT * buffer))

    def write_TXBCR(self, value: int) -> None:
        if self.values["CCCR"] & CCE:
            raise self.refuse("TXBCR", "written while CCE is set: the request is ignored")
        for buffer in range(BUFFERS):
            if not value & self.pending & 1 << buffer:
                continue
            if buffer == self._active:
                self.requests.cancelling |= 1 << buffer
            else:
                self._end_request(buffer, False)

    def _end_request(self, buffer: int, sent: bool) -> None:
        if self.requests.end(buffer, sent) and self.values["TXBCIE"] >> buffer & 1:
            self.values["IR"] |= TCF

    def candidate(self) -> Frame | None:
        """The frame that it would start now."""
        best = self.requests.best(self.queued) if self.takes_part else None
        return None if best is None else self.requests.message(best).frame

    def started(self) -> None:
        """Its candidate has won the bus."""
        self._active = self.requests.best(self.queued)
        self.changed()

    def sent(self) -> None:
        """Its frame has passed and was acknowledged."""
        buffer = self._active
        if buffer is None:
            return
        self._active = None
        message = self.requests.message(buffer)
        self._end_request(buffer, True)
        if self.values["TXBTIE"] >> buffer & 1:
            self.values["IR"] |= TC
        if not self.pending and not self.queued:
            self.values["IR"] |= TFE
        if message.event:
            self._note_event(message)
        self.tec -= self.tec > 0
        self._last = NO_ERROR
        self._note_limits()
        self.changed()

    def _note_event(self, message: Message) -> None:
        if self.events.full:
            self.values["IR"] |= TEFL
            return
        self.ram.store_event(TX_EVENT + 8 * self.events.add(), message, self.time_stamp)
        self.values["IR"] |= TEFN | (TEFF if self.events.full else 0)

    def read_TXEFS(self) -> int:
        fifo = self.events
        lost = bool(self.values["IR"] & TEFL)
        return fifo.fill | fifo.get << 8 | fifo.put << 16 | fifo.full << 24 | lost << 25

    def write_TXEFA(self, value: int) -> None:
        if not (value < DEPTH and self.events.holds(value)):
            raise self.refuse("TXEFA", f"element {value} is not in the FIFO")
        self.events.release(value)

    # -- errors -------------------------------------------------------------------------------

    def send_failed(self, bit_error: bool) -> None:
        """Its frame was destroyed, or nobody acknowledged it."""
        buffer, self._active = self._active, None
        unheard_passive = not bit_error and self.passive
        self._last = (BIT_ZERO if self.passive else BIT_ONE) if bit_error else ACKNOWLEDGE
        if not unheard_passive:
            self.tec += 8
            self._log()
        once = self.values["CCCR"] & DAR
        if buffer is not None and (once or self.requests.cancelling >> buffer & 1):
            self._end_request(buffer, False)
        self._note_limits()
        self.changed()

    def receive_failed(self, stuff_error: bool, more: int = 0) -> None:
        """Someone else's frame was destroyed; `more` for dominant bits after its own flag."""
        if not self.takes_part:
            return
        self._last = STUFF if stuff_error else FORM
        self.rec = min(128, self.rec + 1 + more)
        self._log()
        self._note_limits()
        self.changed()

    def set_errors(self, tec: int, rec: int) -> None:
        """As if so many errors had happened; 256 to send is bus-off."""
        self.tec, self.rec = tec, min(rec, 128)
        self._note_limits()
        self.changed()

    def _log(self) -> None:
        self.values["IR"] |= PEA
        if self.logged == 0xFF:
            self.values["IR"] |= ELO
        self.logged = min(0xFF, self.logged + 1)

    _limits = (False, False, False)

    def _note_limits(self) -> None:
        """Flags for a change of the error state, either way; bus-off leaves the bus."""
        if self.tec > 255 and not self.bus_off:
            self.bus_off = True
            self._leave()
        limits = self.passive, self.warned, self.bus_off
        for flag, old, new in zip((EP, EW, BO), self._limits, limits, strict=True):
            if old != new:
                self.values["IR"] |= flag
        self._limits = limits

    # -- joining and recovering ---------------------------------------------------------------

    def bus_recessive(self) -> None:
        """Something on the bus has just ended."""
        if not self.stopped and not self.takes_part:
            self._listen(self.bus.recessive_since)
        self.changed()

    def _listen(self, since: int) -> None:
        """Wait for eleven recessive bits from a time on [ns]."""
        if self._quiet:
            self._quiet.cancel()
        self._quiet = None
        if self.bus.idle:
            end = max(since + self.bus.bits(11), self.chip.time)
            self._quiet = self.chip.at(end, self._heard_quiet)

    def _heard_quiet(self) -> None:
        self._quiet = None
        if not self.bus.idle:
            return
        if not self.bus_off:
            self._take_part()
            return
        self._recovered += 1
        self.rec = min(self._recovered, 127)
        self._last = BIT_ZERO
        if self._recovered >= RECOVERY:
            self.bus_off = False
            self.tec = self.rec = 0
            self._note_limits()
            self._take_part()
        else:
            self._listen(self.chip.time)
        self.changed()

    def _take_part(self) -> None:
        self.takes_part = True
        self.changed()
        if self.pending:
            self.bus.request()

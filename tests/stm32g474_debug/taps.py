"""The two JTAG taps of the chip in their chain: boundary scan, then the debug port."""

from stm32g474_debug.port import DebugPort

#: Next state where TMS is low, and where it is high.
NEXT = {
    "reset": ("idle", "reset"),
    "idle": ("idle", "select-dr"),
    "select-dr": ("capture-dr", "select-ir"),
    "capture-dr": ("shift-dr", "exit1-dr"),
    "shift-dr": ("shift-dr", "exit1-dr"),
    "exit1-dr": ("pause-dr", "update-dr"),
    "pause-dr": ("pause-dr", "exit2-dr"),
    "exit2-dr": ("shift-dr", "update-dr"),
    "update-dr": ("idle", "select-dr"),
    "select-ir": ("capture-ir", "reset"),
    "capture-ir": ("shift-ir", "exit1-ir"),
    "shift-ir": ("shift-ir", "exit1-ir"),
    "exit1-ir": ("pause-ir", "update-ir"),
    "pause-ir": ("pause-ir", "exit2-ir"),
    "exit2-ir": ("shift-ir", "update-ir"),
    "update-ir": ("idle", "select-dr"),
}
#: Instructions of the debug port, four bits, and of the boundary scan, five bits.
DPACC, APACC, IDCODE, ABORT = 0xA, 0xB, 0xE, 0x8
SCAN_IDCODE = 1
PORT_ID, SCAN_ID = 0x4BA00477, 0x06469041
#: An answer's lowest bits: the access before was done.
OK = 2


class Taps:
    """What the pins of the chip do at every rising edge of TCK."""

    def __init__(self, port: DebugPort, port_id: int = PORT_ID) -> None:
        self.port, self._port_id = port, port_id
        self.state = "reset"
        self._instruction, self._scan = IDCODE, SCAN_IDCODE
        self._register, self._length, self._width = 0, 1, 1
        self._answer = 0

    @property
    def tdo(self) -> int:
        """The pin TDO."""
        return self._register & 1

    def clock(self, tms: int, tdi: int) -> None:
        """A rising edge of TCK."""
        state = self.state
        if state in ("shift-dr", "shift-ir"):
            self._register = self._register >> 1 | tdi << self._length - 1
        self.state = NEXT[state][tms]
        if self.state != state:
            self._enter(self.state)

    def _enter(self, state: str) -> None:
        if state == "reset":
            self._instruction, self._scan = IDCODE, SCAN_IDCODE
        elif state == "capture-ir":
            self._register, self._length = 1 | 1 << 4, 9
        elif state == "update-ir":
            self._instruction, self._scan = self._register & 0xF, self._register >> 4
        elif state == "capture-dr":
            self._capture()
        elif state == "update-dr":
            self._update()

    def _capture(self) -> None:
        """The debug port is next to TDO; a tap in bypass is one bit that is zero."""
        value, self._width = {
            IDCODE: (self._port_id, 32),
            DPACC: (self._answer << 3 | OK, 35),
            APACC: (self._answer << 3 | OK, 35),
            ABORT: (0, 35),
        }.get(self._instruction, (0, 1))
        scan, width = (SCAN_ID, 32) if self._scan == SCAN_IDCODE else (0, 1)
        self._register, self._length = value | scan << self._width, self._width + width

    def _update(self) -> None:
        value = self._register & (1 << self._width) - 1
        register, data = (value >> 1 & 3) << 2, value >> 3
        if self._instruction == DPACC:
            self._answer = self.port.read(register)
            if not value & 1:
                self.port.write(register, data)
        elif self._instruction == APACC:
            if value & 1:
                self._answer = self.port.access_read(register)
            else:
                self.port.access_write(register, data)

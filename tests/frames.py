"""CAN frames for tests: any that can exist, as messages of python-can."""

import can
from can.util import CAN_FD_DLC
from hypothesis import strategies as st

STANDARD_IDS = st.integers(0, 0x7FF)
EXTENDED_IDS = st.integers(0, 0x1FFFFFFF)


@st.composite
def classic_frames(draw: st.DrawFn) -> can.Message:
    """Data and remote frames with 11 or 29 bits of identifier."""
    extended, remote = draw(st.booleans()), draw(st.booleans())
    data = draw(st.binary(max_size=8))
    return can.Message(
        arbitration_id=draw(EXTENDED_IDS if extended else STANDARD_IDS),
        is_extended_id=extended,
        is_remote_frame=remote,
        dlc=len(data),
        data=None if remote else data,
        check=True,
    )


@st.composite
def fd_frames(draw: st.DrawFn) -> can.Message:
    """CAN FD frames of every length, with and without bit rate switch."""
    extended = draw(st.booleans())
    length = draw(st.sampled_from(CAN_FD_DLC))
    return can.Message(
        arbitration_id=draw(EXTENDED_IDS if extended else STANDARD_IDS),
        is_extended_id=extended,
        is_fd=True,
        bitrate_switch=draw(st.booleans()),
        data=draw(st.binary(min_size=length, max_size=length)),
        check=True,
    )


def any_frames() -> st.SearchStrategy[can.Message]:
    """Every frame that can exist."""
    return st.one_of(classic_frames(), fd_frames())

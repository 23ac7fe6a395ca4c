"""Several faults at once, at any time: whatever happens, the machine ends without torque."""

from dataclasses import dataclass, field

import pytest
from catalogue import ALWAYS, FAULTS, HEARTBEAT_LOST, Fault
from forked import in_a_fork
from hypothesis import given, settings
from hypothesis import strategies as st
from journey import MOMENTS, Bench, Journey, Moment

from turnbuckle.lab.drives.power import MOVING
from turnbuckle.lab.lockstep import Lockstep, Request, State

ACTIVE = 150
"""Cycles in which faults strike."""
LATEST = 900
"""Cycles after the last one in which a stop that was asked for has ended."""
SINGLE = [fault for fault in FAULTS if fault.stands_still != ALWAYS]


@dataclass
class Storm:
    """Faults, each with the cycle in which it strikes, and what is asked for meanwhile."""

    moment: Moment
    faults: list[tuple[int, Fault]]
    requests: list[Request]
    findings: list[str] = field(default_factory=list)

    def rage(self, bench: Bench) -> list[str]:
        """What must not be."""
        lockstep = bench.lockstep
        fault_cycles = 0
        for cycle in range(ACTIVE + LATEST):
            active = cycle < ACTIVE
            lockstep.requests = (
                self.requests[cycle % len(self.requests)] if active else Request.STOP
            )
            self._strike(lockstep, cycle)
            lockstep.cycle()
            fault_cycles = fault_cycles + 1 if bench.state is State.FAULT else 0
            if fault_cycles > HEARTBEAT_LOST and is_on(lockstep):
                self.findings.append(f"cycle {cycle}: a drive is on in FAULT")
                break
        if is_on(lockstep):
            self.findings.append(f"a drive is on in {bench.state.name}")
        if bench.state not in (State.FAULT, State.CONFIGURE):
            self.findings.append(f"ends in {bench.state.name}")
        return self.findings + bench.watch.findings

    def _strike(self, lockstep: Lockstep, cycle: int) -> None:
        for begin, fault in self.faults:
            if cycle == begin:
                fault.strike(lockstep)
                for _ in range(fault.stands_still):
                    lockstep.stand_still()
                lockstep.missed += fault.stands_still
            if cycle >= begin:
                fault.each(lockstep, cycle - begin)


def is_on(lockstep: Lockstep) -> bool:
    """Whether any drive may have torque."""
    return any(each.servo.power in MOVING for each in lockstep.machine.drives)


blows = st.lists(
    st.tuples(st.integers(0, ACTIVE - 1), st.sampled_from(SINGLE)), min_size=2, max_size=6
)
asked = st.lists(
    st.sampled_from([Request(0), Request(0), Request.ARM, Request.STOP]), min_size=1, max_size=7
)


@pytest.mark.parametrize("moment", MOMENTS[3:11], ids=lambda moment: moment.name)
def test_many_faults_at_once_leave_no_torque(journey: Journey, moment: Moment) -> None:
    bench = journey.at(moment)

    @settings(max_examples=5)
    @given(blows, asked)
    def rage(faults: list[tuple[int, Fault]], requests: list[Request]) -> None:
        assert in_a_fork(lambda: Storm(moment, faults, requests).rage(bench)) == []

    rage()

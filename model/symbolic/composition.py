"""Functions made of calls in sequence, with local results in between."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from turnbuckle.model.symbolic.function import Input, ModelFunction, Repeat, Retry
from turnbuckle.model.symbolic.sweep import Sweep


@dataclass(frozen=True)
class Call:
    """One call of a composition: of a function by its name, or of one of the composition's own.

    The call takes arguments and earlier results by name, `renamed` where the function has its own
    name for one, and so for its results. With `given`, it is made only where that earlier result, a
    scalar, is positive; elsewhere its results are zero.
    """

    function: str | ModelFunction | Sweep
    renamed: Mapping[str, str] = field(default_factory=dict)
    given: str = ""


@dataclass(frozen=True)
class Composition:
    """Calls in sequence; the results are those of the last one.

    The first fault of a call ends it. The answer is TB_INFEASIBLE where one of the calls says so.
    """

    name: str
    summary: str
    source: str
    inputs: tuple[Input, ...]
    calls: tuple[Call, ...]


#: A function that is made of others.
Composite = Retry | Repeat | Sweep | Composition

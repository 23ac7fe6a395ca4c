"""Order of the nodes in the C, and which of them go inside a branch.

A choice `c ? p : q` becomes an if when the work done for one of its arms alone is worth a branch:
choices on the same condition share one branch, and what only they need moves into it.
"""

import heapq
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property

from turnbuckle.codegen.ir import LEAVES, Op, Routine

#: Work worth a branch, in units of an addition.
WORTH_A_BRANCH = 8
_WORK = {Op.DIV: 8, Op.SQRT: 8, Op.SELECT: 2, Op.MIN: 2, Op.MAX: 2}


@dataclass
class Branch:
    """if (condition) { yes } else { no }, giving a value to every node in `selects`."""

    condition: int
    selects: list[int]
    yes: "Block" = field(default_factory=list)
    no: "Block" = field(default_factory=list)


Block = list["int | Branch"]


@dataclass(frozen=True)
class Group:
    """Choices on one condition, with the nodes that only its arms need."""

    condition: int
    selects: tuple[int, ...]
    yes: frozenset[int]
    no: frozenset[int]

    @cached_property
    def members(self) -> frozenset[int]:
        """Everything the branch computes."""
        return self.yes | self.no | frozenset(self.selects)


class Arrangement:
    """Arranges the needed nodes of a routine."""

    def __init__(self, routine: Routine) -> None:
        self.nodes = routine.nodes
        self.needed = {n for n in routine.needed() if self.nodes[n].op not in LEAVES}
        self.users: dict[int, set[int]] = {n: set() for n in routine.needed()}
        for number in routine.needed():
            for arg in self.nodes[number].args:
                self.users[arg].add(number)
        self.roots = set(routine.roots())

    def block(self, numbers: set[int]) -> Block:
        """Statements that compute `numbers`, whose other operands are there already."""
        groups = self.groups(numbers)
        order = self.schedule(numbers, groups)
        assert order is not None
        return [self.branch(item) if isinstance(item, Group) else item for item in order]

    def branch(self, group: Group) -> Branch:
        """A group as statements."""
        return Branch(
            group.condition,
            sorted(group.selects),
            self.block(set(group.yes)),
            self.block(set(group.no)),
        )

    def groups(self, numbers: set[int]) -> list[Group]:
        """Branches worth making among `numbers`: disjoint, and possible to order.

        A group inside an arm of another waits for that arm's own block. Of two that overlap
        otherwise, the order that leaves more work inside branches is taken.
        """
        accepted: list[Group] = []
        free = set(numbers)
        refused: set[int] = set()
        while candidates := outermost(self.candidates(free, refused)):
            group = self.leader(candidates, free)
            if self.schedule(numbers, [*accepted, group]) is None:
                refused.add(group.condition)
            else:
                accepted.append(group)
                free -= group.members
        return accepted

    def candidates(self, numbers: set[int], refused: set[int]) -> list[Group]:
        """One group for each condition, where the work it saves is worth it."""
        by_condition: dict[int, list[int]] = {}
        for number in sorted(numbers):
            node = self.nodes[number]
            if node.op is Op.SELECT and node.args[0] not in refused:
                by_condition.setdefault(node.args[0], []).append(number)
        groups = [self.group(numbers, *item) for item in by_condition.items()]
        return [group for group in groups if self.saved(group) >= WORTH_A_BRANCH]

    def group(self, numbers: set[int], condition: int, selects: list[int]) -> Group:
        """The choices on one condition with what only their arms need."""
        yes, no = (self.region(numbers, selects, arm) for arm in (1, 2))
        return Group(condition, tuple(selects), yes, no)

    def leader(self, candidates: list[Group], free: set[int]) -> Group:
        """The group to make first: the earliest, unless one that overlaps it had better be."""
        first = min(candidates, key=lambda g: g.selects)
        for other in sorted(candidates, key=self.saved, reverse=True):
            if other.members & first.members and other is not first:
                before = self.saved(other) + self.left(first, free - other.members)
                after = self.saved(first) + self.left(other, free - first.members)
                if before > after:
                    return other
        return first

    def left(self, group: Group, numbers: set[int]) -> int:
        """What a group still saves when only `numbers` are left to it."""
        selects = [select for select in group.selects if select in numbers]
        return self.saved(self.group(numbers, group.condition, selects)) if selects else 0

    def saved(self, group: Group) -> int:
        """Work that a branch may skip."""
        return self.work(group.yes) + self.work(group.no)

    def work(self, numbers: Iterable[int]) -> int:
        """Work of some nodes, in units of an addition."""
        return sum(_WORK.get(self.nodes[number].op, 1) for number in numbers)

    def region(self, numbers: set[int], selects: list[int], arm: int) -> frozenset[int]:
        """Nodes that only the given arm of the choices needs, found from the arms backwards."""
        chosen = set(selects)
        region: set[int] = set()
        waiting = [-self.nodes[select].args[arm] for select in selects]
        heapq.heapify(waiting)
        while waiting:
            number = -heapq.heappop(waiting)
            if number in region or number in chosen or number not in numbers:
                continue
            if number not in self.roots and all(
                user in region or (user in chosen and self.only_in_arm(user, number, arm))
                for user in self.users[number]
            ):
                region.add(number)
                for arg in self.nodes[number].args:
                    heapq.heappush(waiting, -arg)
        return frozenset(region)

    def only_in_arm(self, select: int, number: int, arm: int) -> bool:
        """Whether the choice reads the node in that arm and nowhere else."""
        return all((arg == number) == (k == arm) for k, arg in enumerate(self.nodes[select].args))

    def schedule(self, numbers: set[int], groups: list[Group]) -> list["int | Group"] | None:
        """Nodes and groups in an order that computes before use; None where there is none."""
        owner: dict[int, int | Group] = {number: number for number in numbers}
        for group in groups:
            owner.update(dict.fromkeys(group.members, group))
        done: set[int | Group] = set()
        open_items: set[int | Group] = set()
        order: list[int | Group] = []
        stack: list[tuple[int | Group, bool]] = [
            (owner[number], False) for number in sorted(numbers, reverse=True)
        ]
        while stack:
            item, finished = stack.pop()
            if finished:
                open_items.discard(item)
                done.add(item)
                order.append(item)
            elif item not in done:
                if item in open_items:
                    return None
                open_items.add(item)
                stack.append((item, True))
                for need in sorted(self.needs(item, numbers), reverse=True):
                    if owner[need] in open_items:
                        return None
                    if owner[need] not in done:
                        stack.append((owner[need], False))
        return order

    def needs(self, item: "int | Group", numbers: set[int]) -> set[int]:
        """Nodes outside an item that must be computed before it."""
        members = item.members if isinstance(item, Group) else frozenset({item})
        operands = {arg for member in members for arg in self.nodes[member].args}
        return {arg for arg in operands - members if arg in numbers}


def outermost(groups: list[Group]) -> list[Group]:
    """Groups that do not lie in an arm of another."""
    return [
        group
        for group in groups
        if not any(group.members <= other.yes | other.no for other in groups)
    ]


def arrange(routine: Routine) -> Block:
    """All statements of a routine in order."""
    arrangement = Arrangement(routine)
    return arrangement.block(set(arrangement.needed))

"""The slcan reader takes any characters; a seeded defect is found."""

from dataclasses import replace
from pathlib import Path

import pytest
from fuzzing import ENOUGH, ROOT, SECONDS, Target

CAN = ROOT / "runtime" / "can"
READER = CAN / "slcan_text.c"
SLCAN = Target("slcan", (READER, CAN / "can.c"), (CAN,))
FOR_CAN_FD = replace(SLCAN, defines=("-DTB_CAN_MOST_DATA=64u",))

DEFECTS = {
    "a line longer than its room": (
        "if (reader->length < TB_SLCAN_LONGEST_LINE) {",
        "if (reader->length < TB_SLCAN_LONGEST_LINE + 2u) {",
    ),
    "a broken line that takes the next one along": (
        "    reader->length = 0;\n    reader->skipped = 0;\n    if (is_told) {",
        "    reader->length = is_told ? length : 0;\n    reader->skipped = 0;\n    if (is_told) {",
    ),
    "a frame longer than its room": (
        "!tb_can_is_frame(&read)",
        "!tb_can_is_frame(&read) && (read.length <= TB_CAN_MOST_DATA)",
    ),
    "an identifier that no frame has": (
        "!tb_can_is_frame(&read)",
        "read.length > TB_CAN_MOST_DATA",
    ),
    "a line feed that is an answer": (
        "return (reader->length == 0) ? TB_SLCAN_NOTHING : end_line(reader, character, frame);",
        "return end_line(reader, character, frame);",
    ),
    "a line without an end that nobody hears of": (
        "return is_due ? TB_SLCAN_MALFORMED : TB_SLCAN_NOTHING;",
        "return TB_SLCAN_NOTHING;",
    ),
}


@pytest.mark.parametrize("target", [SLCAN, FOR_CAN_FD], ids=["classic", "CAN FD"])
def test_any_characters_into_the_reader_are_taken(target: Target, tmp_path: Path) -> None:
    assert target.build(tmp_path).finding(SECONDS) is None


@pytest.mark.parametrize("defect", DEFECTS)
def test_a_seeded_defect_is_found(defect: str, tmp_path: Path) -> None:
    old, new = DEFECTS[defect]
    seeded = SLCAN.with_defect(READER, old, new, tmp_path)
    assert seeded.build(tmp_path).finding(inputs=ENOUGH) is not None

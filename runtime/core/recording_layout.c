#include "recorder.h"
#include "supervisor_layout.h"

#define RECORDER_LAYOUT                                                                            \
    TB_LAYOUT_STRUCT(recorded_cycle)                                                               \
    TB_LAYOUT_PART(recorded_cycle, seen, observation)                                              \
    TB_LAYOUT_PART(recorded_cycle, orders, orders)                                                 \
    TB_LAYOUT_STRUCT(segment_head)                                                                 \
    TB_LAYOUT_NUMBER(segment_head, first)                                                          \
    TB_LAYOUT_NUMBER(segment_head, count)                                                          \
    TB_LAYOUT_NUMBER(segment_head, checksum)

const tb_layout_row tb_recording_layout[] = {
    TB_CONTROLLER_LAYOUT TB_CYCLE_LAYOUT TB_SUPERVISOR_LAYOUT RECORDER_LAYOUT
        TB_ENUMERATIONS_LAYOUT};

const uint32_t tb_recording_layout_rows =
    sizeof(tb_recording_layout) / sizeof(tb_recording_layout[0]);

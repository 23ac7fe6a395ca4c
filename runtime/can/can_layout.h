/* Rows of a description (layout.h): the states of a CAN port. */
#ifndef TB_CAN_LAYOUT_H
#define TB_CAN_LAYOUT_H

#include "can.h"
#include "layout.h"

#define TB_CAN_LAYOUT                                                                              \
    TB_LAYOUT_ENUMERATION(can_state)                                                               \
    TB_LAYOUT_VALUE(CAN_ERROR_ACTIVE)                                                              \
    TB_LAYOUT_VALUE(CAN_ERROR_WARNING)                                                             \
    TB_LAYOUT_VALUE(CAN_ERROR_PASSIVE)                                                             \
    TB_LAYOUT_VALUE(CAN_BUS_OFF)                                                                   \
    TB_LAYOUT_VALUE(CAN_NOT_OPEN)

#endif

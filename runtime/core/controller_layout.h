/* Rows of a description (layout.h): what the controller step reads, gives and remembers. */
#ifndef TB_CONTROLLER_LAYOUT_H
#define TB_CONTROLLER_LAYOUT_H

#include "controller.h"
#include "layout.h"

#define TB_CONTROLLER_LAYOUT                                                                       \
    TB_LAYOUT_STRUCT(inputs)                                                                       \
    TB_LAYOUT_NUMBERS(inputs, lengths)                                                             \
    TB_LAYOUT_NUMBERS(inputs, rails)                                                               \
    TB_LAYOUT_NUMBERS(inputs, force)                                                               \
    TB_LAYOUT_NUMBERS(inputs, hand_force)                                                          \
    TB_LAYOUT_NUMBER(inputs, options)                                                              \
    TB_LAYOUT_STRUCT(outputs)                                                                      \
    TB_LAYOUT_NUMBERS(outputs, pose)                                                               \
    TB_LAYOUT_NUMBERS(outputs, velocity)                                                           \
    TB_LAYOUT_NUMBER(outputs, residual)                                                            \
    TB_LAYOUT_NUMBERS(outputs, wanted_force)                                                       \
    TB_LAYOUT_NUMBERS(outputs, delivered_force)                                                    \
    TB_LAYOUT_NUMBERS(outputs, tension)                                                            \
    TB_LAYOUT_NUMBERS(outputs, disturbance)                                                        \
    TB_LAYOUT_NUMBERS(outputs, motor_torque)                                                       \
    TB_LAYOUT_NUMBERS(outputs, rail_target)                                                        \
    TB_LAYOUT_NUMBERS(outputs, rail_force)                                                         \
    TB_LAYOUT_NUMBERS(outputs, rail_torque)                                                        \
    TB_LAYOUT_NUMBERS(outputs, gate)                                                               \
    TB_LAYOUT_NUMBER(outputs, status)                                                              \
    TB_LAYOUT_STRUCT(controller)                                                                   \
    TB_LAYOUT_NUMBERS(controller, pose)                                                            \
    TB_LAYOUT_NUMBERS(controller, lengths)                                                         \
    TB_LAYOUT_NUMBERS(controller, length_rates)                                                    \
    TB_LAYOUT_NUMBERS(controller, rails)                                                           \
    TB_LAYOUT_NUMBERS(controller, rail_rates)                                                      \
    TB_LAYOUT_NUMBERS(controller, observer)                                                        \
    TB_LAYOUT_NUMBERS(controller, base)                                                            \
    TB_LAYOUT_NUMBERS(controller, torque)                                                          \
    TB_LAYOUT_NUMBER(controller, interrupted)

#endif

/**
 * The objects of a drive: X(name, index, sub, type, access, factory value, least, greatest).
 *
 * Ascending by index and sub-index. Access is RO; ROM, read-only, and a TPDO can send it; RW; RWM,
 * writable, and an RPDO can bring it; RWP, writable while the power stage is off.
 */
#ifndef PEER_OBJECTS_H
#define PEER_OBJECTS_H

#include <stdint.h>

#define U8X 0, UINT8_MAX
#define U16X 0, UINT16_MAX
#define U32X 0, UINT32_MAX
#define I16X INT16_MIN, INT16_MAX
#define I32X INT32_MIN, INT32_MAX

#define RPDO_PARAMETERS(X, n)                                                                      \
    X(RPDO##n##_COUNT, 0x13FF + n, 0, U8, RO, 2, U8X)                                              \
    X(RPDO##n##_ID, 0x13FF + n, 1, U32, RW, 0, U32X)                                               \
    X(RPDO##n##_TYPE, 0x13FF + n, 2, U8, RW, 255, U8X)

#define TPDO_PARAMETERS(X, n)                                                                      \
    X(TPDO##n##_COUNT, 0x17FF + n, 0, U8, RO, 3, U8X)                                              \
    X(TPDO##n##_ID, 0x17FF + n, 1, U32, RW, 0, U32X)                                               \
    X(TPDO##n##_TYPE, 0x17FF + n, 2, U8, RW, 255, U8X)                                             \
    X(TPDO##n##_INHIBIT, 0x17FF + n, 3, U16, RW, 10, U16X)

#define PDO_MAP(X, name, index, count, first, second)                                              \
    X(name##_MAP, index, 0, U8, RW, count, U8X)                                                    \
    X(name##_MAP1, index, 1, U32, RW, first, U32X)                                                 \
    X(name##_MAP2, index, 2, U32, RW, second, U32X)                                                \
    X(name##_MAP3, index, 3, U32, RW, 0, U32X)                                                     \
    X(name##_MAP4, index, 4, U32, RW, 0, U32X)                                                     \
    X(name##_MAP5, index, 5, U32, RW, 0, U32X)                                                     \
    X(name##_MAP6, index, 6, U32, RW, 0, U32X)                                                     \
    X(name##_MAP7, index, 7, U32, RW, 0, U32X)                                                     \
    X(name##_MAP8, index, 8, U32, RW, 0, U32X)                                                     \
    X(name##_MAP9, index, 9, U32, RW, 0, U32X)                                                     \
    X(name##_MAP10, index, 10, U32, RW, 0, U32X)                                                   \
    X(name##_MAP11, index, 11, U32, RW, 0, U32X)                                                   \
    X(name##_MAP12, index, 12, U32, RW, 0, U32X)

#define COMMUNICATION_OBJECTS(X)                                                                   \
    X(DEVICE_TYPE, 0x1000, 0, U32, RO, 0x00020192, U32X)                                           \
    X(ERROR_REGISTER, 0x1001, 0, U8, ROM, 0, U8X)                                                  \
    X(HISTORY, 0x1003, 0, U8, RW, 0, 0, 0)                                                         \
    X(HISTORY1, 0x1003, 1, U32, RO, 0, U32X)                                                       \
    X(HISTORY2, 0x1003, 2, U32, RO, 0, U32X)                                                       \
    X(HISTORY3, 0x1003, 3, U32, RO, 0, U32X)                                                       \
    X(HISTORY4, 0x1003, 4, U32, RO, 0, U32X)                                                       \
    X(HISTORY5, 0x1003, 5, U32, RO, 0, U32X)                                                       \
    X(SYNC_ID, 0x1005, 0, U32, RO, 0x80, U32X)                                                     \
    X(DEVICE_NAME, 0x1008, 0, STRING, RO, 0, U8X)                                                  \
    X(STORE_COUNT, 0x1010, 0, U8, RO, 1, U8X)                                                      \
    X(STORE, 0x1010, 1, U32, RW, 1, U32X)                                                          \
    X(RESTORE_COUNT, 0x1011, 0, U8, RO, 1, U8X)                                                    \
    X(RESTORE, 0x1011, 1, U32, RW, 1, U32X)                                                        \
    X(EMERGENCY_ID, 0x1014, 0, U32, RO, 0, U32X)                                                   \
    X(CONSUMER_COUNT, 0x1016, 0, U8, RO, 2, U8X)                                                   \
    X(CONSUMER1, 0x1016, 1, U32, RW, 0, 0, 0x7FFFFF)                                               \
    X(CONSUMER2, 0x1016, 2, U32, RW, 0, 0, 0x7FFFFF)                                               \
    X(PRODUCER, 0x1017, 0, U16, RW, 0, U16X)                                                       \
    X(IDENTITY_COUNT, 0x1018, 0, U8, RO, 4, U8X)                                                   \
    X(VENDOR, 0x1018, 1, U32, RO, 0, U32X)                                                         \
    X(PRODUCT, 0x1018, 2, U32, RO, 0, U32X)                                                        \
    X(REVISION, 0x1018, 3, U32, RO, 0, U32X)                                                       \
    X(SERIAL, 0x1018, 4, U32, RO, 0, U32X)                                                         \
    X(BEHAVIOUR_COUNT, 0x1029, 0, U8, RO, 1, U8X)                                                  \
    X(BEHAVIOUR, 0x1029, 1, U8, RW, 0, 0, 2)                                                       \
    X(SDO_COUNT, 0x1200, 0, U8, RO, 2, U8X)                                                        \
    X(SDO_REQUEST_ID, 0x1200, 1, U32, RO, 0, U32X)                                                 \
    X(SDO_ANSWER_ID, 0x1200, 2, U32, RO, 0, U32X)                                                  \
    RPDO_PARAMETERS(X, 1)                                                                          \
    RPDO_PARAMETERS(X, 2)                                                                          \
    RPDO_PARAMETERS(X, 3)                                                                          \
    RPDO_PARAMETERS(X, 4)                                                                          \
    PDO_MAP(X, RPDO1, 0x1600, 1, 0x60400010, 0)                                                    \
    PDO_MAP(X, RPDO2, 0x1601, 2, 0x60400010, 0x60600008)                                           \
    PDO_MAP(X, RPDO3, 0x1602, 2, 0x60400010, 0x607A0020)                                           \
    PDO_MAP(X, RPDO4, 0x1603, 2, 0x60400010, 0x60FF0020)                                           \
    TPDO_PARAMETERS(X, 1)                                                                          \
    TPDO_PARAMETERS(X, 2)                                                                          \
    TPDO_PARAMETERS(X, 3)                                                                          \
    TPDO_PARAMETERS(X, 4)                                                                          \
    PDO_MAP(X, TPDO1, 0x1A00, 1, 0x60410010, 0)                                                    \
    PDO_MAP(X, TPDO2, 0x1A01, 2, 0x60410010, 0x60610008)                                           \
    PDO_MAP(X, TPDO3, 0x1A02, 2, 0x60410010, 0x60640020)                                           \
    PDO_MAP(X, TPDO4, 0x1A03, 2, 0x60410010, 0x606C0020)

#define MAKER_OBJECTS(X)                                                                           \
    X(NODE_ID, 0x2000, 0, U8, RW, 1, 1, 127)                                                       \
    X(BIT_RATE, 0x2001, 0, U8, RW, 0, 0, 9)                                                        \
    X(SUPPLY_COUNT, 0x2200, 0, U8, RO, 1, U8X)                                                     \
    X(SUPPLY, 0x2200, 1, U16, RO, 480, U16X)                                                       \
    X(AXIS_COUNT, 0x3000, 0, U8, RO, 3, U8X)                                                       \
    X(SENSORS, 0x3000, 1, U32, RWP, 1, U32X)                                                       \
    X(CONTROL, 0x3000, 2, U32, RWP, 0x11121, U32X)                                                 \
    X(COMMUTATION, 0x3000, 3, U32, RWP, 2, U32X)                                                   \
    X(MOTOR_COUNT, 0x3001, 0, U8, RO, 5, U8X)                                                      \
    X(NOMINAL_CURRENT, 0x3001, 1, U32, RWM, 0, U32X)                                               \
    X(CURRENT_LIMIT, 0x3001, 2, U32, RWM, 0, U32X)                                                 \
    X(POLE_PAIRS, 0x3001, 3, U8, RWP, 1, 1, 255)                                                   \
    X(THERMAL_TIME, 0x3001, 4, U16, RWP, 40, 1, 10000)                                             \
    X(TORQUE_CONSTANT, 0x3001, 5, U32, RWP, 0, U32X)                                               \
    X(ELECTRICAL_COUNT, 0x3002, 0, U8, RO, 2, U8X)                                                 \
    X(RESISTANCE, 0x3002, 1, U32, RWP, 1000, U32X)                                                 \
    X(INDUCTANCE, 0x3002, 2, U16, RWP, 100, U16X)                                                  \
    X(ENCODER_COUNT, 0x3010, 0, U8, RO, 1, U8X)                                                    \
    X(PULSES, 0x3010, 1, U32, RWP, 500, 16, 2500000)                                               \
    X(HOME_POSITION, 0x30B0, 0, I32, RWM, 0, I32X)                                                 \
    X(HOME_MOVE, 0x30B1, 0, I32, RW, 0, I32X)                                                      \
    X(HOME_CURRENT, 0x30B2, 0, U16, RWM, 500, U16X)                                                \
    X(CURRENT_DEMAND, 0x30D0, 0, I32, ROM, 0, I32X)                                                \
    X(CURRENT_COUNT, 0x30D1, 0, U8, RO, 2, U8X)                                                    \
    X(CURRENT_AVERAGED, 0x30D1, 1, I32, ROM, 0, I32X)                                              \
    X(CURRENT_ACTUAL, 0x30D1, 2, I32, ROM, 0, I32X)                                                \
    X(TORQUE_AVERAGED_COUNT, 0x30D2, 0, U8, RO, 1, U8X)                                            \
    X(TORQUE_AVERAGED, 0x30D2, 1, I16, ROM, 0, I16X)                                               \
    X(VELOCITY_AVERAGED_COUNT, 0x30D3, 0, U8, RO, 1, U8X)                                          \
    X(VELOCITY_AVERAGED, 0x30D3, 1, I32, ROM, 0, I32X)                                             \
    X(I2T_COUNT, 0x3200, 0, U8, RO, 2, U8X)                                                        \
    X(I2T_MOTOR, 0x3200, 1, U16, ROM, 0, U16X)                                                     \
    X(I2T_STAGE, 0x3200, 2, U16, ROM, 0, U16X)                                                     \
    X(TEMPERATURE_COUNT, 0x3201, 0, U8, RO, 1, U8X)                                                \
    X(TEMPERATURE, 0x3201, 1, I16, RO, 312, I16X)                                                  \
    X(STO_COUNT, 0x3202, 0, U8, RO, 1, U8X)                                                        \
    X(STO, 0x3202, 1, U8, RO, 3, U8X)

#define DRIVE_OBJECTS(X)                                                                           \
    X(ABORT_OPTION, 0x6007, 0, I16, RW, 3, 0, 3)                                                   \
    X(ERROR_CODE, 0x603F, 0, U16, ROM, 0, U16X)                                                    \
    X(CONTROLWORD, 0x6040, 0, U16, RWM, 0, U16X)                                                   \
    X(STATUSWORD, 0x6041, 0, U16, ROM, 0, U16X)                                                    \
    X(QUICK_STOP_OPTION, 0x605A, 0, I16, RW, 6, 0, 6)                                              \
    X(SHUTDOWN_OPTION, 0x605B, 0, I16, RW, 0, 0, 1)                                                \
    X(DISABLE_OPTION, 0x605C, 0, I16, RW, 1, 0, 1)                                                 \
    X(FAULT_OPTION, 0x605E, 0, I16, RW, 2, 0, 2)                                                   \
    X(MODE, 0x6060, 0, I8, RWM, 1, 1, 10)                                                          \
    X(MODE_DISPLAY, 0x6061, 0, I8, ROM, 1, INT8_MIN, INT8_MAX)                                     \
    X(POSITION_DEMAND, 0x6062, 0, I32, ROM, 0, I32X)                                               \
    X(POSITION, 0x6064, 0, I32, ROM, 0, I32X)                                                      \
    X(FOLLOWING_WINDOW, 0x6065, 0, U32, RWM, 2000, U32X)                                           \
    X(FOLLOWING_TIMEOUT, 0x6066, 0, U16, RW, 0, 0, 0)                                              \
    X(POSITION_WINDOW, 0x6067, 0, U32, RWM, UINT32_MAX, U32X)                                      \
    X(POSITION_WINDOW_TIME, 0x6068, 0, U16, RWM, 0, U16X)                                          \
    X(VELOCITY_DEMAND, 0x606B, 0, I32, ROM, 0, I32X)                                               \
    X(VELOCITY, 0x606C, 0, I32, ROM, 0, I32X)                                                      \
    X(TARGET_TORQUE, 0x6071, 0, I16, RWM, 0, I16X)                                                 \
    X(RATED_TORQUE, 0x6076, 0, U32, RO, 0, U32X)                                                   \
    X(TORQUE, 0x6077, 0, I16, ROM, 0, I16X)                                                        \
    X(TARGET_POSITION, 0x607A, 0, I32, RWM, 0, I32X)                                               \
    X(LIMIT_COUNT, 0x607D, 0, U8, RO, 2, U8X)                                                      \
    X(LIMIT_LOW, 0x607D, 1, I32, RWM, 0, I32X)                                                     \
    X(LIMIT_HIGH, 0x607D, 2, I32, RWM, 0, I32X)                                                    \
    X(PROFILE_VELOCITY_MOST, 0x607F, 0, U32, RWM, 50000, 0, 50000)                                 \
    X(MOTOR_SPEED_MOST, 0x6080, 0, U32, RWM, 50000, 0, 50000)                                      \
    X(PROFILE_VELOCITY, 0x6081, 0, U32, RWM, 1000, U32X)                                           \
    X(PROFILE_ACCELERATION, 0x6083, 0, U32, RWM, 10000, 1, UINT32_MAX)                             \
    X(PROFILE_DECELERATION, 0x6084, 0, U32, RWM, 10000, 1, UINT32_MAX)                             \
    X(QUICK_STOP_DECELERATION, 0x6085, 0, U32, RWM, 10000, 1, UINT32_MAX)                          \
    X(HOMING_METHOD, 0x6098, 0, I8, RWM, 7, -4, 37)                                                \
    X(HOMING_SPEED_COUNT, 0x6099, 0, U8, RO, 2, U8X)                                               \
    X(HOMING_SPEED, 0x6099, 1, U32, RWM, 100, 1, 50000)                                            \
    X(HOMING_SPEED_ZERO, 0x6099, 2, U32, RWM, 10, 1, 50000)                                        \
    X(HOMING_ACCELERATION, 0x609A, 0, U32, RWM, 1000, 1, UINT32_MAX)                               \
    X(POSITION_UNIT, 0x60A8, 0, U32, RO, 0x00B50000, U32X)                                         \
    X(VELOCITY_UNIT, 0x60A9, 0, U32, RO, 0x00B44700, U32X)                                         \
    X(POSITION_OFFSET, 0x60B0, 0, I32, RWM, 0, I32X)                                               \
    X(VELOCITY_OFFSET, 0x60B1, 0, I32, RWM, 0, I32X)                                               \
    X(TORQUE_OFFSET, 0x60B2, 0, I16, RWM, 0, I16X)                                                 \
    X(INTERPOLATION_COUNT, 0x60C2, 0, U8, RO, 2, U8X)                                              \
    X(INTERPOLATION_PERIOD, 0x60C2, 1, U8, RWM, 0, 0, 100)                                         \
    X(INTERPOLATION_EXPONENT, 0x60C2, 2, I8, RW, -3, -3, -3)                                       \
    X(METHOD_COUNT, 0x60E3, 0, U8, RO, 4, U8X)                                                     \
    X(METHOD1, 0x60E3, 1, I8, RO, -3, -128, 127)                                                   \
    X(METHOD2, 0x60E3, 2, I8, RO, -4, -128, 127)                                                   \
    X(METHOD3, 0x60E3, 3, I8, RO, 35, -128, 127)                                                   \
    X(METHOD4, 0x60E3, 4, I8, RO, 37, -128, 127)                                                   \
    X(FOLLOWING_ERROR, 0x60F4, 0, I32, ROM, 0, I32X)                                               \
    X(INPUTS, 0x60FD, 0, U32, ROM, 0, U32X)                                                        \
    X(OUTPUTS_COUNT, 0x60FE, 0, U8, RO, 1, U8X)                                                    \
    X(OUTPUTS, 0x60FE, 1, U32, RWM, 0, U32X)                                                       \
    X(TARGET_VELOCITY, 0x60FF, 0, I32, RWM, 0, I32X)                                               \
    X(MODES, 0x6502, 0, U32, RO, 0x3A5, U32X)

#define ALL_OBJECTS(X) COMMUNICATION_OBJECTS(X) MAKER_OBJECTS(X) DRIVE_OBJECTS(X)

#endif

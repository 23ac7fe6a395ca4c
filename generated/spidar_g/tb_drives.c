/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_drives.h"

#include <stddef.h>

/* Kind of drive: maxon EPOS4 */

static const tb_error_text epos4_errors[] = {
    {0x1080, 0x1088, TB_ERROR_FAULT, "generic initialisation error"},
    {0x1090, 0x1090, TB_ERROR_FAULT, "firmware and hardware do not fit"},
    {0x2320, 0x2320, TB_ERROR_FAULT, "power stage protection"},
    {0x4380, 0x4380, TB_ERROR_FAULT, "motor too hot"},
    {0x5113, 0x5113, TB_ERROR_FAULT, "logic supply voltage too low"},
    {0x5280, 0x5282, TB_ERROR_FAULT, "hardware defect"},
    {0x5480, 0x5483, TB_ERROR_FAULT, "hardware defect"},
    {0x6080, 0x6080, TB_ERROR_FAULT, "sign of life error"},
    {0x6081, 0x6081, TB_ERROR_FAULT, "extension watchdog"},
    {0x6180, 0x61F0, TB_ERROR_FAULT, "internal software error"},
    {0x6320, 0x6320, TB_ERROR_FAULT, "software parameter error"},
    {0x6380, 0x6380, TB_ERROR_FAULT, "stored parameters corrupt"},
    {0x7380, 0x7382, TB_ERROR_FAULT, "position sensor breach or hall sensor error; homing is lost"},
    {0x7388, 0x738A, TB_ERROR_FAULT, "encoder or hall sensor error; homing is lost"},
    {0x738C, 0x738D, TB_ERROR_FAULT, "SSI sensor error"},
    {0x7390, 0x7391, TB_ERROR_FAULT, "sensor missing"},
    {0x7392, 0x7392, TB_ERROR_FAULT, "sensor error; homing is lost"},
    {0x8110, 0x8111, TB_ERROR_COMMUNICATION, "CAN overrun: messages lost"},
    {0x8180, 0x8184, TB_ERROR_COMMUNICATION, "EtherCAT communication error"},
    {0x81FD, 0x81FD, TB_ERROR_COMMUNICATION, "CAN bus-off"},
    {0x81FE, 0x81FF, TB_ERROR_COMMUNICATION, "CAN queue overflow"},
    {0x8280, 0x8281, TB_ERROR_FAULT, "EtherCAT process data error"},
    {0x8A80, 0x8A81, TB_ERROR_FAULT, "limit switch"},
    {0x8A82, 0x8A82, TB_ERROR_FAULT, "software position limit"},
    {0x8A88, 0x8A88, TB_ERROR_FAULT, "safe torque off: is the emergency stop pressed?"},
    {0xFF01, 0xFF01, TB_ERROR_WARNING, "overloaded (warning)"},
    {0xFF02, 0xFF02, TB_ERROR_FAULT, "watchdog; homing is lost"},
    {0xFF0B, 0xFF0B, TB_ERROR_FAULT, "peak overload"},
    {0xFF10, 0xFF10, TB_ERROR_FAULT, "controller gain error"},
    {0xFF11, 0xFF24, TB_ERROR_FAULT, "auto tuning error"}
};

static const tb_abort_text epos4_aborts[] = {
    {0x06010003U, "subindex 0 must be 0 before the other entries are written"},
    {0x06010004U, "complete access not supported"},
    {0x0F00FFBEU, "password wrong"},
    {0x0F00FFBFU, "command not legal"},
    {0x0F00FFC0U, "not allowed in this NMT state"}
};

static const tb_drive_kind epos4_kind = {
    epos4_errors, epos4_aborts, 30, 5, {0x00, 0x0A, 0x08, 0x06}};

/* Of cable_1, cable_2, cable_3, cable_4, cable_5, cable_6, cable_7, cable_8 */
static const tb_object identity_1[] = {
    {0x1018, 1, 4, TB_OBJECT_CHECK, 0xFBU}, /* vendor */
    {0x6076, 0, 4, TB_OBJECT_CHECK, 0xEA10U}, /* rated torque of the motor */
    {0x3001, 1, 4, TB_OBJECT_CHECK, 0x85CU}, /* nominal current of the motor */
    {0x3001, 5, 4, TB_OBJECT_CHECK, 0x6D60U}, /* torque constant of the motor */
    {0x3010, 1, 4, TB_OBJECT_CHECK, 0x400U} /* pulses of the encoder */
};

/* Of cable_1, cable_2, cable_3, cable_4, cable_5, cable_6, cable_7, cable_8 */
static const tb_object contract_1[] = {
    {0x1016, 1, 4, TB_OBJECT_WRITE, 0x7F0028U}, /* heartbeat of the master: node, ms */
    {0x1017, 0, 2, TB_OBJECT_WRITE, 0x14U}, /* heartbeat of the drive: ms */
    {0x1029, 1, 1, TB_OBJECT_WRITE, 0x1U}, /* after an error: stays operational */
    {0x6007, 0, 2, TB_OBJECT_WRITE, 0x2U}, /* without the master: disable */
    {0x605A, 0, 2, TB_OBJECT_WRITE, 0x2U}, /* quick stop: off */
    {0x605B, 0, 2, TB_OBJECT_WRITE, 0x0U}, /* shutdown: coast */
    {0x605C, 0, 2, TB_OBJECT_WRITE, 0x0U}, /* disable operation: coast */
    {0x605E, 0, 2, TB_OBJECT_WRITE, 0x0U}, /* fault: coast */
    {0x3001, 2, 4, TB_OBJECT_WRITE, 0xBB8U}, /* current limit */
    {0x1400, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0x80000200U}, /* RPDO1: off while it changes */
    {0x1400, 2, 1, TB_OBJECT_WRITE, 0x1U}, /* RPDO1: with every SYNC */
    {0x1600, 0, 1, TB_OBJECT_WRITE, 0x0U}, /* RPDO1: no map while it changes */
    {0x1600, 1, 4, TB_OBJECT_WRITE, 0x60400010U}, /* RPDO1: controlword */
    {0x1600, 2, 4, TB_OBJECT_WRITE, 0x60710010U}, /* RPDO1: torque */
    {0x1600, 0, 1, TB_OBJECT_WRITE, 0x2U}, /* RPDO1: entries of the map */
    {0x1400, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0x200U}, /* RPDO1: on */
    {0x1401, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0x80000300U}, /* RPDO2: off */
    {0x1402, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0x80000400U}, /* RPDO3: off */
    {0x1403, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0x80000500U}, /* RPDO4: off */
    {0x1800, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0xC0000180U}, /* TPDO1: off while it changes */
    {0x1800, 2, 1, TB_OBJECT_WRITE, 0x1U}, /* TPDO1: with every SYNC */
    {0x1800, 3, 2, TB_OBJECT_WRITE, 0x0U}, /* TPDO1: no inhibit time */
    {0x1A00, 0, 1, TB_OBJECT_WRITE, 0x0U}, /* TPDO1: no map while it changes */
    {0x1A00, 1, 4, TB_OBJECT_WRITE, 0x60410010U}, /* TPDO1: statusword */
    {0x1A00, 2, 4, TB_OBJECT_WRITE, 0x60640020U}, /* TPDO1: position */
    {0x1A00, 3, 4, TB_OBJECT_WRITE, 0x60770010U}, /* TPDO1: torque */
    {0x1A00, 0, 1, TB_OBJECT_WRITE, 0x3U}, /* TPDO1: entries of the map */
    {0x1800, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0x40000180U}, /* TPDO1: on */
    {0x1801, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0xC0000280U}, /* TPDO2: off */
    {0x1802, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0xC0000380U}, /* TPDO3: off */
    {0x1803, 1, 4, TB_OBJECT_WRITE_OF_NODE, 0xC0000480U}, /* TPDO4: off */
    {0x6060, 0, 1, TB_OBJECT_WRITE, 0xAU} /* mode: torque */
};

const tb_bus_table tb_buses[TB_BUSES] = {
    {"cable1", 1000000U, 1},
    {"cable2", 1000000U, 1},
    {"cable3", 1000000U, 1},
    {"cable4", 1000000U, 1}
};

const tb_drive_table tb_drives[TB_DRIVES] = {
    {"cable_1", 0, 1, 0,
     TB_C(7.669903939428207e-06), TB_C(130379.72938088066),
     TB_C(5.9919999999999996e-05), TB_C(16688.91855807744), 734,
     5, 32, identity_1, contract_1,
     &epos4_kind},
    {"cable_2", 0, 2, 0,
     TB_C(7.669903939428207e-06), TB_C(130379.72938088066),
     TB_C(5.9919999999999996e-05), TB_C(16688.91855807744), 734,
     5, 32, identity_1, contract_1,
     &epos4_kind},
    {"cable_3", 1, 1, 0,
     TB_C(7.669903939428207e-06), TB_C(130379.72938088066),
     TB_C(5.9919999999999996e-05), TB_C(16688.91855807744), 734,
     5, 32, identity_1, contract_1,
     &epos4_kind},
    {"cable_4", 1, 2, 0,
     TB_C(7.669903939428207e-06), TB_C(130379.72938088066),
     TB_C(5.9919999999999996e-05), TB_C(16688.91855807744), 734,
     5, 32, identity_1, contract_1,
     &epos4_kind},
    {"cable_5", 2, 1, 0,
     TB_C(7.669903939428207e-06), TB_C(130379.72938088066),
     TB_C(5.9919999999999996e-05), TB_C(16688.91855807744), 734,
     5, 32, identity_1, contract_1,
     &epos4_kind},
    {"cable_6", 2, 2, 0,
     TB_C(7.669903939428207e-06), TB_C(130379.72938088066),
     TB_C(5.9919999999999996e-05), TB_C(16688.91855807744), 734,
     5, 32, identity_1, contract_1,
     &epos4_kind},
    {"cable_7", 3, 1, 0,
     TB_C(7.669903939428207e-06), TB_C(130379.72938088066),
     TB_C(5.9919999999999996e-05), TB_C(16688.91855807744), 734,
     5, 32, identity_1, contract_1,
     &epos4_kind},
    {"cable_8", 3, 2, 0,
     TB_C(7.669903939428207e-06), TB_C(130379.72938088066),
     TB_C(5.9919999999999996e-05), TB_C(16688.91855807744), 734,
     5, 32, identity_1, contract_1,
     &epos4_kind}
};

const tb_node_frame tb_node_frames[TB_NODE_FRAMES] = {
    {0x800, 0}
};

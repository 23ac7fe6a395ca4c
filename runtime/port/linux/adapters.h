/* The kinds of CAN adapters that the program knows. A new kind is its driver and a
 * file adapter_NAME.c, both here, and its lines in tb_adapter_memory and in the table of adapters.c. */
#ifndef TB_ADAPTERS_H
#define TB_ADAPTERS_H

#include <stddef.h>
#include <stdint.h>

#include "can.h"
#include "slcan.h"
#include "socketcan.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Memory of one adapter's driver, whichever its kind is. */
typedef union {
    tb_can_port port; /* the first member of every driver */
    tb_slcan slcan;
    tb_socketcan socketcan;
} tb_adapter_memory;

/** A kind of adapters. */
typedef struct {
    const char *name;    /* in --bus BUS=name:DEVICE */
    const char *example; /* a DEVICE of the kind */
    const char *meaning; /* of "a bus ...", for --help */
    /* Open, at `bit_rate` [bit/s] where the adapter sets one; may wait for two seconds. */
    tb_can_result (*open)(tb_adapter_memory *memory, const char *device, uint32_t bit_rate);
    /* The same without waiting: begin, then proceed. TB_CAN_EMPTY: it is under way. */
    tb_can_result (*begin)(tb_adapter_memory *memory, const char *device, uint32_t bit_rate);
    tb_can_result (*proceed)(tb_adapter_memory *memory);
    /* What to do about a result of open on this device; NULL: tb_can_result_text says it. The text
     * may be written to `text`. */
    const char *(*advice)(tb_can_result result, const char *device, uint32_t bit_rate, size_t room,
                          char text[]);
} tb_adapter;

extern const tb_adapter tb_adapter_slcan;
extern const tb_adapter tb_adapter_socketcan;

/** Every kind; NULL behind the last. */
extern const tb_adapter *const tb_adapters[];

/** The kind that "NAME:DEVICE" names, with the beginning of DEVICE; NULL where there is none. */
const tb_adapter *tb_adapter_find(const char *text, const char **device);

/** How a bus may be given: "bus=slcan:/dev/ttyACM0 or bus=...", cut where there is no room. */
const char *tb_adapters_tell(const char *bus, size_t room, char text[]);

#ifdef __cplusplus
}
#endif

#endif

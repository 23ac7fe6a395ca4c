/* Fuzz target: any emergency messages of a drive.
 *
 * Each is a byte for the length of the frame and eight of data. What must hold: a malformed message
 * changes nothing; what stands never becomes less severe but by the all-clear; class and code belong
 * together; every code has words. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "drive_kind.h"
#include "emcy.h"

#define STEP 9u

static void require(bool condition)
{
    if (!condition) {
        __builtin_trap();
    }
}

static void take(tb_emcy *emergency, const uint8_t step[STEP])
{
    const tb_drive_kind *const kind = tb_drives[0].kind;
    tb_emcy const before = *emergency;
    tb_can_frame frame = {.id = 0x085u, .length = (uint8_t)(((step[0] & 3u) == 3u) ? 7u : 8u)};
    memcpy(frame.data, &step[1], 8);
    bool const taken = tb_emcy_take(emergency, kind, &frame);
    bool const clears = (frame.data[0] == 0) && (frame.data[1] == 0);
    require(taken == (frame.length == 8u));
    bool const same =
        (emergency->code == before.code) && (emergency->error_class == before.error_class);
    require(taken || same);
    require(!(taken && clears) || (emergency->error_class == TB_ERROR_NONE));
    require((taken && clears) || (emergency->error_class >= before.error_class));
    require(emergency->error_class == (uint8_t)tb_drive_kind_error_class(kind, emergency->code));
    require((emergency->code == 0) == (emergency->error_class == TB_ERROR_NONE));
    require(tb_drive_kind_error_text(kind, emergency->code)[0] != '\0');
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    tb_emcy emergency = {0};
    for (size_t at = 0; (at + STEP) <= size; at += STEP) {
        take(&emergency, &data[at]);
    }
    return 0;
}

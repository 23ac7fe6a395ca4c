#include "drive_kind.h"

#include <stddef.h>

#include "emcy.h"
#include "sdo.h"

static const tb_error_text *find_error(const tb_drive_kind *kind, uint16_t code)
{
    for (size_t i = 0; i < kind->error_count; i++) {
        const tb_error_text *const error = &kind->errors[i];
        if ((code >= error->first) && (code <= error->last)) {
            return error;
        }
    }
    return NULL;
}

tb_error_class tb_drive_kind_error_class(const tb_drive_kind *kind, uint16_t code)
{
    const tb_error_text *const error = find_error(kind, code);
    return (error != NULL) ? (tb_error_class)error->error_class : tb_emcy_class(code);
}

const char *tb_drive_kind_error_text(const tb_drive_kind *kind, uint16_t code)
{
    const tb_error_text *const error = find_error(kind, code);
    return (error != NULL) ? error->text : tb_emcy_text(code);
}

const char *tb_drive_kind_abort_text(const tb_drive_kind *kind, uint32_t code)
{
    for (size_t i = 0; i < kind->abort_count; i++) {
        if (kind->aborts[i].code == code) {
            return kind->aborts[i].text;
        }
    }
    return tb_sdo_abort_text(code);
}

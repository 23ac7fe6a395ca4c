#include "adapters.h"

#include <stdio.h>
#include <string.h>

const tb_adapter *const tb_adapters[] = {
    &tb_adapter_slcan,
    &tb_adapter_socketcan,
    NULL,
};

const tb_adapter *tb_adapter_find(const char *text, const char **device)
{
    for (size_t i = 0; tb_adapters[i] != NULL; i++) {
        size_t const length = strlen(tb_adapters[i]->name);
        if ((strncmp(text, tb_adapters[i]->name, length) == 0) && (text[length] == ':') &&
            (text[length + 1u] != '\0')) {
            *device = text + length + 1u;
            return tb_adapters[i];
        }
    }
    return NULL;
}

const char *tb_adapters_tell(const char *bus, size_t room, char text[])
{
    size_t used = 0;
    for (size_t i = 0; (tb_adapters[i] != NULL) && (used < room); i++) {
        int const more = snprintf(text + used, room - used, "%s%s=%s:%s", (i == 0) ? "" : " or ",
                                  bus, tb_adapters[i]->name, tb_adapters[i]->example);
        used += (size_t)more;
    }
    return text;
}

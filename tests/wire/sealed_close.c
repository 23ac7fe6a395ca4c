/* What a sealed program does with a port at its end. */
#include <unistd.h>

#include "can.h"
#include "seal.h"

void seal_and_close(tb_can_port *port)
{
    bool const sealed = tb_seal();
    tb_can_close(port);
    _exit(sealed ? 0 : 1);
}

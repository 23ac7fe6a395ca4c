/* All that is left to chance, from one seed. */
#include "peer.h"

static uint64_t next(peer *const p)
{
    p->random += 0x9E3779B97F4A7C15ULL;
    uint64_t z = p->random;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ z >> 27) * 0x94D049BB133111EBULL;
    return z ^ z >> 31;
}

uint32_t random_below(peer *const p, uint32_t const bound)
{
    return (uint32_t)(next(p) % bound);
}

peer_time random_delay(peer *const p, peer_time const most)
{
    if (p->timing.worst || most <= 0) {
        return most;
    }
    return (peer_time)(next(p) % (uint64_t)(most + 1));
}

// SPDX-License-Identifier: Apache-2.0
#include "runtime-c/link/transition.h"

enum { MACHINE = 1, FROM = 2, TO = 4, TIME = 6, CHECK = 10 };          // offsets in a record

static uint16_t compute_check(const uint8_t *record, uint32_t checksum) { return (uint16_t)(sm_link_crc(record, CHECK) ^ checksum); }

void sm_link_store_transition(uint8_t *record, const LinkTransition *t, uint32_t checksum)
{
    record[0] = t->number;
    record[MACHINE] = (uint8_t)((t->machine & 15) | t->lost << 4);
    sm_link_store(record + FROM, t->from, 2);
    sm_link_store(record + TO, t->to, 2);
    sm_link_store(record + TIME, t->time, 4);
    sm_link_store(record + CHECK, compute_check(record, checksum), 2);
}

// Decodes a stored transition.  Returns false if these bytes are no record of the image with this checksum.
bool sm_link_load_transition(const uint8_t *record, uint32_t checksum, LinkTransition *t)
{
    t->number = record[0];
    t->machine = record[MACHINE] & 15;
    t->lost = record[MACHINE] >> 4;
    t->from = (uint16_t)sm_link_load(record + FROM, 2);
    t->to = (uint16_t)sm_link_load(record + TO, 2);
    t->time = sm_link_load(record + TIME, 4);
    return sm_link_load(record + CHECK, 2) == compute_check(record, checksum);
}

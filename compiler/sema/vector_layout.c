// SPDX-License-Identifier: Apache-2.0
// Computes where the elements of a state vector are in memory and on the wire, and the hash that binds machines to a layout.
#include "compiler/sema/check.h"

#include "stdlib/crc32.h"

// Returns the smallest multiple of `to` that is not below `offset`: each element starts at a multiple of its size (language.md 4).
static uint32_t align_up(uint32_t offset, uint32_t to)
{
    return (offset + to - 1) / to * to;
}

// Continues a CRC with a text, without its NUL.
static uint32_t crc_text(uint32_t crc, const char *text)
{
    for (; *text; text++)
        crc = sm_crc32_byte(crc, (uint8_t)*text);
    return crc;
}

// Returns the CRC of a text that describes the layout: a line "[Region]" for each region, followed by a line "TYPE name" for each of its
// elements.  Two layouts are equal exactly if these texts are equal.
static uint32_t hash_regions(const StateVec *sv)
{
    uint32_t crc = SM_CRC32_START;

    for (size_t i = 0; i < sv->region.n; i++) {
        const Region *r = sv->region.at[i];
        crc = crc_text(crc_text(crc_text(crc, "["), r->name->text), "]\n");
        for (uint32_t j = 0; j < r->count; j++) {
            const Element *e = sv->element.at[r->first + j];
            crc = crc_text(crc_text(crc, sm_type_info[e->type].spelling), " ");
            crc = crc_text(crc_text(crc, e->name->text), "\n");
        }
    }
    return sm_crc32_end(crc);
}

// Computes offsets, sizes and hash of a state vector whose elements and regions are complete.
void layout_state_vector(StateVec *sv)
{
    uint32_t offset = 0;

    for (size_t i = 0; i < sv->region.n; i++) {
        Region *r = sv->region.at[i];

        offset = r->offset = align_up(offset, 8);
        r->packed_size = 0;
        for (uint32_t j = 0; j < r->count; j++) {
            Element *e = sv->element.at[r->first + j];
            uint32_t bytes = sm_type_info[e->type].bytes;

            e->offset = align_up(offset, bytes);
            offset = e->offset + bytes;
            r->packed_size += bytes;
        }
        r->size = offset - r->offset;
    }
    sv->size = align_up(offset, 8);
    sv->hash = hash_regions(sv);
}

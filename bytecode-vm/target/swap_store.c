// SPDX-License-Identifier: Apache-2.0
// Implements swap_store.h.  Only the write of a head changes which set is current, and the head that it overwrites is not the current one.
#include "bytecode-vm/target/swap_store.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "runtime-c/link/link.h"
#include "stdlib/crc32.h"
#include "stdlib/flash.h"

// Offsets in a head.
enum { NUMBER_AT = 8, PLACE_AT = 12, LENGTH_AT = 16, CHECK_AT = 20, CODE_AT = 24, CRC_AT = 40, HEAD = 44 };
enum { HEAD_STRIDE = 64, SETS_AT = 2 * HEAD_STRIDE, PIECE = 256, NUMBERS = 8 };       // NUMBERS: bytes of a machine after its name

static const uint8_t magic[NUMBER_AT] = {'s', 'm', 'c', 's', 'w', 'a', 'p', '1'};

static SmSwapStore *store_of(SmSwapStorage *storage) { return (SmSwapStore *)(void *)storage; }

// ---- check of a set ----

// The CRC of a set, and its code if there is a key.
typedef struct SetCheck {
    uint32_t crc;
    SmvmMac mac;
    const uint8_t *key;
} SetCheck;

static void check_bytes(SetCheck *k, const uint8_t *bytes, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        k->crc = sm_crc32_byte(k->crc, bytes[i]);
        if (k->key)
            smvm_mac_byte(&k->mac, bytes[i]);
    }
}

// Begins the CRC and the code of a set with the fields from NUMBER_AT to LENGTH_AT of its head.
static void begin_check(SetCheck *k, const SmSwapStore *s, const uint8_t *head)
{
    k->crc = SM_CRC32_START;
    k->key = s->key;
    if (!k->key)
        return;
    smvm_mac_begin(&k->mac, k->key);
    for (uint8_t i = NUMBER_AT; i < CHECK_AT; i++)
        smvm_mac_byte(&k->mac, head[i]);
}

// Stores the CRC and the code in a head, or zeros without a key.
static void end_check(SetCheck *k, uint8_t *head)
{
    sm_link_store(head + CHECK_AT, sm_crc32_end(k->crc), 4);
    memset(head + CODE_AT, 0, SMVM_CODE);
    if (k->key)
        smvm_mac_end(&k->mac, k->key, head + CODE_AT);
    sm_link_store(head + CRC_AT, sm_crc32(head, CRC_AT), 4);
}

// ---- reading a set ----

static bool is_valid_head(const uint8_t *head, uint32_t size)
{
    const uint32_t at = sm_link_load(head + PLACE_AT, 4), length = sm_link_load(head + LENGTH_AT, 4);

    return memcmp(head, magic, sizeof magic) == 0 && sm_link_load(head + CRC_AT, 4) == sm_crc32(head, CRC_AT) && at >= SETS_AT && at <= size
           && length <= size - at;
}

// Reads the set of head 0 or 1.  The set is intact if the head and the set have the right checksums, and with a key the right code.
static SmSwapSet read_set(const SmSwapStore *s, uint32_t which)
{
    uint8_t head[HEAD], now[HEAD], piece[PIECE];
    SmSwapSet set = {0, 0, 0, false};
    PalNvmInfo info;
    SetCheck k;

    if (pal_nvm_info(s->nvm, &info) != SM_OK || pal_nvm_read(s->nvm, which * HEAD_STRIDE, head, HEAD) != SM_OK || !is_valid_head(head, info.size))
        return set;
    set.number = sm_link_load(head + NUMBER_AT, 4);
    set.at = sm_link_load(head + PLACE_AT, 4);
    set.length = sm_link_load(head + LENGTH_AT, 4);
    begin_check(&k, s, head);
    for (uint32_t done = 0, n; done < set.length; done += n) {
        n = set.length - done < PIECE ? set.length - done : PIECE;
        if (pal_nvm_read(s->nvm, set.at + done, piece, n) != SM_OK)
            return set;
        check_bytes(&k, piece, n);
    }
    memcpy(now, head, HEAD);
    end_check(&k, now);
    set.is_intact = set.number % 2 == which && memcmp(now, head, HEAD) == 0;
    return set;
}

// Stores the newest intact set in s->current.
static void find_current(SmSwapStore *s)
{
    const SmSwapSet first = read_set(s, 0), second = read_set(s, 1);

    s->current = first.is_intact && !(second.is_intact && second.number - first.number < UINT32_MAX / 2) ? first : second;
}

// ---- opening ----

// Whether a head is one of this module, or blank.  A power cut during the first write can have left one byte of any value.
static bool is_ours_or_blank(const uint8_t *head, uint8_t blank)
{
    unsigned others = 0;

    for (uint8_t i = 0; i < sizeof magic; i++)
        others += head[i] != magic[i] && head[i] != blank;
    return others <= 1;
}

static bool is_blank(const uint8_t *bytes, uint32_t n, uint8_t blank)
{
    while (n > 0 && bytes[n - 1] == blank)
        n--;
    return n == 0;
}

// Reads both heads; bytes after the end of the memory are blank.
static SmResult read_heads(const SmSwapStore *s, const PalNvmInfo *info, uint8_t heads[SETS_AT])
{
    memset(heads, info->blank, SETS_AT);
    return pal_nvm_read(s->nvm, 0, heads, info->size < SETS_AT ? info->size : SETS_AT);
}

// Opens the memory without extending it, and checks that it can be used.
static SmResult open_at_current_size(SmSwapStore *s, PalNvmInfo *info, bool *was_blank)
{
    uint8_t heads[SETS_AT];
    SmResult r = pal_nvm_open(&s->nvm, s->memory, 1);

    if (r != SM_OK)
        return r;
    r = pal_nvm_info(s->nvm, info);
    if (r == SM_OK)
        r = info->write > 1 || info->erase > 0 ? SM_E_UNSUPPORTED : read_heads(s, info, heads);
    if (r == SM_OK && (!is_ours_or_blank(heads, info->blank) || !is_ours_or_blank(heads + HEAD_STRIDE, info->blank)))
        r = SM_E_FOREIGN;
    *was_blank = r == SM_OK && is_blank(heads, SETS_AT, info->blank);
    if (r != SM_OK)
        (void)pal_nvm_close(s->nvm);
    return r;
}

// Returns the address of the next set. Sets alternate between two places; the current set may have been written with another SmSwapStore.room.
static uint32_t next_place(const SmSwapStore *s)
{
    const uint32_t second = SETS_AT + s->room, end = s->current.at + s->current.length;

    if (!s->current.is_intact || s->current.at >= second)
        return SETS_AT;
    return end > second ? end : second;
}

static uint32_t needed_size(const SmSwapStore *s)
{
    const uint32_t place = next_place(s), second = SETS_AT + s->room;

    return (place > second ? place : second) + s->room;
}

static SmResult open_memory(SmSwapStore *s, bool *was_blank)
{
    PalNvmInfo info;
    SmResult r = open_at_current_size(s, &info, was_blank);

    if (r != SM_OK)
        return r;
    find_current(s);
    if (info.size >= needed_size(s))
        return SM_OK;
    (void)pal_nvm_close(s->nvm);
    return pal_nvm_open(&s->nvm, s->memory, needed_size(s));
}

// ---- starting with stored images ----

static void emit_stored(const SmSwaps *s, const SmSwappable *w, uint32_t image, SmSwapReason why)
{
    SmEvent e = {0, image, 0, w->machine->number, SM_EVENT_STORED};

    e.b = why;
    sm_event(s->events, &e);
}

// The entry of a machine in a set.
typedef struct StoredImage {
    char name[SM_SWAP_NAME];
    uint32_t built_in;        // checksum of the image with which the application was built
    uint32_t at, size;        // where the image begins in the nonvolatile memory, and its length in bytes
} StoredImage;

// Reads the entry of a machine at address *at of the set, and moves *at to the next entry.  Returns false at the end of the set.
static bool read_stored(const SmSwapStore *s, uint32_t *at, StoredImage *out)
{
    const uint32_t end = s->current.at + s->current.length;
    uint8_t n, numbers[NUMBERS];

    if (*at >= end || pal_nvm_read(s->nvm, *at, &n, 1) != SM_OK || n >= SM_SWAP_NAME || end - *at < 1u + n + NUMBERS)
        return false;
    if (pal_nvm_read(s->nvm, *at + 1, out->name, n) != SM_OK || pal_nvm_read(s->nvm, *at + 1 + n, numbers, NUMBERS) != SM_OK)
        return false;
    out->name[n] = '\0';
    out->built_in = sm_link_load(numbers, 4);
    out->size = sm_link_load(numbers + 4, 4);
    out->at = *at + 1 + n + NUMBERS;
    *at = out->at + out->size;
    return out->size <= end - out->at;
}

// Puts a stored image into the second slot.  Reads the image into the memory of the first slot, which the built-in image does not need.
static SmSwapReason load_image(const SmSwapStore *s, SmSwappable *w, const StoredImage *i, uint32_t *checksum)
{
    SmMachine *const m = w->machine;
    SmvmSlot *const first = w->slot[0], *const second = w->slot[1];
    const char *state = m->initial ? m->type->state_name(first, m->initial) : "";
    SmSwapChange c = {m->name, first->memory, i->size, SM_SWAP_RESTART, NULL, false};

    *checksum = 0;
    if (i->size > first->size)
        return SM_SWAP_NO_MEMORY;
    if (i->size < SMVM_HEADER || pal_nvm_read(s->nvm, i->at, first->memory, i->size) != SM_OK)
        return SM_SWAP_NO_IMAGE;
    *checksum = smvm_uint(SMVM_IMAGE(c.image), SMVM_CRC_AT, 4);
    if (i->built_in != w->built_in)
        return SM_SWAP_NO_BUILD;
    if (*state != '\0')
        c.state = state;
    return smvm_slot_load(second, first, &c, m);
}

// Makes `slot` the one whose machine runs from the next step on.
static void choose_slot(SmSwappable *w, uint8_t slot)
{
    w->running = slot;
    w->stored = slot ? w->type->identity(w->slot[1]) : 0;
    w->machine->self = w->slot[slot];
}

static void load_machine(const SmSwapStore *s, const SmSwaps *swaps, SmSwappable *w, const StoredImage *i)
{
    uint32_t checksum;
    const SmSwapReason why = load_image(s, w, i, &checksum);

    if (why == SM_SWAP_NOT_REFUSED)
        choose_slot(w, 1);
    else
        emit_stored(swaps, w, checksum, why);
}

// Removes stored images that would be second writers of an element: because the application now has another writer of the element, or because the
// stored image of the machine that no longer writes the element does not run.  A removal can make another image a second writer, so this repeats.
static void remove_second_writers(const SmSwaps *swaps)
{
    bool again;

    do {
        again = false;
        for (uint16_t i = 0; i < swaps->machines; i++) {
            SmSwappable *w = &swaps->machine[i];
            if (w->running != 1 || !sm_swap_adds_writer(swaps, w, w->slot[0], w->slot[1]))
                continue;
            emit_stored(swaps, w, w->stored, SM_SWAP_NO_WRITER);
            choose_slot(w, 0);
            again = true;
        }
    } while (again);
}

// Starts the machines whose stored images are good.
static void start_stored(const SmSwaps *swaps)
{
    for (uint16_t i = 0; i < swaps->machines; i++) {
        const SmSwappable *w = &swaps->machine[i];
        if (w->running != 1)
            continue;
        w->machine->initial = ((const SmvmSlot *)w->slot[1])->first;
        emit_stored(swaps, w, w->stored, SM_SWAP_NOT_REFUSED);
    }
}

// Reads the built-in image of each machine.  If the verifier rejects one, the start fails later.
static void read_built_in(const SmSwaps *swaps)
{
    for (uint16_t i = 0; i < swaps->machines; i++) {
        SmSwappable *w = &swaps->machine[i];
        const SmLayout *layout = w->machine->sv->layout;
        if (w->machine->type->open(w->slot[0], layout->hash, layout->whole.size) != SM_OK)
            continue;
        w->type->init(w->slot[0], w->slot[1]);
        w->built_in = w->type->identity(w->slot[0]);
    }
}

SmResult sm_swap_store_open(SmSwapStorage *storage, SmSwaps *swaps, SmApp *app)
{
    SmSwapStore *s = store_of(storage);
    StoredImage i;
    bool was_blank = false;
    const SmResult r = open_memory(s, &was_blank);
    uint32_t at = s->current.at;

    if (r != SM_OK) {
        s->nvm.id = 0;
        app->failed_part = SM_TEXT("the storage of swaps");
        app->failed_file = s->memory;
        app->reason = r == SM_E_FOREIGN ? SM_TEXT("the file exists, and is not a storage of swaps") : NULL;
        return r;
    }
    read_built_in(swaps);
    for (uint16_t m = 0; !s->current.is_intact && !was_blank && m < swaps->machines; m++)
        emit_stored(swaps, &swaps->machine[m], 0, SM_SWAP_NO_DAMAGED);
    while (s->current.is_intact && read_stored(s, &at, &i)) {
        SmSwappable *w = sm_swap_find_machine(swaps, i.name);
        if (w && w->built_in != 0)
            load_machine(s, swaps, w, &i);
    }
    remove_second_writers(swaps);
    start_stored(swaps);
    return SM_OK;
}

void sm_swap_store_close(SmSwapStorage *storage)
{
    SmSwapStore *s = store_of(storage);

    if (s->nvm.id != 0)
        (void)pal_nvm_close(s->nvm);
    s->nvm.id = 0;
}

// ---- writing a set ----

// Returns the number of characters of a name; SM_SWAP_NAME if it is longer than a name in a swap.
static uint8_t name_length(const char *name)
{
    uint8_t n = 0;

    while (n < SM_SWAP_NAME && name[n] != '\0')
        n++;
    return n;
}

static const SmvmTarget *running_image(const SmSwappable *w) { return &((const SmvmSlot *)w->slot[w->running])->target; }

// Whether the next set contains an image of the machine: the machine does not run its built-in image, and its name is short enough for a swap.
static bool is_in_set(const SmSwappable *w)
{
    return w->type->identity(w->slot[w->running]) != w->built_in && name_length(w->machine->name) < SM_SWAP_NAME;
}

static uint32_t bytes_of_machine(const SmSwappable *w) { return 1u + name_length(w->machine->name) + NUMBERS + running_image(w)->size; }

static SmResult write_bytes(const SmSwapStore *s, uint32_t *at, const uint8_t *bytes, uint32_t n, SetCheck *k)
{
    const SmResult r = pal_nvm_write(s->nvm, *at, bytes, n);

    check_bytes(k, bytes, n);
    *at += n;
    return r;
}

static SmResult write_machine(const SmSwapStore *s, const SmSwappable *w, uint32_t *at, SetCheck *k)
{
    const SmvmTarget *t = running_image(w);
    const uint8_t n = name_length(w->machine->name);
    uint8_t head[1 + SM_SWAP_NAME + NUMBERS];
    SmResult r;

    head[0] = n;
    memcpy(head + 1, w->machine->name, n);
    sm_link_store(head + 1 + n, w->built_in, 4);
    sm_link_store(head + 1 + n + 4, t->size, 4);
    r = write_bytes(s, at, head, 1u + n + NUMBERS, k);
    return r == SM_OK ? write_bytes(s, at, (const uint8_t *)t->image, t->size, k) : r;
}

// Returns the set to be written: its number, and a place outside the current set.
static SmSwapSet plan_set(const SmSwapStore *s, const SmSwaps *swaps)
{
    SmSwapSet set = {s->current.number + 1, next_place(s), 0, true};

    for (uint16_t i = 0; i < swaps->machines; i++)
        set.length += is_in_set(&swaps->machine[i]) ? bytes_of_machine(&swaps->machine[i]) : 0;
    return set;
}

static SmResult write_set(const SmSwapStore *s, const SmSwaps *swaps, const SmSwapSet *set, uint8_t *head)
{
    SmResult r = SM_OK;
    uint32_t at = set->at;
    SetCheck k;

    memcpy(head, magic, sizeof magic);
    sm_link_store(head + NUMBER_AT, set->number, 4);
    sm_link_store(head + PLACE_AT, set->at, 4);
    sm_link_store(head + LENGTH_AT, set->length, 4);
    begin_check(&k, s, head);
    for (uint16_t i = 0; i < swaps->machines && r == SM_OK; i++)
        if (is_in_set(&swaps->machine[i]))
            r = write_machine(s, &swaps->machine[i], &at, &k);
    end_check(&k, head);
    return r;
}

// Writes the head of a set, which makes the set the current one.  If that fails, destroys the head, because the write may have stored all of it.
static SmResult write_head(const SmSwapStore *s, const SmSwapSet *set, const uint8_t *head)
{
    const uint32_t at = set->number % 2 * HEAD_STRIDE;
    SmResult r = pal_nvm_write(s->nvm, at, head, HEAD);

    if (r == SM_OK && !read_set(s, set->number % 2).is_intact)
        r = SM_E_DEVICE;
    if (r != SM_OK)
        (void)pal_nvm_erase(s->nvm, at, HEAD);
    return r;
}

SmResult sm_swap_store_save(SmSwapStorage *storage, SmSwaps *swaps)
{
    SmSwapStore *s = store_of(storage);
    const SmSwapSet set = plan_set(s, swaps);
    uint8_t head[HEAD];
    SmResult r = write_set(s, swaps, &set, head);

    if (r == SM_OK)
        r = write_head(s, &set, head);
    if (r != SM_OK)
        return r;
    s->current = set;
    for (uint16_t i = 0; i < swaps->machines; i++)
        swaps->machine[i].stored = is_in_set(&swaps->machine[i])
            ? swaps->machine[i].type->identity(swaps->machine[i].slot[swaps->machine[i].running]) : 0;
    return SM_OK;
}

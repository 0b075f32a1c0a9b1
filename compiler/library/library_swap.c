// SPDX-License-Identifier: Apache-2.0
// Compares two machines of a session, and makes one continue from the state of the other (docs/swapping.md 12).
#include <string.h>

#include "bytecode-vm/swap.h"
#include "compiler/library/library.h"

// ---- the list of what is kept ----

static int32_t kind_of_item(SmvmSwapKind kind)
{
    static const int32_t of[] = {SMC_SWAP_STATE, SMC_SWAP_LOCAL, SMC_SWAP_WINDOW};         // by SmvmSwapKind

    return of[kind];
}

static int32_t fate_of_item(SmvmSwapFate fate)
{
    static const int32_t of[] = {SMC_SWAP_KEPT, SMC_SWAP_ADDED, SMC_SWAP_REMOVED, SMC_SWAP_CHANGED};      // by SmvmSwapFate

    return of[fate];
}

// Copies the list of a plan: its items, then their names.  NULL: out of memory.
static LibrarySwapItem *copy_items(SmcSession *s, const SmvmSwap *plan, uint32_t *items)
{
    SmvmSwapItem item;
    LibrarySwapItem *list;
    uint64_t bytes = 0;
    uint32_t n;
    char *at;

    for (n = 0; smvm_swap_item(plan, n, &item); n++)
        bytes += sizeof *list + item.length + 1;
    if ((list = library_alloc(s, bytes)) == NULL)
        return NULL;
    at = (char *)(list + n);
    for (uint32_t i = 0; smvm_swap_item(plan, i, &item); i++) {
        list[i] = (LibrarySwapItem){kind_of_item(item.kind), fate_of_item(item.fate), at};
        memcpy(at, item.name, item.length);
        at[item.length] = '\0';
        at += item.length + 1;
    }
    *items = n;
    return list;
}

// ---- comparing and continuing ----

typedef struct Swap {
    LibraryMachine *old, *new;
    SmvmSwap *plan;
    LibrarySwapItem *list;
    uint32_t items;
} Swap;

static const char *find_difference(SmResult plan)
{
    switch (plan) {
    case SM_OK: return NULL;
    case SM_E_LAYOUT: return "the machines have state vectors of different layouts";
    default: return "an image has no names";
    }
}

// Returns why a machine cannot be replaced now; NULL: nothing prevents it.
static const char *find_obstacle(const Swap *w)
{
    if (!smvm_state_allows_swap(&w->old->m, smvm_state(w->old->vm)))
        return "the machine is in a state that is marked neither @swap nor @safe";
    if (smvm_swap_state(w->plan, smvm_state(w->old->vm)) == 0)
        return "the new machine has no state of the name of the current one";
    return NULL;
}

// Plans the swap of two machines, and lists what is kept.  After an error, nothing is allocated.
static SmcResult plan_swap(SmcSession *s, SmcMachine from, SmcMachine to, Swap *w)
{
    const char *difference;
    uint32_t size;

    w->old = library_machine(s, from);
    w->new = library_machine(s, to);
    if (!w->old || !w->new)
        return library_no_machine(s);
    if (w->old == w->new)
        return library_fail(s, SMC_E_ARGUMENT, "a machine cannot continue in itself");
    size = smvm_swap_size(&w->old->m, &w->new->m);
    if ((w->plan = library_alloc(s, size)) == NULL)
        return library_fail(s, SMC_E_MEMORY, NULL);
    difference = find_difference(smvm_swap_plan(w->plan, size, &w->old->m, &w->new->m));
    if (!difference && (w->list = copy_items(s, w->plan, &w->items)) != NULL)
        return SMC_OK;
    library_release(s, w->plan);
    return difference ? library_fail(s, SMC_E_REFUSED, difference) : library_fail(s, SMC_E_MEMORY, NULL);
}

// Ends a swap: its list becomes that of the session.
static SmcResult store_list(SmcSession *s, const Swap *w)
{
    library_release(s, w->plan);
    library_release(s, s->swap);
    s->swap = w->list;
    s->swap_items = w->items;
    return SMC_OK;
}

SmcResult smc_swap_compare(SmcSession *s, SmcMachine from, SmcMachine to)
{
    Swap w;
    const SmcResult r = plan_swap(s, from, to, &w);

    return r == SMC_OK ? store_list(s, &w) : r;
}

SmcResult smc_machine_continue(SmcSession *s, SmcMachine from, SmcMachine to)
{
    Swap w;
    const char *obstacle;
    SmcResult r = plan_swap(s, from, to, &w);

    if (r != SMC_OK)
        return r;
    if ((obstacle = find_obstacle(&w)) != NULL) {
        library_release(s, w.plan);
        library_release(s, w.list);
        return library_fail(s, SMC_E_REFUSED, obstacle);
    }
    library_start_machine(w.new, 1);              // smvm_swap_continue requires a machine that has not stepped
    memcpy(w.new->vector, w.old->vector, w.old->m.sv_size);
    smvm_swap_continue(w.plan, w.old->vm, w.new->vm, w.new->vector);
    return store_list(s, &w);
}

// ---- reading the list ----

static const LibrarySwapItem *item_of(const SmcSession *s, uint32_t item)
{
    return library_is_open(s) && item < s->swap_items ? &s->swap[item] : NULL;
}

uint32_t smc_swap_item_count(const SmcSession *s) { return library_is_open(s) ? s->swap_items : 0; }

int32_t smc_swap_item_kind(const SmcSession *s, uint32_t item)
{
    const LibrarySwapItem *i = item_of(s, item);

    return i ? i->kind : -1;
}

int32_t smc_swap_item_fate(const SmcSession *s, uint32_t item)
{
    const LibrarySwapItem *i = item_of(s, item);

    return i ? i->fate : -1;
}

const char *smc_swap_item_name(const SmcSession *s, uint32_t item)
{
    const LibrarySwapItem *i = item_of(s, item);

    return i ? i->name : "";
}

const char *smc_swap_fate_text(int32_t fate)
{
    static const char *const text[] = {
        "kept: both machines have it",
        "new: the old machine does not have it",
        "lost: the new machine does not have it",
        "changed: the machines have it with different types"};         // by SMC_SWAP_KEPT …

    return fate >= SMC_SWAP_KEPT && fate <= SMC_SWAP_CHANGED ? text[fate] : "";
}

// SPDX-License-Identifier: Apache-2.0
// Continues one machine in another (docs/swapping.md 12).  The plan is a table of names for each machine: sorted by name, the two are compared
// in one pass.  The verifier does not check names, so any DEBUG section is possible here: a name is used only if what it names exists.
#include <stddef.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/swap.h"
#include "stdlib/convert.h"

// Longer names are ignored: the compiler cuts names at SWAP_NAME_MAX + 1 bytes, so two names of that length can differ in what was cut.
enum { SWAP_NAME_MAX = SMVM_VARINT_MID - 2 };

typedef struct SwapName {
    SmvmName name;
    uint32_t hash;            // hash of the name
    uint32_t number;          // number of the state or window; or offset of the local among the locals
    uint32_t source;          // for a name of `to` that is kept: its `number` in `from`
    uint32_t numbers;         // for a parameter: offset in the image of the ends of its range
    uint8_t kind, fate;       // SmvmSwapKind or SWAP_PARAMETER; SmvmSwapFate
    uint8_t type;             // SmType of the local
} SwapName;

enum { SWAP_PARAMETER = SMVM_SWAP_SAMPLE + 1 };       // the kind of a parameter, which the list shows as a local

// A plan.  Its memory contains, in this order: SmvmSwap, the names of `to`, the names of `from`, and for each state of `from` its number in `to`.
struct SmvmSwap {
    SmvmMachine from, to;
    uint32_t to_names, from_names;    // how many names each machine has; from_names, after the comparison: how many names only `from` has
    uint32_t map_at;                  // offset of the numbers of states from the start of the plan
};

typedef char swap_plan_keeps_names_aligned[sizeof(SmvmSwap) % sizeof(uint32_t) == 0 && sizeof(SwapName) % sizeof(uint32_t) == 0 ? 1 : -1];

static SwapName *names_of(const SmvmSwap *plan) { return (SwapName *)(void *)((uint8_t *)(uintptr_t)plan + sizeof *plan); }
static uint32_t *state_map(const SmvmSwap *plan) { return (uint32_t *)(void *)((uint8_t *)(uintptr_t)plan + plan->map_at); }

// ---- the names of a machine ----

// Returns a hash of a name, which decides most comparisons of names.
static uint32_t hash_name(SmvmBytes image, SmvmName n)
{
    uint32_t h = UINT32_C(0x811c9dc5);

    for (uint32_t i = 0; i < n.size; i++)
        h = (h ^ smvm_u8(image, (SmvmAt)(n.at + i))) * UINT32_C(0x01000193);
    return h;
}

static bool is_name(SmvmName n) { return n.size > 0 && n.size <= SWAP_NAME_MAX; }

// Adds a name of m to the array `names`, or only counts it if `names` is NULL.
static void add_name(const SmvmMachine *m, SwapName *n, SwapName *names, uint32_t *count)
{
    if (names != NULL) {
        n->hash = hash_name(m->image, n->name);
        names[*count] = *n;
    }
    (*count)++;
}

#if SMVM_PARAMETERS
// Returns the end of the parameters among the locals; 0: the machine has no parameters.
static uint32_t end_of_parameters(const SmvmMachine *m)
{
    SmvmReader r = smvm_parameters(m);
    SmvmParameterEntry p;
    uint32_t end = 0;

    while (smvm_read_parameter(&r, &p))
        end = p.location.offset + p.bytes;            // parameters are listed by offset
    return end;
}

// Stores the names of the parameters of m in the array `names`, or only counts them if `names` is NULL.  Returns their number.
static uint32_t collect_parameters(const SmvmMachine *m, SwapName *names)
{
    SmvmReader r = smvm_parameters(m);
    SmvmParameterEntry p;
    SwapName n;
    uint32_t count = 0;

    memset(&n, 0, sizeof n);
    n.kind = SWAP_PARAMETER;
    while (smvm_read_parameter(&r, &p)) {
        n.name.at = p.name[0];
        n.name.size = p.size[0];
        n.number = p.location.offset;
        n.type = (uint8_t)p.location.type;
        n.numbers = p.numbers;
        if (!is_name(n.name))
            continue;
        add_name(m, &n, names, &count);
    }
    return count;
}

// Whether a value in memory is in the range of parameter n of an image.
static bool is_in_range(SmvmBytes image, const SwapName *n, const void *value)
{
    const uint8_t bytes = (uint8_t)(1u << smvm_type_shift(n->type));
    const SmF64 x = sm_load((SmType)n->type, value);

    return sm_le(sm_cell_to_f64((SmType)n->type, smvm_cell(image, (SmvmAt)n->numbers, bytes)), x)
           && sm_le(x, sm_cell_to_f64((SmType)n->type, smvm_cell(image, (SmvmAt)(n->numbers + bytes), bytes)));
}
#else
static uint32_t end_of_parameters(const SmvmMachine *m) { return (void)m, 0; }
static uint32_t collect_parameters(const SmvmMachine *m, SwapName *names) { return (void)m, (void)names, 0; }
static bool is_in_range(SmvmBytes image, const SwapName *n, const void *value) { return (void)image, (void)n, value != NULL; }
#endif

// Reads variable `index` of the DEBUG section.  Returns false if a swap does not concern it, or if what it names does not exist.  Locals
// below `locals` are parameters: their names are in PARAMETERS, whatever DEBUG calls them.
static bool read_variable(const SmvmMachine *m, uint32_t index, uint32_t locals, SwapName *n)
{
    SmvmVariable is;
    SmvmLocation p;

    n->name = smvm_variable(m, index, &is, &p);
    n->number = p.offset;
    n->type = (uint8_t)p.type;
    n->kind = is == SMVM_IS_LOCAL ? SMVM_SWAP_LOCAL : SMVM_SWAP_SAMPLE;
    if (!is_name(n->name))
        return false;
    if (is == SMVM_IS_LOCAL)
        return n->type < SM_TYPE_COUNT && p.offset >= locals && (uint32_t)1 << smvm_type_shift(n->type) <= m->locals
               && p.offset <= m->locals - ((uint32_t)1 << smvm_type_shift(n->type));
    return is == SMVM_IS_SAMPLE && p.offset < m->windows;
}

// Stores the names of m in the array `names`, or only counts them if `names` is NULL.  Returns their number.
static uint32_t collect_names(const SmvmMachine *m, SwapName *names)
{
    const uint32_t variables = smvm_variables(m), locals = end_of_parameters(m);
    uint32_t count = collect_parameters(m, names);
    SwapName n;

    memset(&n, 0, sizeof n);
    for (uint32_t i = 0; i < m->states + variables; i++) {
        if (i < m->states) {
            n.name = smvm_state_name(m, i + 1);
            n.kind = SMVM_SWAP_STATE;
            n.number = i + 1;
            if (!is_name(n.name))
                continue;
        } else if (!read_variable(m, i - m->states, locals, &n))
            continue;
        add_name(m, &n, names, &count);
    }
    return count;
}

// ---- order ----

// Compares two names of any two images by hash, then by bytes: negative, 0 or positive.
static int compare_texts(SmvmBytes image_a, const SwapName *a, SmvmBytes image_b, const SwapName *b)
{
    if (a->kind != b->kind)
        return a->kind < b->kind ? -1 : 1;
    if (a->hash != b->hash)
        return a->hash < b->hash ? -1 : 1;
    if (a->name.size != b->name.size)
        return a->name.size < b->name.size ? -1 : 1;
    for (uint32_t i = 0; i < a->name.size; i++) {
        const uint8_t x = smvm_u8(image_a, (SmvmAt)(a->name.at + i)), y = smvm_u8(image_b, (SmvmAt)(b->name.at + i));
        if (x != y)
            return x < y ? -1 : 1;
    }
    return 0;
}

// Orders names by kind, then by number.
static int compare_numbers(const SwapName *a, const SwapName *b)
{
    if (a->kind != b->kind)
        return a->kind < b->kind ? -1 : 1;
    return a->number < b->number ? -1 : a->number > b->number;
}

// Whether a comes before b.  `by_name`: in the order of the names, which `image` contains, then by kind and number; else by kind and number alone.
static bool is_before(SmvmBytes image, bool by_name, const SwapName *a, const SwapName *b)
{
    const int order = by_name ? compare_texts(image, a, image, b) : 0;

    return order != 0 ? order < 0 : compare_numbers(a, b) < 0;
}

// Moves n[at] down a heap of `count` names whose largest is n[0].
static void sift_down(SmvmBytes image, bool by_name, SwapName *n, uint32_t at, uint32_t count)
{
    const SwapName moved = n[at];

    for (uint32_t child = 2 * at + 1; child < count; child = 2 * at + 1) {
        if (child + 1 < count && is_before(image, by_name, &n[child], &n[child + 1]))
            child++;
        if (!is_before(image, by_name, &moved, &n[child]))
            break;
        n[at] = n[child];
        at = child;
    }
    n[at] = moved;
}

// A heap sort: no memory, no recursion, and no slow input.
static void sort_names(SmvmBytes image, bool by_name, SwapName *n, uint32_t count)
{
    for (uint32_t i = count / 2; i-- > 0;)
        sift_down(image, by_name, n, i, count);
    for (uint32_t end = count; end > 1; end--) {
        const SwapName last = n[end - 1];
        n[end - 1] = n[0];
        n[0] = last;
        sift_down(image, by_name, n, 0, end - 1);
    }
}

// ---- comparison ----

static uint32_t window_entry(const SmvmMachine *m, uint32_t w) { return smvm_window(m->image, m->windows_at, (SmvmAt)w); }

// Whether `to` can take over the state, value or samples that both machines have under one name.
static bool is_compatible(const SmvmSwap *plan, const SwapName *from, const SwapName *to)
{
    if (to->kind == SMVM_SWAP_LOCAL || to->kind == SWAP_PARAMETER)
        return from->type == to->type;
    return to->kind == SMVM_SWAP_STATE
           || smvm_window_size(window_entry(&plan->from, from->number)) == smvm_window_size(window_entry(&plan->to, to->number));
}

// Sets the fate of every name.  Both tables must be in the order of names.  Of several equal names in `from`, or of several equal states in `to`,
// only the first is matched.
static void match_names(SmvmSwap *plan, SwapName *to, SwapName *from)
{
    uint32_t *const map = state_map(plan);
    uint32_t t = 0, f = 0;

    while (t < plan->to_names || f < plan->from_names) {
        const int order = t == plan->to_names ? 1 : f == plan->from_names ? -1 : compare_texts(plan->to.image, &to[t], plan->from.image, &from[f]);
        const uint32_t first_to = t, first_from = f;
        if (order > 0) {
            from[f++].fate = SMVM_SWAP_REMOVED;
            continue;
        }
        for (; t == first_to || (t < plan->to_names && compare_texts(plan->to.image, &to[t], plan->to.image, &to[first_to]) == 0); t++) {
            to[t].fate = order < 0 ? SMVM_SWAP_ADDED : is_compatible(plan, &from[first_from], &to[t]) ? SMVM_SWAP_KEPT : SMVM_SWAP_CHANGED;
            to[t].source = order < 0 ? 0 : from[first_from].number;
        }
        for (; order == 0 && (f == first_from
                              || (f < plan->from_names && compare_texts(plan->from.image, &from[f], plan->from.image, &from[first_from]) == 0)); f++) {
            from[f].fate = SMVM_SWAP_KEPT;
            if (from[f].kind == SMVM_SWAP_STATE)
                map[from[f].number - 1] = to[first_to].number;
        }
    }
}

// Moves the names of SMVM_SWAP_REMOVED, which only `from` has, to the front.  Returns their number.
static uint32_t select_removed(SwapName *from, uint32_t count)
{
    uint32_t n = 0;

    for (uint32_t i = 0; i < count; i++)
        if (from[i].fate == SMVM_SWAP_REMOVED)
            from[n++] = from[i];
    return n;
}

// ---- the plan ----

// Returns the bytes of a plan with this many names, of both machines together, and states of `from`.
static uint32_t plan_bytes(uint32_t names, uint32_t states)
{
    return (uint32_t)(sizeof(SmvmSwap) + names * sizeof(SwapName) + states * sizeof(uint32_t));
}

// Returns the bytes of memory for a plan.
uint32_t smvm_swap_size(const SmvmMachine *from, const SmvmMachine *to)
{
    return plan_bytes(collect_names(from, NULL) + collect_names(to, NULL), from->states);
}

// Compares two machines by the names of their states, locals and samples.  The result is in memory that the caller owns.
SmResult smvm_swap_plan(SmvmSwap *plan, uint32_t size, const SmvmMachine *from, const SmvmMachine *to)
{
    struct Strict { char c; uint64_t at; };
    SwapName *name;

    if (from->layout != to->layout || from->sv_size != to->sv_size)
        return SM_E_LAYOUT;
    if (from->debug_size == 0 || to->debug_size == 0)
        return SM_E_UNSUPPORTED;
    if (size < smvm_swap_size(from, to))
        return SM_E_MEMORY;
    if ((uintptr_t)plan % offsetof(struct Strict, at) != 0)
        return SM_E_ALIGNMENT;
    plan->from = *from;
    plan->to = *to;
    name = names_of(plan);
    plan->to_names = collect_names(to, name);
    plan->from_names = collect_names(from, name + plan->to_names);
    plan->map_at = plan_bytes(plan->to_names + plan->from_names, 0);
    memset(state_map(plan), 0, from->states * sizeof(uint32_t));
    sort_names(to->image, true, name, plan->to_names);
    sort_names(from->image, true, name + plan->to_names, plan->from_names);
    match_names(plan, name, name + plan->to_names);
    plan->from_names = select_removed(name + plan->to_names, plan->from_names);
    sort_names(to->image, false, name, plan->to_names);
    sort_names(from->image, false, name + plan->to_names, plan->from_names);
    return SM_OK;
}

// Returns the number that state `state` of `from` has in `to`; 0: `to` has no state of this name, or `from` has no such state.
uint32_t smvm_swap_state(const SmvmSwap *plan, uint32_t state)
{
    return state < 1 || state > plan->from.states ? 0 : state_map(plan)[state - 1];
}

// Reads item i of the list of what a swap does with each name: the names of `to`, then those that only `from` has.  Returns false at the end.
bool smvm_swap_item(const SmvmSwap *plan, uint32_t i, SmvmSwapItem *item)
{
    const SwapName *n = names_of(plan) + i;

    if (i >= plan->to_names + plan->from_names)
        return false;
    item->kind = n->kind == SWAP_PARAMETER ? SMVM_SWAP_LOCAL : (SmvmSwapKind)n->kind;
    item->fate = (SmvmSwapFate)n->fate;
    item->name = SMVM_TEXT(i < plan->to_names ? plan->to.image : plan->from.image, n->name.at);
    item->length = n->name.size;
    return true;
}

// ---- the exchange ----

// Fills an empty window with the samples of a window of the same size and another kind.  Each sample must be stored in the slot in which a window of
// that kind has it (swapping.md 12.13), so all slots are added in their order, and then those before the next slot once more.
static void refill_window(const uint64_t *from, uint32_t from_kind, const SmVm *vm, uint64_t *to, uint32_t to_kind, uint32_t n)
{
    const uint32_t count = sm_roll_count(from), next = sm_roll_next(from), more = count < n ? 0 : next;

    memset(to, 0, sm_roll_bytes(n, to_kind));
    if ((from_kind & SM_ROLL_TYPE) == SM_ROLL_TIMES || (to_kind & SM_ROLL_TYPE) == SM_ROLL_TIMES)
        return;                                        // times are only kept in a window of the same kind, which the caller copies as a whole
    for (uint32_t i = 0; i < count + more; i++)
        smvm_sample(vm, to, n, to_kind, sm_roll_value(from_kind, sm_roll_slot_key(from + 1, n, from_kind, (SmRollSize)(i < count ? i : i - count))));
}

static void copy_window(const SmvmSwap *plan, const SmVm *from, uint32_t source, SmVm *to, uint32_t w)
{
    const uint64_t *old = smvm_windows_of((SmVm *)(uintptr_t)from)[source];
    const uint32_t old_entry = window_entry(&plan->from, source), entry = window_entry(&plan->to, w), n = smvm_window_size(entry);
    uint64_t *window = smvm_windows_of(to)[w];

    if (old_entry == entry)
        memcpy(window, old, sm_roll_bytes(n, smvm_window_kind(entry)));
    else
        refill_window(old, smvm_window_kind(old_entry), to, window, smvm_window_kind(entry), n);
}

// Copies the value of a local from `from` to `to`; the value of a parameter only if it is in the range of the new parameter.
static void copy_local(const SmvmSwap *plan, const SmVm *from, SmVm *to, const SwapName *n)
{
    const uint8_t *value = (const uint8_t *)from + from->local + n->source;

    if (n->kind != SWAP_PARAMETER || is_in_range(plan->to.image, n, value))
        memcpy((uint8_t *)to + to->local + n->number, value, (size_t)1 << smvm_type_shift(n->type));
}

static bool is_of_machine(const SmVm *vm, const SmvmMachine *m) { return vm->image == m->image && vm->machine == m->machine_at; }

// Lets `to` continue where `from` is, with the state, T, locals and samples that both have by name.
SmResult smvm_swap_continue(const SmvmSwap *plan, const SmVm *from, SmVm *to, void *sv)
{
    const uint32_t state = smvm_swap_state(plan, from->state);
    const SwapName *name = names_of(plan);

    if (state == 0 || !is_of_machine(from, &plan->from) || !is_of_machine(to, &plan->to))
        return SM_E_ARGUMENT;
    to->state = (SmvmAt)state;
    to->start = from->start;
    to->next = from->next;
    to->first = from->first;
    for (uint32_t i = 0; i < plan->to_names; i++) {
        if (name[i].fate != SMVM_SWAP_KEPT)
            continue;
        if (name[i].kind == SMVM_SWAP_LOCAL || name[i].kind == SWAP_PARAMETER)
            copy_local(plan, from, to, &name[i]);
        else if (name[i].kind == SMVM_SWAP_SAMPLE)
            copy_window(plan, from, name[i].source, to, name[i].number);
    }
    smvm_write_state(to, &plan->to, sv);
    return SM_OK;
}

// Stores the number of the machine's state in S, as smvm_init does: for a machine that smvm_prepare started.
void smvm_write_state(const SmVm *vm, const SmvmMachine *m, void *sv) { sm_cell_store(SM_U32, (uint8_t *)sv + m->s, vm->state); }

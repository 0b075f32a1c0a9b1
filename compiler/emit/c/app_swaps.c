// SPDX-License-Identifier: Apache-2.0
// Writes the tables of runtime-c/swap.h, for machines that can be swapped while the application runs.
#include "compiler/emit/c/app_emitter.h"

// Whether any machine of the application can be exchanged while it runs.
bool app_has_swaps(const App *app)
{
    for (size_t i = 0; i < app->machine.n; i++)
        if (app->machine.at[i]->swap)
            return true;
    return false;
}

// Whether the executor has a gate (write_gates): it runs a machine that can be swapped.
bool app_has_gate(const AppExecutor *x)
{
    for (size_t r = 0; r < x->rate.n; r++)
        for (size_t t = 0; t < x->rate.at[r]->task.n; t++)
            if (x->rate.at[r]->task.at[t]->machine && x->rate.at[r]->task.at[t]->machine->swap)
                return true;
    return false;
}

// Returns the index of machine m in the list of machines that can be swapped.
unsigned app_swappable_index(const App *app, const AppMachine *m)
{
    unsigned n = 0;

    for (size_t i = 0; app->machine.at[i] != m; i++)
        n += app->machine.at[i]->swap;
    return n;
}

static unsigned swappable_count(const App *app)
{
    unsigned n = 0;

    for (size_t i = 0; i < app->machine.n; i++)
        n += app->machine.at[i]->swap;
    return n;
}

// Writes the row of each machine that executor x runs and that can be swapped.  `gate`: the index of the executor's gate.
static void write_swappables_of(const AppEmitter *e, const AppExecutor *x, unsigned gate)
{
    for (size_t r = 0; r < x->rate.n; r++)
        for (size_t t = 0; t < x->rate.at[r]->task.n; t++) {
            const AppMachine *m = x->rate.at[r]->task.at[t]->machine;
            if (m && m->swap)
                buf_printf(e->out, "    {.machine = &machines[%u], .type = &smvm_slot_type, .slot = {&%sSelf[0], &%sSelf[1]}, .executor = %u},\n",
                           (unsigned)m->number, m->name->text, m->name->text, gate);
        }
}

// Writes the gates, one for each executor with swappable machines, and their tasks: one runs at the beginning of a tick, one at its end. They
// exchange machines between steps.
static void write_gates(const AppEmitter *e, unsigned gates)
{
    const unsigned number = (unsigned)e->app->task.n;

    buf_str(e->out, "static SmSwapGate gates[] = {\n");
    for (unsigned g = 0; g < gates; g++)
        buf_printf(e->out, "    {.swaps = &%s_swaps},\n", e->prefix);
    buf_str(e->out, "};\nstatic SmTask gateTasks[] = {\n");
    for (unsigned g = 0; g < gates; g++)
        buf_printf(e->out,
                   "    {.name = \"swap\", .init = sm_swap_gate_init, .step = sm_swap_gate_enter, .context = &gates[%u], .number = %u},\n"
                   "    {.name = \"swap\", .step = sm_swap_gate_leave, .context = &gates[%u], .number = %u},\n", g, number, g, number);
    buf_str(e->out, "};\nstatic SmTask *const gateOrder[] = {\n");
    for (unsigned i = 0; i < 2 * gates; i++)
        buf_printf(e->out, "    &gateTasks[%u],\n", i);
    buf_str(e->out, "};\n");
}

bool app_has_storage(const AppEmitter *e) { return app_has_swaps(e->app) && e->app->swap_store; }

bool app_is_reached(const AppEmitter *e) { return app_has_swaps(e->app) && e->app->swap_at.place != APP_NOWHERE; }

// Returns the size of the buffer for a swap of all machines at once: SM_SWAP_ROOM.  The link can send at most 2^24 - 1 bytes.
static unsigned swap_buffer_size(const AppEmitter *e, unsigned swappables)
{
    const uint64_t names = 6 + 2 * 64, size = 2 + swappables * (e->app->swap_room + names) + 20;

    return size < 0xffffff ? (unsigned)size : 0xffffff;
}

// Writes the SmSwapLink that serves requests from outside (bytecode-vm/target/swap_link.h), with its buffer for one swap.
static void write_swap_link(const AppEmitter *e, unsigned swappables)
{
    static const char *const place[] = {"", "SM_SWAP_AT_PATH", "SM_SWAP_AT_ADDRESS", "SM_SWAP_AT_LINE"};
    const AppSwapAt *at = &e->app->swap_at;

    buf_printf(e->out, "\nstatic uint8_t swapBuffer[%u];        // for a swap that a host sends\n", swap_buffer_size(e, swappables));
    buf_printf(e->out, "static SmSwapChange swapChanges[%u];\nstatic SmSwapLink swapLink = {\n    .service = SM_SWAP_LINK_SERVICE, "
                       ".swaps = &%s_swaps, .place = %s, .name = \"%s\",\n", swappables, e->prefix, place[at->place], app_escape_string(e, at->name));
    if (at->place == APP_AT_ADDRESS)
        buf_printf(e->out, "    .address = {{%u, %u, %u, %u}, %u},\n", at->ip[0], at->ip[1], at->ip[2], at->ip[3], at->port);
    if (at->place == APP_AT_LINE)
        buf_printf(e->out, "    .speed = %u,\n", (unsigned)at->speed);
    if (at->key)
        buf_printf(e->out, "    .key_file = \"%s\", .number_memory = \"%s.used\",\n", app_escape_string(e, at->key), app_escape_string(e, at->key));
    buf_printf(e->out, "    .machine = machines, .machines = %u, .change = swapChanges, .buffer = swapBuffer, .room = sizeof swapBuffer\n};\n",
               (unsigned)e->app->machine.n);
}

// Returns the most bytes of a stored set of images of all machines: SM_SWAP_STORE_ROOM. The memory contains two sets, and has at most 2^31 bytes.
static unsigned storage_room(const AppEmitter *e, unsigned swappables)
{
    const uint64_t size = swappables * ((uint64_t)e->app->swap_room + 9 + 64);

    return size < 0x3fffffff ? (unsigned)size : 0x3fffffff;
}

// Writes the SmSwapStore that stores the images of confirmed swaps (bytecode-vm/target/swap_store.h).
static void write_storage(const AppEmitter *e, unsigned swappables)
{
    buf_printf(e->out, "\nstatic SmSwapStore swapStore = {\n    .storage = SM_SWAP_STORE_STORAGE, .memory = \"%s\", .room = %u%s\n};\n",
               app_escape_string(e, e->app->swap_store), storage_room(e, swappables),
               app_is_reached(e) && e->app->swap_at.key ? ", .key = swapLink.key" : "");
}

// Sets written[i] for each element i that the program can store.
static void mark_outputs(const Program *p, bool *written)
{
    for (size_t v = 0; v < p->var.n; v++)
        if (p->var.at[v]->element && (p->var.at[v]->written || p->var.at[v] == p->s))
            written[p->var.at[v]->element->index] = true;
}

// Marks in `written`, by index, the elements that channels write: fields of received messages, statistics and ages of messages.
static void mark_messages(const Network *net, bool *written)
{
    for (size_t c = 0; c < net->channel.n; c++) {
        const NetChannel *channel = net->channel.at[c];
        for (size_t i = 0; !channel->is_send && i < channel->field.n; i++)
            written[channel->field.at[i].element->index] = true;
        for (size_t i = 0; i < channel->statistic.n; i++)
            written[channel->statistic.at[i].element->index] = true;
        if (channel->age)
            written[channel->age->index] = true;
    }
}

// Returns, by element, whether code other than a swappable machine stores it: another machine, an input pin, a message, a statistic …
static const bool *find_written(const AppEmitter *e)
{
    const App *a = e->app;
    bool *written = ARENA_ARRAY(e->arena, bool, a->sv->element.n);

    for (size_t i = 0; i < a->machine.n; i++)
        if (!a->machine.at[i]->swap)
            mark_outputs(a->machine.at[i]->program, written);
    for (size_t i = 0; a->pins && i < a->pins->pin.n; i++)
        if (!pin_is_output(&a->pins->pin.at[i]))
            written[a->pins->pin.at[i].element->index] = true;
    if (a->net)
        mark_messages(a->net, written);
    if (a->time)
        written[a->time->index] = true;
    for (size_t x = 0; x < a->executor.n; x++)
        for (size_t i = 0; i < APP_STATISTICS; i++)
            if (a->executor.at[x]->statistic[i])
                written[a->executor.at[x]->statistic[i]->index] = true;
    return written;
}

// Writes the elements that a machine must not store when it replaces another one. Returns whether there are any.
static bool write_written(const AppEmitter *e)
{
    const bool *written = find_written(e);
    const char *before = "\nstatic const SmRange written[] = {\n";
    bool some = false;

    for (size_t i = 0; i < e->app->sv->element.n; i++) {
        const Element *x = e->app->sv->element.at[i];
        if (!written[i])
            continue;
        buf_printf(e->out, "%s    {%u, %u},      // %s\n", before, (unsigned)x->offset, (unsigned)sm_type_info[x->type].bytes, x->name->text);
        before = "";
        some = true;
    }
    if (some)
        buf_str(e->out, "};\n");
    return some;
}

// Writes the tables of runtime-c/swap.h.
void app_write_swaps(const AppEmitter *e)
{
    unsigned gates = 0;
    bool some_written;

    if (!app_has_swaps(e->app))
        return;
    buf_str(e->out, "\n// ---- swaps ----\n\nstatic SmSwappable swappables[] = {\n");
    for (size_t x = 0; x < e->app->executor.n; x++)
        if (app_has_gate(e->app->executor.at[x]))
            write_swappables_of(e, e->app->executor.at[x], gates++);
    buf_str(e->out, "};\n");
    write_gates(e, gates);
    if (app_is_reached(e))
        write_swap_link(e, swappable_count(e->app));
    if (app_has_storage(e))
        write_storage(e, swappable_count(e->app));
    some_written = write_written(e);
    buf_printf(e->out, "\nSmSwaps %s_swaps = {\n    .writing = SM_SWAP_WRITING, .next = %s, .machine = swappables, "
                       ".machines = sizeof swappables / sizeof *swappables,\n    .gate = gates, .gates = %u, .trial = %u, "
                       ".sv = &%s_vector, .events = &events", e->prefix,
               app_has_task(e, AST_TASK_keep) || app_has_task(e, AST_TASK_log) ? "&sm_writing" : "NULL", gates, (unsigned)e->app->swap_trial, e->sv);
    if (e->app->armed)
        buf_printf(e->out, ", .armed = %s", app_element_address(e, e->app->armed));
    if (some_written)
        buf_str(e->out, ",\n    .written = written, .writtens = sizeof written / sizeof *written");
    if (app_is_reached(e))
        buf_str(e->out, ", .service = &swapLink.service");
    if (app_has_storage(e))
        buf_str(e->out, ", .storage = &swapStore.storage");
    buf_str(e->out, "\n};\n");
}

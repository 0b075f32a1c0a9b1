// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/app_view.h"

#include "compiler/cli/key.h"

// ---- messages ----

const char *app_trial_end_text(uint8_t end)
{
    return end == SM_SWAP_WAS_CONFIRMED   ? "it was confirmed"
           : end == SM_SWAP_TOOK_TOO_LONG ? "it was not confirmed in time"
                                          : "a new machine entered a state marked @abort";
}

void app_describe_swap(Buf *out, const ApplicationSwap *s)
{
    switch (s->phase) {
    case SM_SWAP_IDLE: buf_str(out, "no swap yet\n"); break;
    case SM_SWAP_PREPARING: buf_str(out, "a swap is being prepared\n"); break;
    case SM_SWAP_WAITING: buf_str(out, "a swap waits for the end of a tick\n"); break;
    case SM_SWAP_TRIAL: buf_str(out, "a swap is on trial; 'smc device confirm' keeps it\n"); break;
    case SM_SWAP_CONFIRMED: buf_str(out, "the last swap was confirmed\n"); break;
    case SM_SWAP_RETURNED: buf_printf(out, "the old machines returned from the last swap: %s\n", app_trial_end_text(s->end)); break;
    default: buf_printf(out, "the last swap was refused: %s\n", application_reason_text(s->reason)); break;
    }
}

// ---- actions ----

// Writes one line about a machine of the application: the checksum and the identity of its image, or that it cannot be swapped.
static void describe_machine(Buf *out, const ApplicationMachine *m)
{
    buf_printf(out, "%s: ", m->name);
    if (!m->can_swap) {
        buf_str(out, "cannot be swapped\n");
        return;
    }
    buf_printf(out, "checksum %08lx, identity ", (unsigned long)m->checksum);
    for (size_t k = sizeof m->identity; k-- > 0;)          // most significant byte first, as disasm and report write it
        buf_printf(out, "%02x", m->identity[k]);
    buf_printf(out, ", state %lu%s%s%s%s\n", (unsigned long)m->state, *m->state_name ? " " : "", m->state_name,
               m->is_built_in ? ", built in" : m->is_stored ? ", stored" : m->is_on_trial ? "" : ", not stored", m->is_on_trial ? ", on trial" : "");
}

static int describe_last_swap(BoardLine *b, Buf *out)
{
    ApplicationSwap s;

    if (!application_read_swap(&b->host, &s))
        return board_report_failure(b, "asking for the last swap");
    app_describe_swap(out, &s);
    return EXIT_OK;
}

int app_list_machines(BoardLine *b, Buf *out)
{
    ApplicationMachine m;

    for (uint16_t i = 0; i < b->app.machines; i++) {
        if (!application_read_machine(&b->host, i, &m))
            return board_report_failure(b, "asking for the machines");
        describe_machine(out, &m);
    }
    return describe_last_swap(b, out);
}

int app_show_info(BoardLine *b, Buf *out)
{
    const ApplicationInfo *i = &b->app;

    buf_printf(out, "application %s: %u machine%s, swaps of up to %lu bytes\n", i->name, (unsigned)i->machines, i->machines == 1 ? "" : "s",
               (unsigned long)i->room);
    if (i->requires_signature)
        buf_printf(out, "takes signed swaps only, with key %08lx, with numbers above %lu\n", (unsigned long)i->mark, (unsigned long)i->newest);
    return app_list_machines(b, out);
}

// Reads the file of --key into `room` and points *key to it, if the application accepts signed swaps only; else *key is NULL. Returns EXIT_OK,
// or the exit code after a message.
int app_load_key(BoardLine *b, uint8_t room[16], const uint8_t **key)
{
    int code;

    *key = NULL;
    if (!b->app.requires_signature)
        return EXIT_OK;
    if (!b->c->given[OPT_KEY]) {
        cli_print_error(b->c, TEXT_app_needs_key, (unsigned long)b->app.mark);
        return EXIT_PROBLEM;
    }
    if ((code = key_load(b->c, room)) != EXIT_OK)
        return code;
    *key = room;
    if (smvm_auth_mark(room) == b->app.mark)
        return EXIT_OK;
    cli_print_error(b->c, TEXT_app_other_key, (unsigned long)b->app.mark, (unsigned long)smvm_auth_mark(room));
    return EXIT_PROBLEM;
}

int app_confirm_swap(BoardLine *b, Buf *out)
{
    uint8_t room[SMVM_KEY];
    const uint8_t *key;
    ApplicationSwap s;
    int code;

    if (!application_read_swap(&b->host, &s))
        return board_report_failure(b, "asking for the last swap");
    if (s.phase != SM_SWAP_TRIAL || s.checksum == 0) {
        cli_print_error(b->c, s.phase == SM_SWAP_TRIAL ? TEXT_own_swap : TEXT_nothing_on_trial);
        app_describe_swap(out, &s);
        return EXIT_PROBLEM;
    }
    if ((code = app_load_key(b, room, &key)) != EXIT_OK)
        return code;
    if (!application_confirm(&b->host, &s, key))
        return board_report_failure(b, "it was not confirmed");
    return app_list_machines(b, out);
}

int app_refuse_erase(BoardLine *b, Buf *out)
{
    (void)out;
    cli_print_error(b->c, TEXT_app_no_erase);
    return EXIT_PROBLEM;
}

int app_refuse_parameters(BoardLine *b, Buf *out)
{
    (void)out;
    cli_print_error(b->c, TEXT_app_no_parameters);
    return EXIT_PROBLEM;
}

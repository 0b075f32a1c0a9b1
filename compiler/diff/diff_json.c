// SPDX-License-Identifier: Apache-2.0
// A comparison as JSON.  Names of keys, parts, kinds and weights are stable.
#include <inttypes.h>

#include "compiler/base/json.h"
#include "compiler/base/path.h"
#include "compiler/diff/diff_part.h"

static void write_member(Buf *out, const char *key, const char *text)
{
    buf_printf(out, ",\"%s\":", key);
    json_put_string(out, text);
}

static void write_line_number(Buf *out, const char *key, const Stmt *s)
{
    if (s)
        buf_printf(out, ",\"%s\":%lu", key, (unsigned long)source_position(s->span.src, s->span.at).line);
}

static void write_change(const DiffChange *c, Buf *out)
{
    buf_printf(out, "{\"part\":\"%s\",\"how\":\"%s\",\"weight\":\"%s\"", diff_part_name[c->part], diff_how_name[c->how], diff_weight_name[c->weight]);
    write_member(out, "where", c->where);
    write_member(out, "what", c->what);
    write_member(out, "old", c->old);
    write_member(out, "new", c->new);
    write_member(out, "meaning", c->meaning);
    write_line_number(out, "old_line", c->old_stmt);
    write_line_number(out, "new_line", c->new_stmt);
    buf_char(out, '}');
}

static void write_run(const DiffRun *r, Buf *out)
{
    buf_str(out, "{\"script\":");
    json_put_string(out, r->script);
    write_member(out, "problem", r->problem);
    buf_printf(out, ",\"same\":%s,\"steps\":%" PRIu64, r->problem ? "null" : r->same ? "true" : "false", r->steps);
    write_member(out, "old_result", r->old_result);
    write_member(out, "new_result", r->new_result);
    if (r->step) {
        buf_printf(out, ",\"step\":%" PRIu64 ",\"G\":%" PRIu64, r->step, r->g);
        write_member(out, "old_state", r->old_state);
        write_member(out, "new_state", r->new_state);
        buf_str(out, ",\"values\":[");
        for (uint32_t i = 0; i < r->values; i++) {
            buf_str(out, i ? ",{\"name\":" : "{\"name\":");
            json_put_string(out, r->value[i].name);
            write_member(out, "old", r->value[i].old);
            write_member(out, "new", r->value[i].new);
            buf_char(out, '}');
        }
        buf_char(out, ']');
    }
    buf_char(out, '}');
}

void diff_write_json(const ProgramDiff *d, Buf *out)
{
    buf_printf(out, "{\"smc-diff\":1,\"old\":");
    json_put_string(out, path_portable_name(d->old.p->src->name));
    write_member(out, "new", path_portable_name(d->new.p->src->name));
    buf_printf(out, ",\"same\":%s,\"same_layout\":%s,\"same_image\":%s", diff_is_same(d) ? "true" : "false", d->same_layout ? "true" : "false",
               d->same_image ? "true" : "false");
    write_member(out, "swap", d->swap);
    buf_str(out, ",\n\"changes\":[");
    for (size_t i = 0; i < d->change.n; i++) {
        buf_str(out, i ? ",\n" : "\n");
        write_change(&d->change.at[i], out);
    }
    buf_str(out, "],\n\"scripts\":[");
    for (size_t i = 0; i < d->run.n; i++) {
        buf_str(out, i ? ",\n" : "\n");
        write_run(&d->run.at[i], out);
    }
    buf_str(out, "],\n\"costs\":[");
    for (size_t i = 0; i < d->cost.n; i++)
        buf_printf(out, "%s{\"name\":\"%s\",\"old\":%" PRIu64 ",\"new\":%" PRIu64 "}", i ? ",\n" : "\n", d->cost.at[i].name, d->cost.at[i].old,
                   d->cost.at[i].new);
    buf_str(out, "],\n\"findings\":[");
    for (size_t i = 0; i < d->finding.n; i++) {
        const DiffFinding *f = &d->finding.at[i];
        buf_printf(out, "%s{\"appeared\":%s,\"code\":\"%s\"", i ? ",\n" : "\n", f->appeared ? "true" : "false", diag_info[f->diag->code].id);
        write_member(out, "where", f->where);
        write_member(out, "message", f->diag->text);
        buf_char(out, '}');
    }
    buf_str(out, "]}\n");
}

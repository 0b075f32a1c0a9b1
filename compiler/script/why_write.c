// SPDX-License-Identifier: Apache-2.0
// The forms of an answer: text, and JSON with the same lines.
#include <inttypes.h>

#include "compiler/base/json.h"
#include "compiler/base/path.h"
#include "compiler/script/why.h"

static const char *const kind_name[WHY_KIND_COUNT] = {
#define KIND(constant, name) name,
    WHY_KINDS(KIND)
#undef KIND
};

void why_write_text(const WhyAnswer *a, Buf *out)
{
    for (uint32_t i = 0; i < a->line.n; i++) {
        const WhyLine *l = &a->line.at[i];
        buf_spaces(out, 2 * (size_t)l->depth);
        if (l->at.src)
            buf_printf(out, "%s:%lu: ", l->at.src->name, (unsigned long)source_position(l->at.src, l->at.at).line);
        buf_printf(out, "%s\n", l->text);
    }
}

static void write_position(Span at, Buf *out)
{
    const LineCol lc = source_position(at.src, at.at);

    buf_str(out, ",\"file\":");
    json_put_string(out, source_short_name(at.src));
    buf_printf(out, ",\"line\":%lu,\"column\":%lu", (unsigned long)lc.line, (unsigned long)lc.col);
}

static void write_change(const WhyChange *c, Buf *out)
{
    buf_str(out, ",\"variable\":");
    json_put_string(out, c->var->name->text);
    buf_str(out, ",\"value\":\"");
    format_cell_shortest(out, c->var->type, c->cell);
    buf_str(out, "\",\"was\":\"");
    format_cell_shortest(out, c->var->type, c->was);
    buf_printf(out, "\",\"whole_run\":%s,\"transition\":", c->var->parameter ? "true" : "false");
    json_put_string(out, c->next ? c->next->name->text : NULL);
}

static void write_line(const WhyLine *l, Buf *out)
{
    buf_printf(out, "{\"kind\":\"%s\",\"depth\":%u,\"text\":", kind_name[l->kind], l->depth);
    json_put_string(out, l->text);
    if (l->at.src)
        write_position(l->at, out);
    if (l->e)
        buf_printf(out, ",\"value\":%s", l->truth ? "true" : "false");
    if (l->has_gap) {
        buf_str(out, ",\"gap\":");
        format_number_shortest(out, l->gap);
    }
    if (l->step)
        buf_printf(out, ",\"%s\":%" PRIu64, l->e ? "since" : "step", l->step);
    if (l->kind == WHY_CHANGE)
        write_change(&l->change, out);
    buf_char(out, '}');
}

void why_write_json(const WhyAnswer *a, Buf *out)
{
    buf_printf(out, "{\"smc-why\":1,\"step\":%" PRIu64 ",\"G\":%" PRIu64 ",\"lines\":[\n", a->step, a->g);
    for (uint32_t i = 0; i < a->line.n; i++) {
        write_line(&a->line.at[i], out);
        buf_str(out, i + 1 < a->line.n ? ",\n" : "\n");
    }
    buf_str(out, "]}\n");
}

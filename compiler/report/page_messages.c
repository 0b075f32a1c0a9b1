// SPDX-License-Identifier: Apache-2.0
// Messages: what the application exchanges with other computers (config.md 11), and what the machine sees while a message is absent.
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

static const DocColumn message_columns[] = {
    {"message", "Message"}, {"direction", "Direction"}, {"peer", "Other side"}, {"every", "Every, ms"}, {"silent", "Silent after, ms"},
    {"bytes", "Bytes"}, {"sealed", "Sealed"}, {"elements", "Elements"}};
static const DocColumn element_columns[] = {{"element", "Element"}, {"message", "Received in"}, {"silent", "While the message is absent"}};

// Returns a number of nanoseconds in milliseconds; "" for 0.
static const char *milliseconds(const Report *r, uint64_t ns) { return ns ? report_format_number(r->arena, (double)ns / 1e6) : ""; }

static const char *peer_text(const Report *r, const NetChannel *c)
{
    const bool any = (c->ip[0] | c->ip[1] | c->ip[2] | c->ip[3]) == 0;
    const char *address = any ? format_in(r->arena, "port %u", (unsigned)c->port) : net_address_text(r->arena, c);

    switch (c->transport) {
    case NET_TCP_SERVER: return format_in(r->arena, "TCP, listens on %s for %lu", address, (unsigned long)c->peers);
    case NET_TCP_CLIENT: return format_in(r->arena, "TCP, connects to %s", address);
    default:             return format_in(r->arena, "UDP, %s %s", c->is_send ? "to" : "on", address);
    }
}

static const char *elements_text(const Report *r, const NetChannel *c)
{
    Buf b;

    buf_init(&b, r->arena);
    for (size_t i = 0; i < c->field.n; i++)
        buf_printf(&b, "%s%s", i ? ", " : "", c->field.at[i].element->name->text);
    return buf_text(&b);
}

static void add_channels(const Report *r, Doc *d)
{
    DocTable *t = DOC_ADD_TABLE(d, "messages", message_columns);

    for (size_t i = 0; i < r->net->channel.n; i++) {
        const NetChannel *c = r->net->channel.at[i];
        doc_add_plain_cell(t, c->name->text);
        doc_add_plain_cell(t, c->is_send ? "sent" : "received");
        doc_add_plain_cell(t, peer_text(r, c));
        doc_add_plain_cell(t, milliseconds(r, c->period));
        doc_add_plain_cell(t, milliseconds(r, c->timeout));
        doc_add_number_cell(t, c->size);
        doc_add_plain_cell(t, c->key ? "yes" : "");
        doc_add_plain_cell(t, elements_text(r, c));
    }
}

// What a receiver reads from the field while no message arrives.
static const char *silent_text(const Report *r, const NetChannel *c, const NetField *f)
{
    const SmType type = f->element->type;

    switch (f->silent) {
    case NET_UNKNOWN: return type == SM_F32 || type == SM_F64 ? "NaN, which reads as 0" : type == SM_BOOL ? "false" : "0";
    case NET_DEFAULT: return report_format_cell(r->arena, type, f->cell);
    case NET_SAFE:    return format_in(r->arena, "%s, also before the first one", report_format_cell(r->arena, type, f->cell));
    default:          return c->timeout ? "keeps its value" : "keeps its value: no timeout";
    }
}

static void add_received_elements(const Report *r, Doc *d)
{
    DocTable *t = DOC_ADD_TABLE(d, "received", element_columns);

    for (size_t i = 0; i < r->net->channel.n; i++) {
        const NetChannel *c = r->net->channel.at[i];
        for (size_t k = 0; k < c->field.n && !c->is_send; k++) {
            doc_add_code_cell(t, c->field.at[k].element->name->text);
            doc_add_plain_cell(t, c->name->text);
            doc_add_plain_cell(t, silent_text(r, c, &c->field.at[k]));
        }
    }
}

void report_add_messages(Report *r, Doc *d)
{
    bool receives = false;

    if (!r->net)
        return;
    for (size_t i = 0; i < r->net->channel.n; i++)
        receives = receives || !r->net->channel.at[i]->is_send;
    doc_add_section(d, "messages", "Messages");
    doc_add_paragraph(d, TEXT_MESSAGES);
    add_channels(r, d);
    if (receives)
        add_received_elements(r, d);
}

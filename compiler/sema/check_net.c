// SPDX-License-Identifier: Apache-2.0
// Checks a network configuration (config.md 11) and builds a Network: addresses are valid, elements exist, no element has two writers, no
// two channels can be confused, no message returns to its sender, and every message fits into a datagram.  Over TCP, a channel is a client
// or a server.
#include "compiler/sema/app_check.h"
#include "compiler/sema/network.h"
#include "compiler/syntax/ast_net.h"

#include <string.h>

#include "stdlib/convert.h"
#include "stdlib/crc32.h"

const char *const net_count_words[NET_COUNTS] = {
#define SM_NET_COUNT(name, word, text) word,
#include "stdlib/net_counts.def"
#undef SM_NET_COUNT
};

const char *const net_count_texts[NET_COUNTS] = {
#define SM_NET_COUNT(name, word, text) text,
#include "stdlib/net_counts.def"
#undef SM_NET_COUNT
};

typedef struct NetWriter { const char *what; Span span; } NetWriter;

typedef struct NetCheck {
    AppCheck a;                   // the context for app_find_element and app_check_amount, which use only c, sv and guesses
    const CheckContext *c;
    Diags *d;
    const AstNet *ast;
    Network *net;
    Map endpoint;                 // a name, to its AstNetEndpoint
    Map channel;                  // the name of a message, to the Span of its first use
    Map writer;                   // the name of an element that the network writes, to its NetWriter
} NetCheck;

const char *net_address_text(Arena *arena, const NetChannel *c)
{
    return format_in(arena, "%u.%u.%u.%u:%u", c->ip[0], c->ip[1], c->ip[2], c->ip[3], (unsigned)c->port);
}

// A UDP channel and a TCP client need one socket.  A server needs one that listens, one for each peer, and one for a peer that replaces another.
uint32_t net_sockets(const Network *net)
{
    uint32_t n = 0;

    for (size_t i = 0; i < net->channel.n; i++)
        n += net->channel.at[i]->transport == NET_TCP_SERVER ? net->channel.at[i]->peers + 2 : 1;
    return n;
}

static const char *source_text(const NetCheck *k, Span s)
{
    return format_in(k->c->arena, "%.*s", (int)(s.len < 40 ? s.len : 40), s.src->text + s.at);
}

// ---- addresses ----

// Reads a whole number of at most `most` at *s, and moves *s past it.  Returns false if *s is at no number, or if the number is too large.
static bool read_number(const char **s, uint32_t most, uint32_t *out)
{
    const char *from = *s;

    for (*out = 0; **s >= '0' && **s <= '9' && *out <= most; (*s)++)
        *out = *out * 10 + (uint32_t)(**s - '0');
    return *s > from && *out <= most;
}

static bool read_ip(const char **s, uint8_t *ip)
{
    uint32_t n;

    for (int i = 0; i < 4; i++) {
        if ((i && *(*s)++ != '.') || !read_number(s, 255, &n))
            return false;
        ip[i] = (uint8_t)n;
    }
    return true;
}

// Reads the text of an address or a port into ip and *port.  `port` is NULL if no port may follow.  Reports a text that is neither.
static bool check_address(NetCheck *k, const AstWord *word, uint8_t *ip, uint16_t *port)
{
    const char *s = word->text->text;
    uint32_t n = 0;
    bool good = strchr(s, '.') == NULL || read_ip(&s, ip);

    if (good && port && *s == ':')
        s++;
    else if (good && port && s != word->text->text)
        good = false;                         // an address must be followed by a port
    if (good && port) {
        good = read_number(&s, 65535, &n) && n >= 1;
        *port = (uint16_t)n;
    }
    if (good && *s == '\0')
        return true;
    diag_report(k->d, DIAG_net_address, word->span, word->text->text,
                diag_text(k->d, port ? DIAG_part_address_port : DIAG_part_address));
    return false;
}

// Checks the endpoints (named network addresses) that the network file declares.
static void check_endpoints(NetCheck *k)
{
    for (size_t i = 0; i < k->ast->endpoints.n; i++) {
        const AstNetEndpoint *e = &k->ast->endpoints.at[i], *first = map_find(&k->endpoint, e->name.text);
        uint8_t ip[4];
        uint16_t port;

        if (first)
            diag_note(k->d, diag_report(k->d, DIAG_app_name_twice, e->name.span, "endpoint", e->name.text->text), first->name.span,
                      DIAG_note_first_here);
        else
            map_put(&k->endpoint, e->name.text, (void *)(size_t)e);
        check_address(k, &e->address, ip, &port);
    }
}

static void report_unknown_endpoint(NetCheck *k, const AstWord *word)
{
    Diag *d = diag_report(k->d, DIAG_net_endpoint, word->span, word->text->text);
    const char **names = ARENA_ARRAY(k->c->arena, const char *, k->ast->endpoints.n + 1), *near;

    for (size_t i = 0; i < k->ast->endpoints.n; i++)
        names[i] = k->ast->endpoints.at[i].name.text->text;
    near = k->ast->endpoints.n ? str_nearest(word->text->text, names, k->ast->endpoints.n) : NULL;
    if (near)
        diag_label(k->d, d, DIAG_label_did_you_mean, near);
}

// Whether the word before the address (`to`, `on` or `from`) fits the channel.  Over TCP, `on` is allowed for both directions, because either
// computer can be the server (config.md 11.4, 11.21).
static bool check_side(NetCheck *k, const AstNetChannel *in)
{
    const AstNetSide other = in->is_send ? AST_NET_FROM : AST_NET_TO, of_udp = in->is_send ? AST_NET_TO : AST_NET_ON;

    if (in->is_tcp ? in->side != other : in->side == of_udp)
        return true;
    diag_report(k->d, DIAG_net_side, in->side_span, in->is_send ? "send" : "receive", source_text(k, in->side_span),
                diag_text(k->d, in->is_tcp ? in->is_send ? DIAG_part_send_tcp : DIAG_part_receive_tcp
                                           : in->is_send ? DIAG_part_send_udp : DIAG_part_receive_udp));
    return false;
}

// Sets the address of a channel (config.md 11.4, 11.21).
static void check_where(NetCheck *k, const AstNetChannel *in, NetChannel *out)
{
    const AstWord *word = &in->where;
    const AstNetEndpoint *e = in->where_kind == TOK_NAME ? map_find(&k->endpoint, word->text) : NULL;
    bool local = in->side == AST_NET_ON, good;

    out->transport = !in->is_tcp ? NET_UDP : local ? NET_TCP_SERVER : NET_TCP_CLIENT;
    out->peers = in->is_tcp;
    out->where = word->span;
    if (in->where_kind == TOK_NAME && !e) {
        report_unknown_endpoint(k, word);
        return;
    }
    if (!check_side(k, in))
        return;
    good = check_address(k, e ? &e->address : word, out->ip, &out->port);
    if (good && !local && (out->ip[0] | out->ip[1] | out->ip[2] | out->ip[3]) == 0)
        diag_report(k->d, DIAG_net_address, word->span, source_text(k, word->span), diag_text(k->d, DIAG_part_address_port));
    if (good && in->is_tcp && net_is_multicast(out->ip))
        diag_report(k->d, DIAG_net_tcp, word->span, in->name.text->text, "a multicast group");
}

// ---- writers ----

// Reports element e if the network writes it twice (config.md 11.11).
static void add_writer(NetCheck *k, const Element *e, Span span, const char *what)
{
    const NetWriter *first = map_find(&k->writer, e->name);
    NetWriter *w = ARENA_NEW(k->c->arena, NetWriter);

    w->what = what;
    w->span = span;
    if (!first)
        map_put(&k->writer, e->name, w);
    else
        diag_note(k->d, diag_report(k->d, DIAG_net_two_writers, span, e->name->text, first->what, what), first->span,
                  DIAG_note_first_here);
}

// ---- annotations of a channel ----

// Returns the named element; reports it if its type is not an integer.
static const Element *check_integer(NetCheck *k, const AstWord *word, const char *what)
{
    const Element *e = app_find_element(&k->a, word);

    if (!e || (e->type != SM_BOOL && e->type != SM_F32 && e->type != SM_F64))
        return e;
    diag_note(k->d, diag_report(k->d, DIAG_app_element_type, word->span, e->name->text, sm_type_info[e->type].spelling, what,
                                "of an integer type"), e->span, DIAG_note_declared_here, e->name->text);
    return NULL;
}

// Whether a channel can have the counter `count`, which depends on its direction and transport.
static bool can_count(const NetChannel *c, NetCount count)
{
    switch (count) {
    case NET_COUNT_sent: case NET_COUNT_lost:            return c->is_send;
    case NET_COUNT_full: case NET_COUNT_unconnected:     return c->is_send && net_is_tcp(c);
    case NET_COUNT_connected: case NET_COUNT_broken:     return net_is_tcp(c);
    case NET_COUNT_long_:                                return !c->is_send && !net_is_tcp(c);      // a stream has no datagrams
    default:                                             return !c->is_send;
    }
}

static void check_count(NetCheck *k, const AstNetAnnotation *a, NetChannel *out)
{
    const Element *e = check_integer(k, &a->element, "a count");
    NetStatistic s = {NET_COUNT_accepted, e};
    const char *words[NET_COUNTS], *list = "";
    size_t n = 0;
    bool found = false;

    for (int i = 0; i < NET_COUNTS; i++) {
        if (!can_count(out, (NetCount)i))
            continue;
        words[n++] = net_count_words[i];
        list = format_in(k->c->arena, "%s%s%s", list, *list ? ", " : "", net_count_words[i]);
        if (strcmp(a->word.text->text, net_count_words[i]) == 0) {
            s.count = (NetCount)i;
            found = true;
        }
    }
    if (!found) {
        const char *near = str_nearest(a->word.text->text, words, n);
        Diag *d = diag_report(k->d, DIAG_net_count, a->word.span, a->word.text->text, list);
        if (near)
            diag_label(k->d, d, DIAG_label_did_you_mean, near);
        return;
    }
    for (size_t i = 0; i < out->statistic.n; i++)
        if (out->statistic.at[i].count == s.count) {
            diag_report(k->d, DIAG_annotation_repeated, a->span, "count", out->name->text);
            return;
        }
    if (!e)
        return;
    add_writer(k, e, a->element.span, format_in(k->c->arena, "a count of '%s'", out->name->text));
    vec_push(k->c->arena, &out->statistic, s);
}

// Checks @run, which numbers the starts of the sender of sealed messages (config.md 11.18).
static void check_run(NetCheck *k, const AstNetAnnotation *a, NetChannel *out)
{
    const Element *e = app_find_element(&k->a, &a->word);

    if (e && e->type != SM_U32) {
        diag_note(k->d, diag_report(k->d, DIAG_app_element_type, a->word.span, e->name->text, sm_type_info[e->type].spelling, "'@run'",
                                    "a U32"), e->span, DIAG_note_declared_here, e->name->text);
        return;
    }
    out->run = e;
    if (e && !out->is_send)
        add_writer(k, e, a->word.span, format_in(k->c->arena, "'@run' of '%s'", out->name->text));
}

// Checks @peers, the number of connections of a server (config.md 11.21).
static void check_peers(NetCheck *k, const AstNetChannel *in, const AstNetAnnotation *a, NetChannel *out)
{
    uint64_t n = 1;

    app_check_amount(&k->a, &a->amount, APP_RANGE_peers, &n);
    if (!in->is_tcp || in->side != AST_NET_ON)
        diag_report(k->d, DIAG_net_peers, a->span, out->name->text);
    else
        out->peers = (uint32_t)n;
}

static void check_channel_annotations(NetCheck *k, const AstNetChannel *in, NetChannel *out)
{
    const AstNetAnnotation *key = ast_net_find(&in->annotations, AST_NET_key), *run = ast_net_find(&in->annotations, AST_NET_run);

    for (size_t i = 0; i < in->annotations.n; i++) {
        const AstNetAnnotation *a = &in->annotations.at[i];
        switch (a->kind) {
        case AST_NET_timeout:
            app_check_amount(&k->a, &a->amount, APP_RANGE_timeout, &out->timeout);
            break;
        case AST_NET_age:
            out->age = check_integer(k, &a->word, "an age");
            if (out->age)
                add_writer(k, out->age, a->word.span, format_in(k->c->arena, "the age of '%s'", out->name->text));
            break;
        case AST_NET_count:
            check_count(k, a, out);
            break;
        case AST_NET_interface:
            check_address(k, &a->word, out->interface, NULL);
            if (in->is_tcp)
                diag_report(k->d, DIAG_net_tcp, a->span, out->name->text, "'@interface', which is for multicast groups");
            break;
        case AST_NET_peers:
            check_peers(k, in, a, out);
            break;
        case AST_NET_key:
            out->key = a->word.text;
            break;
        case AST_NET_run:
            check_run(k, a, out);
            break;
        case AST_NET_default: case AST_NET_safe: case AST_NET_hold: case AST_NET_ANNOTATION_COUNT:
            break;
        }
    }
    if ((key == NULL) != (run == NULL))
        diag_report(k->d, DIAG_net_key_and_run, key ? key->span : run->span, key ? "@key" : "@run", key ? "@run" : "@key");
}

// ---- elements ----

// Reports a value that does not fit element e.  Proposes false for 0, and true for 1, if e is a bool.
static void report_wrong_value(NetCheck *k, const AstNetAnnotation *a, const Element *e)
{
    Diag *d = diag_report(k->d, DIAG_net_value, a->value.span, source_text(k, a->value.span), e->name->text,
                          sm_type_info[e->type].spelling);
    const char *edit = sm_eq(a->value.value, sm_from_i32(0)) ? "false" : sm_eq(a->value.value, sm_from_i32(1)) ? "true" : NULL;

    diag_note(k->d, d, e->span, DIAG_note_declared_here, e->name->text);
    if (!edit || e->type != SM_BOOL)
        return;
    diag_label(k->d, d, DIAG_label_write, edit);
    diag_edit(k->d, d, a->value.span, edit);
}

// Sets the value that an element has while no message arrives (config.md 11.9).
static void check_silence(NetCheck *k, const AstNetPart *part, const NetChannel *out, NetField *f)
{
    const AstNetAnnotation *a = NULL;
    SmF64 stored;

    f->silent = out->timeout ? NET_UNKNOWN : NET_HOLD;
    for (size_t i = 0; i < part->annotations.n; i++) {
        if (a)
            diag_note(k->d, diag_report(k->d, DIAG_net_silence_twice, part->annotations.at[i].span, part->name.text->text), a->span,
                      DIAG_note_first_here);
        a = &part->annotations.at[i];
    }
    if (!a || out->is_send)
        return;
    if (!out->timeout)
        diag_report(k->d, DIAG_net_no_timeout, a->span, ast_net_annotation_name(a->kind), out->name->text);
    f->silent = a->kind == AST_NET_hold ? NET_HOLD : a->kind == AST_NET_safe ? NET_SAFE : NET_DEFAULT;
    if (a->kind == AST_NET_hold)
        return;
    f->cell = sm_cell_from_f64(f->element->type, a->value.value);
    stored = sm_cell_to_f64(f->element->type, f->cell);
    if (a->is_truth != (f->element->type == SM_BOOL) ||
        (f->element->type != SM_F32 && f->element->type != SM_F64 && !sm_eq(stored, a->value.value)))
        report_wrong_value(k, a, f->element);
}

static void add_field(NetCheck *k, const AstNetPart *part, const Element *e, NetChannel *out)
{
    NetField f = {e, NET_HOLD, 0, part->name.span};

    for (size_t i = 0; i < out->field.n; i++)
        if (out->field.at[i].element == e) {
            diag_note(k->d, diag_report(k->d, DIAG_net_element_twice, part->name.span, e->name->text, out->name->text),
                      out->field.at[i].span, DIAG_note_first_here);
            return;
        }
    check_silence(k, part, out, &f);
    if (!out->is_send)
        add_writer(k, e, part->name.span, format_in(k->c->arena, "the message '%s'", out->name->text));
    vec_push(k->c->arena, &out->field, f);
}

static void add_region(NetCheck *k, const AstNetPart *part, NetChannel *out)
{
    const StateVec *sv = k->net->sv;
    const char **names, *near;
    Diag *d;

    for (size_t r = 0; r < sv->region.n; r++) {
        const Region *region = sv->region.at[r];
        if (region->name != part->name.text)
            continue;
        for (uint32_t i = 0; i < region->count; i++)
            add_field(k, part, sv->element.at[region->first + i], out);
        return;
    }
    names = ARENA_ARRAY(k->c->arena, const char *, sv->region.n + 1);
    for (size_t r = 0; r < sv->region.n; r++)
        names[r] = sv->region.at[r]->name->text;
    near = sv->region.n ? str_nearest(part->name.text->text, names, sv->region.n) : NULL;
    d = diag_report(k->d, DIAG_net_region, part->name.span, part->name.text->text);
    if (near)
        diag_label(k->d, d, DIAG_label_did_you_mean, format_in(k->c->arena, "[%s]", near));
}

// Continues a CRC-32 with the characters of a text.
static uint32_t crc_text(uint32_t crc, const char *s)
{
    for (; *s; s++)
        crc = sm_crc32_byte(crc, (uint8_t)*s);
    return crc;
}

// Sets the hash and the size of a message (config.md 11.14, 11.15).
static void finish_message(NetCheck *k, const AstNetChannel *in, NetChannel *out)
{
    uint32_t crc = crc_text(crc_text(SM_CRC32_START, out->name->text), "\n");

    out->size = NET_HEADER + NET_CRC + (out->key ? NET_CODE : 0);
    for (size_t i = 0; i < out->field.n; i++) {
        const Element *e = out->field.at[i].element;
        crc = crc_text(crc_text(crc, sm_type_info[e->type].spelling), " ");
        crc = crc_text(crc_text(crc, e->name->text), "\n");
        out->size += sm_type_info[e->type].bytes;
    }
    out->hash = sm_crc32_end(crc);
    if (in->parts.n == 0)
        diag_report(k->d, DIAG_net_empty, in->braces, out->name->text);
    if (out->size > NET_MOST)
        diag_report(k->d, DIAG_net_too_long, out->span, out->name->text, format_in(k->c->arena, "%lu", (unsigned long)out->size));
}

// ---- channels that cannot be distinguished, messages that return to their sender ----

static bool is_any(const uint8_t *ip) { return (ip[0] | ip[1] | ip[2] | ip[3]) == 0; }

// Whether both channels would receive the same messages, or both send to the same receiver (config.md 11.12).  Over TCP, whether both
// would serve the same peers, or both connect to the same server.  Ports of UDP and TCP are different ones.
static bool are_ambiguous(const NetChannel *a, const NetChannel *b)
{
    if (net_is_tcp(a) != net_is_tcp(b) || net_listens(a) != net_listens(b) || a->port != b->port)
        return false;
    return memcmp(a->ip, b->ip, 4) == 0 || (net_listens(a) && (is_any(a->ip) || is_any(b->ip)));
}

// Returns, for a message, what two ambiguous channels both do.
static const char *activity_of(const NetChannel *c)
{
    static const char *const words[2][2] = {{"send to", "receive on"}, {"connect to", "listen on"}};

    return words[net_is_tcp(c)][net_listens(c)];
}

// Whether a message that channel `s` sends reaches `r`, a receiving channel of the same computer (config.md 11.13).  Of the two channels, the one
// that does not listen has the address of the other; a multicast group has the same address in both.
static bool loops_back(const NetChannel *s, const NetChannel *r)
{
    const uint8_t *ip = net_listens(s) ? r->ip : s->ip;

    return s->is_send && !r->is_send && net_is_tcp(s) == net_is_tcp(r) && net_listens(s) != net_listens(r) && s->port == r->port &&
           (ip[0] == 127 || memcmp(s->ip, r->ip, 4) == 0);
}

static void report_conflicting_channels(NetCheck *k)
{
    const NetChannel *const *c = (const NetChannel *const *)k->net->channel.at;

    for (size_t i = 0; i < k->net->channel.n; i++)
        for (size_t j = 0; j < k->net->channel.n; j++) {
            if (c[i]->port == 0 || c[j]->port == 0)
                continue;
            if (j < i && are_ambiguous(c[i], c[j]))
                diag_note(k->d, diag_report(k->d, DIAG_net_ambiguous, c[i]->where, c[j]->name->text, c[i]->name->text,
                                            activity_of(c[i]), net_address_text(k->c->arena, c[i])),
                          c[j]->where, DIAG_note_first_here);
            if (loops_back(c[i], c[j]))
                diag_note(k->d, diag_report(k->d, DIAG_net_cycle, c[i]->where, c[i]->name->text, net_address_text(k->c->arena, c[i]),
                                            c[j]->name->text),
                          c[j]->where, DIAG_note_named_here);
        }
}

// ---- the file ----

static void check_channel(NetCheck *k, const AstNetChannel *in)
{
    NetChannel *out = ARENA_NEW(k->c->arena, NetChannel);

    out->is_send = in->is_send;
    out->name = in->name.text;
    out->span = in->name.span;
    app_check_unique(&k->a, &k->channel, &in->name, "message");
    if (in->is_send)
        app_check_amount(&k->a, &in->period, APP_RANGE_period, &out->period);
    check_where(k, in, out);
    check_channel_annotations(k, in, out);
    for (size_t i = 0; i < in->parts.n; i++) {
        const AstNetPart *part = &in->parts.at[i];
        const Element *e = part->is_region ? NULL : app_find_element(&k->a, &part->name);
        if (part->is_region)
            add_region(k, part, out);
        else if (e)
            add_field(k, part, e, out);
    }
    finish_message(k, in, out);
    vec_push(k->c->arena, &k->net->channel, out);
}

Network *check_net(CheckContext *c, const AstFile *f, const StateVec *sv)
{
    enum { GUESSES = 30, MOST = 250 };            // the most suggestions; the most sockets, whose handles are bytes
    size_t errors = c->diags->errors_seen;
    NetCheck k;

    memset(&k, 0, sizeof k);
    k.c = k.a.c = c;
    k.d = c->diags;
    k.a.sv = sv;
    k.a.guesses = GUESSES;
    k.ast = f->net;
    k.endpoint.arena = k.channel.arena = k.writer.arena = c->arena;
    k.net = ARENA_NEW(c->arena, Network);
    k.net->name = sema_file_stem(c->strings, f->src);
    k.net->src = f->src;
    k.net->sv = sv;
    check_endpoints(&k);
    for (size_t i = 0; i < f->net->channels.n; i++)
        check_channel(&k, &f->net->channels.at[i]);
    report_conflicting_channels(&k);
    if (f->net->channels.n == 0 && !f->net->lost)
        diag_report(c->diags, DIAG_net_no_channel, (Span){f->src, 0, 0});
    if (net_sockets(k.net) > MOST)
        diag_report(c->diags, DIAG_app_too_many, f->net->channels.at[f->net->channels.n - 1].name.span, "sockets", "250");
    return c->diags->errors_seen > errors ? NULL : k.net;
}

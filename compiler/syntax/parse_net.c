// SPDX-License-Identifier: Apache-2.0
// Parses a network configuration (docs/config.md 11): lines that begin with `endpoint`, `send` or `receive`, in any order.
#include "compiler/syntax/ast_net.h"
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser_app.h"

#define SEND_EXAMPLE "send telemetry every 100 ms to 239.1.2.3:5000 { tankPressure }"
#define RECEIVE_EXAMPLE "receive commands on 5001 @timeout 500 ms { valveOpen @safe false }"
#define ENDPOINT_EXAMPLE "endpoint ground 10.0.0.2:5000"

typedef enum NetArguments { TAKES_NOTHING, TAKES_ELEMENT, TAKES_TIME, TAKES_NUMBER, TAKES_ADDRESS, TAKES_KEY, TAKES_COUNT, TAKES_VALUE } NetArguments;
typedef enum NetTarget { NET_ON_SEND, NET_ON_RECEIVE, NET_ON_PART, NET_ON_SENT_PART, NET_TARGETS } NetTarget;

static const struct { const char *name; NetArguments takes; bool on[NET_TARGETS]; const char *example; } rows[] = {
#define NET_ANNOTATION(name, takes, send, receive, part, example) {#name, TAKES_##takes, {send, receive, part, false}, example},
#include "compiler/syntax/net.def"
};

const char *ast_net_annotation_name(AstNetAnnotationKind kind) { return rows[kind].name; }

const AstNetAnnotation *ast_net_find(const AstNetAnnotations *all, AstNetAnnotationKind kind)
{
    for (size_t i = 0; i < all->n; i++)
        if (all->at[i].kind == kind)
            return &all->at[i];
    return NULL;
}

static bool is_at_word(const Parser *p, const char *word) { return p->tok.kind == TOK_NAME && strcmp(p->tok.text->text, word) == 0; }

// Whether the current token, the first on its line, begins a line of the file.
static bool is_at_entry(const Parser *p)
{
    return p->tok.first && p->ahead.kind == TOK_NAME && !p->ahead.first &&
           (is_at_word(p, "endpoint") || is_at_word(p, "send") || is_at_word(p, "receive"));
}

static void take_word(Parser *p, AstWord *into)
{
    into->text = p->tok.text ? p->tok.text : str_intern(p->strings, p->lex.src->text + p->tok.at, p->tok.len);
    into->span = parser_token_span(p);
    parser_advance(p);
}

// Parses an address, such as 10.0.0.2:5000. Returns false after reporting that none follows.
static bool parse_address(Parser *p, AstWord *into, const char *expected, const char *example)
{
    if (p->tok.kind != TOK_ADDRESS) {
        app_report_expected(p, expected, example);
        return false;
    }
    take_word(p, into);
    return true;
}

// ---- annotations ----

// Parses the number, true or false after @default and @safe.
static bool parse_value(Parser *p, AstNetAnnotation *a)
{
    if (p->tok.kind == TOK_TRUE || p->tok.kind == TOK_FALSE) {
        a->is_truth = true;
        a->value.value = sm_from_i32(p->tok.kind == TOK_TRUE);
        a->value.span = parser_token_span(p);
        parser_advance(p);
        return true;
    }
    if (parse_signed_number(p, &a->value))
        return true;
    app_report_expected(p, "a number, true or false", rows[a->kind].example);
    return false;
}

static bool parse_arguments(Parser *p, AstNetAnnotation *a)
{
    const char *example = rows[a->kind].example;

    switch (rows[a->kind].takes) {
    case TAKES_NOTHING: return true;
    case TAKES_ELEMENT: return app_parse_name(p, &a->word, "the name of an element", example);
    case TAKES_KEY:     return app_parse_name(p, &a->word, "the name of a key", example);
    case TAKES_TIME:    return app_parse_amount(p, &a->amount, APP_TIME, example);
    case TAKES_NUMBER:  return app_parse_amount(p, &a->amount, APP_NUMBER, example);
    case TAKES_ADDRESS: return parse_address(p, &a->word, "an address without a port", example);
    case TAKES_VALUE:   return parse_value(p, a);
    case TAKES_COUNT:
        return app_parse_name(p, &a->word, "what is counted", example) && app_parse_name(p, &a->element, "the name of an element", example);
    }
    return true;
}

// Returns the earlier annotation of the line that `a` repeats; NULL: none. @count can be repeated with other counters, which the checker checks.
static const AstNetAnnotation *find_repeated(const AstNetAnnotations *all, const AstNetAnnotation *a)
{
    return a->kind == AST_NET_count ? NULL : ast_net_find(all, a->kind);
}

static void parse_annotation(Parser *p, NetTarget target, const char *owner, AstNetAnnotations *into)
{
    static const char *const places[] = {"a message that is sent", "a message that is received", "an element", "an element that is sent"};
    const AstNetAnnotation *first;
    AstNetAnnotation a = {0};
    const char *here[AST_NET_ANNOTATION_COUNT];
    size_t row = 0, n = 0;

    while (row < AST_NET_ANNOTATION_COUNT && strcmp(p->tok.text->text, rows[row].name) != 0)
        row++;
    if (row == AST_NET_ANNOTATION_COUNT) {
        Diag *d = parser_fail(p, DIAG_annotation_unknown, parser_token_span(p), p->tok.text->text);
        for (size_t i = 0; i < AST_NET_ANNOTATION_COUNT; i++)
            if (rows[i].on[target])
                here[n++] = rows[i].name;
        if (n)
            parser_label_annotations(p, d, here, n);
        return;
    }
    a.kind = (AstNetAnnotationKind)row;
    a.span = parser_token_span(p);
    if (!rows[row].on[target])
        parser_fail(p, DIAG_app_annotation_place, a.span, rows[row].name, places[target]);
    parser_advance(p);
    if (!parse_arguments(p, &a) || p->failed)
        return;
    a.span = parser_span_since(p, a.span.at);
    if ((first = find_repeated(into, &a)) != NULL)
        diag_note(p->diags, parser_report(p, DIAG_annotation_repeated, a.span, rows[row].name, owner), first->span, DIAG_note_first_here);
    else
        vec_push(p->arena, into, a);
}

static void parse_net_annotations(Parser *p, NetTarget target, const char *owner, AstNetAnnotations *into)
{
    while (!p->failed && p->tok.kind == TOK_ANNOTATION)
        parse_annotation(p, target, owner, into);
}

// ---- a channel ----

// Parses `to`, `on` or `from`, then `tcp` or `udp` if present, then a port, an address or the name of an endpoint.
static bool parse_where(Parser *p, AstNetChannel *c, const char *example)
{
    c->side = is_at_word(p, "to") ? AST_NET_TO : is_at_word(p, "from") ? AST_NET_FROM : AST_NET_ON;
    c->side_span = parser_token_span(p);
    if (c->side == AST_NET_ON && !is_at_word(p, "on")) {
        app_report_expected(p, c->is_send ? "'to' or 'on'" : "'on' or 'from'", example);
        return false;
    }
    parser_advance(p);
    c->is_tcp = is_at_word(p, "tcp");
    if (c->is_tcp || is_at_word(p, "udp"))
        parser_advance(p);
    if ((p->tok.kind != TOK_NUMBER && p->tok.kind != TOK_ADDRESS && p->tok.kind != TOK_NAME) || is_at_entry(p)) {
        app_report_expected(p, "a port, an address or the name of an endpoint", example);
        return false;
    }
    c->where_kind = p->tok.kind;
    take_word(p, &c->where);
    return true;
}

// Parses the elements and regions up to the closing brace.
static bool parse_parts(Parser *p, AstNetChannel *c, const char *example)
{
    if (p->tok.kind != TOK_LBRACE) {
        app_report_expected(p, "'{'", example);
        return false;
    }
    c->braces = parser_token_span(p);
    parser_advance(p);
    while (!p->failed && p->tok.kind != TOK_RBRACE) {
        AstNetPart part = {0};
        part.is_region = p->tok.kind == TOK_HEADER;
        if ((!part.is_region && p->tok.kind != TOK_NAME) || is_at_entry(p)) {
            app_report_expected(p, "an element, a region in brackets, or '}'", example);
            return false;
        }
        take_word(p, &part.name);
        parse_net_annotations(p, c->is_send ? NET_ON_SENT_PART : NET_ON_PART, part.name.text->text, &part.annotations);
        if (p->tok.kind == TOK_COMMA) {
            Diag *d = parser_report(p, DIAG_net_comma, parser_token_span(p));
            diag_edit(p->diags, d, parser_token_span(p), "");
            parser_advance(p);
        }
        vec_push(p->arena, &c->parts, part);
    }
    if (!p->failed)
        parser_advance(p);
    return !p->failed;
}

static void parse_channel(Parser *p, AstNet *net)
{
    AstNetChannel c = {0};
    const char *example;

    c.is_send = is_at_word(p, "send");
    example = c.is_send ? SEND_EXAMPLE : RECEIVE_EXAMPLE;
    parser_advance(p);
    if (!app_parse_name(p, &c.name, "the name of the message", example))
        return;
    if (c.is_send && !is_at_word(p, "every")) {
        app_report_expected(p, "'every'", example);
        return;
    }
    if (c.is_send)
        parser_advance(p);
    if (c.is_send && !app_parse_amount(p, &c.period, APP_TIME, example))
        return;
    if (!parse_where(p, &c, example))
        return;
    parse_net_annotations(p, c.is_send ? NET_ON_SEND : NET_ON_RECEIVE, c.name.text->text, &c.annotations);
    if (!p->failed && parse_parts(p, &c, example))
        vec_push(p->arena, &net->channels, c);
}

static void parse_endpoint(Parser *p, AstNet *net)
{
    AstNetEndpoint e = {0};

    parser_advance(p);
    if (app_parse_name(p, &e.name, "the name of the endpoint", ENDPOINT_EXAMPLE) &&
        parse_address(p, &e.address, "an address with its port", ENDPOINT_EXAMPLE))
        vec_push(p->arena, &net->endpoints, e);
}

// ---- the file ----

// Reports text that begins no line of the file, and suggests the most similar word that does.
static void report_unknown_line(Parser *p)
{
    static const char *const words[] = {"endpoint", "send", "receive"};
    const char *near = p->tok.kind == TOK_NAME ? str_nearest(p->tok.text->text, words, 3) : NULL;
    Diag *d;

    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    d = parser_fail(p, DIAG_net_line, parser_token_span(p), parser_describe(p, &p->tok));
    if (near)
        diag_label(p->diags, d, DIAG_label_did_you_mean, near);
}

// After an error: skips to the next line that begins an entry, so that the rest of a message is not reported line by line.
static void recover(Parser *p, AstNet *net)
{
    net->lost = true;
    p->failed = true;
    do
        parser_advance(p);
    while (p->tok.kind != TOK_END && !is_at_entry(p));
    p->failed = false;
}

void parse_net(Parser *p, AstNet *net)
{
    while (p->tok.kind != TOK_END) {
        p->failed = false;
        if (is_at_word(p, "endpoint"))
            parse_endpoint(p, net);
        else if (is_at_word(p, "send") || is_at_word(p, "receive"))
            parse_channel(p, net);
        else
            report_unknown_line(p);
        if (!p->failed && p->tok.kind != TOK_END && !is_at_entry(p) && !p->tok.first)
            hint_explain(p, HINT_AT_END, NULL);
        if (p->failed && !is_at_entry(p) && p->tok.kind != TOK_END)
            recover(p, net);
        net->lost = net->lost || p->failed;
    }
    p->failed = false;
}

// ---- --emit=ast ----

static void print_span(Buf *out, Span s)
{
    buf_char(out, ' ');
    buf_put(out, s.src->text + s.at, s.len);
}

static void print_annotations(const AstNetAnnotations *all, Buf *out)
{
    for (size_t i = 0; i < all->n; i++)
        print_span(out, all->at[i].span);
    buf_char(out, '\n');
}

void ast_print_net(const AstNet *net, Buf *out)
{
    static const char *const sides[] = {"on", "to", "from"};

    for (size_t i = 0; i < net->endpoints.n; i++)
        buf_printf(out, "endpoint %s %s\n", net->endpoints.at[i].name.text->text, net->endpoints.at[i].address.text->text);
    for (size_t i = 0; i < net->channels.n; i++) {
        const AstNetChannel *c = &net->channels.at[i];
        buf_printf(out, "%s %s", c->is_send ? "send" : "receive", c->name.text->text);
        if (c->is_send)
            buf_str(out, " every"), print_span(out, c->period.span);
        buf_printf(out, " %s %s", sides[c->side], c->is_tcp ? "tcp" : "udp");
        print_span(out, c->where.span);
        print_annotations(&c->annotations, out);
        for (size_t k = 0; k < c->parts.n; k++) {
            buf_printf(out, c->parts.at[k].is_region ? "  [%s]" : "  %s", c->parts.at[k].name.text->text);
            print_annotations(&c->parts.at[k].annotations, out);
        }
    }
}

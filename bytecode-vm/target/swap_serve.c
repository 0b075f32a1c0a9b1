// SPDX-License-Identifier: Apache-2.0
// The connections of swap_link.h.  Every call of the platform is without a wait, except that a host that has just been answered may send its
// next request within WAIT.  So a transfer is not limited by how often the thread that writes the log comes by.
#include <string.h>

#include "bytecode-vm/target/swap_link.h"
#include "bytecode-vm/target/swap_numbers.h"
#include "runtime-c/pal/clock.h"
#include "stdlib/flash.h"

#define WAIT  ((uint64_t)PAL_MILLISECOND)
#define RETRY ((uint64_t)PAL_SECOND)      // time until a line that has failed is opened again

enum { AT_ONCE = 64 };                    // the most bytes that one call of the platform receives

static SmSwapLink *link_of(SmSwapService *service) { return (SmSwapLink *)(void *)service; }
static uint64_t shorter_of(uint64_t a, uint64_t b) { return a < b ? a : b; }

// ---- one connection ----

static void begin_client(SmSwapClient *c)
{
    c->is_open = true;
    c->sent = c->length = 0;
    c->heard = pal_clock_now();
    sm_link_receiver_init(&c->in, c->received, sizeof c->received);
}

static void end_client(SmSwapLink *l, SmSwapClient *c)
{
    if (!c->is_open)
        return;
    if (l->place == SM_SWAP_AT_LINE) {
        (void)pal_serial_close(l->line);
        l->retry = pal_clock_now() + RETRY;
    } else {
        (void)pal_socket_close(c->stream);
    }
    c->is_open = false;
}

static SmResult receive_bytes(SmSwapLink *l, const SmSwapClient *c, uint8_t *bytes, size_t room, size_t *n, uint64_t timeout)
{
    return l->place == SM_SWAP_AT_LINE ? pal_serial_receive(l->line, bytes, room, n, timeout)
           : pal_socket_receive(c->stream, bytes, room, n, timeout);
}

// Sends the rest of the answer as far as the platform accepts it.  Returns whether all of it is sent.
static bool send_answer(SmSwapLink *l, SmSwapClient *c)
{
    const uint8_t *rest = c->answer + c->sent;
    const size_t n = (size_t)(c->length - c->sent);
    size_t sent = 0;
    SmResult r;

    if (n == 0)
        return true;
    r = l->place == SM_SWAP_AT_LINE ? pal_serial_send(l->line, rest, n, &sent, 0) : pal_socket_send(c->stream, rest, n, &sent, 0);
    c->sent = (uint16_t)(c->sent + sent);
    if (r != SM_OK && r != SM_E_TIMEOUT)
        end_client(l, c);
    return c->is_open && c->sent == c->length;
}

// Processes received bytes.  A host waits for its answer, so bytes after a request belong to a host that does not: they are dropped.
static bool process_bytes(SmSwapLink *l, SmSwapClient *c, const uint8_t *bytes, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (sm_link_receive(&c->in, bytes[i])) {
            c->heard = pal_clock_now();
            c->sent = 0;
            c->length = sm_swap_link_answer(l, c->in.buffer, c->in.n, c->answer);
            return c->length > 0;
        }
    return false;
}

// Sends and receives once.  Returns whether a request was answered.
static bool serve_client(SmSwapLink *l, SmSwapClient *c, uint64_t timeout)
{
    uint8_t bytes[AT_ONCE];
    size_t n = 0;
    SmResult r;

    if (!c->is_open || !send_answer(l, c))
        return false;
    r = receive_bytes(l, c, bytes, sizeof bytes, &n, timeout);
    if (r != SM_OK && r != SM_E_TIMEOUT) {
        end_client(l, c);
        return false;
    }
    if (!process_bytes(l, c, bytes, r == SM_OK ? n : 0))
        return r == SM_OK;
    (void)send_answer(l, c);
    return true;
}

// ---- all connections ----

static void open_line_again(SmSwapLink *l, uint64_t now)
{
    if (l->client[0].is_open || (int64_t)(now - l->retry) < 0)
        return;
    l->retry = now + RETRY;
    if (pal_serial_open(&l->line, l->name, l->speed) == SM_OK)
        begin_client(&l->client[0]);
}

// Closes connections that have been silent, and accepts new ones.
static void update_clients(SmSwapLink *l, uint64_t now)
{
    if (l->place == SM_SWAP_AT_LINE) {
        open_line_again(l, now);
        return;
    }
    for (uint8_t i = 0; i < SM_SWAP_CLIENTS; i++) {
        SmSwapClient *c = &l->client[i];
        if (c->is_open && now - c->heard >= SM_SWAP_SILENT)
            end_client(l, c);
        if (!c->is_open && pal_socket_accept(l->listening, &c->stream, NULL, 0) == SM_OK)
            begin_client(c);
    }
}

void sm_swap_link_serve(SmSwapService *service, uint64_t budget)
{
    SmSwapLink *l = link_of(service);
    const uint64_t start = pal_clock_now();
    uint64_t spent = 0;
    bool any = true;

    update_clients(l, start);
    for (bool first = true; any && (first || spent < budget); first = false) {
        any = false;
        for (uint8_t i = 0; i < SM_SWAP_CLIENTS; i++) {
            SmSwapClient *c = &l->client[(l->next + i) % SM_SWAP_CLIENTS];
            const bool waits = !first && c->is_open && c->heard >= start;
            any = serve_client(l, c, waits ? shorter_of(WAIT, budget - shorter_of(budget, pal_clock_now() - start)) : 0) || any;
        }
        l->next = (uint8_t)((l->next + 1) % SM_SWAP_CLIENTS);
        spent = pal_clock_now() - start;
    }
}

// ---- start and end ----

static SmResult open_place(SmSwapLink *l)
{
    switch (l->place) {
    case SM_SWAP_AT_PATH: return pal_socket_listen_local(&l->listening, l->name);
    case SM_SWAP_AT_ADDRESS: return pal_socket_listen(&l->listening, &l->address);
    case SM_SWAP_AT_LINE: return pal_serial_open(&l->line, l->name, l->speed);
    default: return SM_E_ARGUMENT;
    }
}

// Returns why the file of a key cannot be used; NULL: the text of r says it.
static const char *key_problem(SmResult r)
{
    return r == SM_E_ARGUMENT ? SM_TEXT("it has no key; 'smc key' makes one") : r == SM_E_MISSING
           ? SM_TEXT("there is no such file; 'smc key' makes one") : NULL;
}

SmResult sm_swap_link_open(SmSwapService *service, SmApp *app)
{
    SmSwapLink *l = link_of(service);
    const char *failed = l->name;
    SmResult r = l->key_file ? sm_swap_open_numbers(l, &failed) : SM_OK;

    if (r == SM_OK) {
        failed = l->name;
        r = open_place(l);
    }
    if (r == SM_OK && l->place == SM_SWAP_AT_LINE)
        begin_client(&l->client[0]);
    if (r != SM_OK) {
        app->failed_part = SM_TEXT("the link for swaps");
        app->failed_file = failed;
        app->reason = failed == l->key_file ? key_problem(r) : NULL;
    }
    l->app_name = app->name;
    l->app = app;
    l->events = app->events;
    return r;
}

void sm_swap_link_close(SmSwapService *service)
{
    SmSwapLink *l = link_of(service);

    for (uint8_t i = 0; i < SM_SWAP_CLIENTS; i++)
        end_client(l, &l->client[i]);
    if (l->place != SM_SWAP_AT_LINE)
        (void)pal_socket_close(l->listening);
    if (l->key_file)
        (void)pal_nvm_close(l->memory);
}

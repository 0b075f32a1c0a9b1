// SPDX-License-Identifier: Apache-2.0
// The tasks that receive and send messages (config.md 11).  Values wait in SmNetChannel.value, so that sockets and checks stay outside the
// single critical section.
#include "runtime-c/net.h"

#include <string.h>

#include "runtime-c/net_stream.h"
#include "runtime-c/pal/clock.h"
#include "stdlib/convert.h"

static bool is_group(const uint8_t *ip) { return ip[0] >= 224 && ip[0] <= 239; }
static SmResult first_error(SmResult before, SmResult now) { return before == SM_OK ? now : before; }
static void add(uint32_t *count) { (*count)++; }

// ---- the state vector ----

static uint8_t *address_of(const SmNet *net, uint32_t offset) { return (uint8_t *)net->sv->at + offset; }

static void store_count(const SmNet *net, const SmNetPlace *p, uint32_t count)
{
    sm_cell_store((SmType)p->type, address_of(net, p->offset), sm_cell_from_f64((SmType)p->type, sm_from_u32(count)));
}

// Returns the bits of an element without a valid value: NaN if the type has one, else 0.
static uint64_t unknown_cell(SmType type)
{
    return type == SM_F64 ? 0x7FF8000000000000u : type == SM_F32 ? 0x7FC00000u : 0;
}

// ---- opening ----

static bool is_inside(const SmNet *net, uint32_t offset, uint8_t type)
{
    const uint32_t size = net->sv->layout->whole.size;

    return type < SM_TYPE_COUNT && offset <= size && size - offset >= sm_type_bytes[type];
}

// Whether the row of the table is consistent: its elements are in the vector, and its size is that of its fields.
static bool is_row_valid(const SmNet *net, const SmNetChannel *c)
{
    const SmNetMessage *m = &c->message;
    size_t size = SM_NET_HEADER + SM_NET_CRC + (m->key ? SM_NET_CODE : 0);

    if (!m->field || !c->value || !c->bytes || (m->key && (!m->seal || !c->run)))
        return false;
    for (uint16_t i = 0; i < m->fields; i++) {
        if (!is_inside(net, m->field[i].offset, m->field[i].type))
            return false;
        size += sm_type_bytes[m->field[i].type];
    }
    for (uint8_t i = 0; i < c->statistics; i++)
        if (!is_inside(net, c->statistic[i].offset, c->statistic[i].type) || c->statistic[i].count >= SM_NET_COUNTS)
            return false;
    return size == m->size && (!c->age || is_inside(net, c->age->offset, c->age->type)) &&
           (!c->run || (c->run->type == SM_U32 && is_inside(net, c->run->offset, SM_U32)));
}

// Opens the UDP socket of a channel, and joins or selects the interface of its multicast group.
static SmResult open_udp(SmNetChannel *c, bool sends)
{
    const PalAddress any = {{0, 0, 0, 0}, 0};
    SmResult r = pal_socket_udp(&c->socket, sends ? &any : &c->address);

    if (r != SM_OK)
        return r;
    if (is_group(c->address.ip))
        r = pal_socket_multicast(c->socket, sends ? NULL : c->address.ip, c->interface);
    if (r != SM_OK)
        pal_socket_close(c->socket);
    return r;
}

static SmResult open_channel(SmNet *net, SmNetChannel *c, bool sends)
{
    if (!is_row_valid(net, c) || sends != (c->period != 0))
        return SM_E_ARGUMENT;
    return c->transport == SM_NET_UDP ? open_udp(c, sends) : sm_stream_open(c);
}

static void close_channel(SmNetChannel *c)
{
    if (c->transport == SM_NET_UDP)
        pal_socket_close(c->socket);
    else
        sm_stream_close(c);
}

void sm_net_close(SmNet *net)
{
    for (uint8_t i = 0; i < net->channels; i++) {
        if (net->channel[i].open)
            close_channel(&net->channel[i]);
        net->channel[i].open = false;
    }
}

static SmResult open_channels(SmNet *net, bool sends)
{
    if (!net || !net->sv || !net->sv->layout || (net->channels && !net->channel))
        return SM_E_ARGUMENT;
    for (uint8_t i = 0; i < net->channels; i++) {
        const SmResult r = open_channel(net, &net->channel[i], sends);
        if (r != SM_OK) {
            net->failed = i;
            sm_net_close(net);
            return r;
        }
        net->channel[i].open = true;
    }
    return SM_OK;
}

// Reads the run of each channel: from its element, or from the clock, which differs in each run of the program.
static SmResult read_runs(SmNet *net)
{
    const uint32_t clock = (uint32_t)(pal_clock_now() / 1000);
    const SmResult r = sm_enter(net->sv);

    if (r != SM_OK)
        return r;
    for (uint8_t i = 0; i < net->channels; i++) {
        SmNetChannel *c = &net->channel[i];
        c->next.run = c->run ? (uint32_t)sm_cell_load(SM_U32, address_of(net, c->run->offset)) : clock;
        c->order.last.run = c->run ? c->next.run : 0;
    }
    sm_leave(net->sv);
    return SM_OK;
}

// ---- receiving ----

static bool is_silent(const SmNetChannel *c, uint64_t now)
{
    const uint64_t restart = 1000000000u;         // without a timeout, a sender that was restarted is accepted after a second

    return now - c->accepted_at > (c->timeout ? c->timeout : restart);
}

static void count_received(SmNetChannel *c, SmNetCount cause)
{
    add(&c->count[cause]);
    if (cause != SM_NET_accepted)
        add(&c->count[SM_NET_refused]);
}

// Checks the n bytes of one message, and counts it.
static SmNetCount accept_message(SmNetChannel *c, const uint8_t *bytes, size_t n, uint64_t now)
{
    SmNetStamp stamp;
    SmNetCount cause = sm_net_check(&c->message, bytes, n, &stamp);

    if (cause == SM_NET_accepted)
        cause = sm_net_order(&c->order, stamp, c->message.key != NULL, is_silent(c, now));
    count_received(c, cause);
    if (cause == SM_NET_accepted) {
        sm_net_values(&c->message, bytes, c->value);
        c->accepted_at = now;
        c->fresh = true;
    }
    return cause;
}

// Reads the packets that have arrived, at most SM_NET_BURST.
static SmResult receive_packets(SmNetChannel *c, uint64_t now)
{
    for (int i = 0; i < SM_NET_BURST; i++) {
        size_t n = 0;
        const SmResult r = pal_socket_receive_from(c->socket, NULL, c->bytes, c->message.size, &n, 0);
        if (r == SM_E_TIMEOUT)
            return SM_OK;
        if (r != SM_OK && r != SM_E_SIZE)
            return r;
        accept_message(c, c->bytes, r == SM_E_SIZE ? (size_t)c->message.size + 1 : n, now);
    }
    return SM_OK;
}

// Reads the messages that have arrived on one connection, at most SM_NET_BURST.
static void receive_messages(SmNetChannel *c, SmNetPeer *p, uint64_t now)
{
    SmNetCount cause;

    for (int i = 0; i < SM_NET_BURST && sm_stream_receive(c, p, &cause, now); i++)
        if (cause == SM_NET_accepted)
            sm_stream_judged(c, p, accept_message(c, p->bytes, c->message.size, now), now);
        else
            count_received(c, cause);
}

static SmResult receive_channel(SmNetChannel *c, uint64_t now)
{
    SmResult r;

    if (c->transport == SM_NET_UDP)
        return receive_packets(c, now);
    r = sm_stream_update(c, now);
    for (uint8_t i = 0; i < c->peers; i++)
        receive_messages(c, &c->peer[i], now);
    return r;
}

// Stores the values that have arrived, or those for a channel that is silent (config.md 11.9).
static void store_fields(const SmNet *net, SmNetChannel *c, uint64_t now)
{
    const bool timed_out = c->timeout && is_silent(c, now);

    for (uint16_t i = 0; i < c->message.fields; i++) {
        const SmNetField *f = &c->message.field[i];
        const SmType type = (SmType)f->type;
        if (c->fresh)
            sm_cell_store(type, address_of(net, f->offset), c->value[i]);
        else if ((f->silent == SM_NET_SAFE && (timed_out || !c->order.any)) || (f->silent == SM_NET_DEFAULT && timed_out))
            sm_cell_store(type, address_of(net, f->offset), f->value);
        else if (f->silent == SM_NET_UNKNOWN && timed_out)
            sm_cell_store(type, address_of(net, f->offset), unknown_cell(type));
    }
    c->fresh = false;
}

// Stores the counts, the age in milliseconds, and the run of a sealed channel.
static void store_statistics(const SmNet *net, const SmNetChannel *c, uint64_t now)
{
    const uint64_t age = (now - c->accepted_at) / 1000000;

    for (uint8_t i = 0; i < c->statistics; i++)
        store_count(net, &c->statistic[i], c->count[c->statistic[i].count]);
    if (c->age)
        store_count(net, c->age, !c->order.any || age > UINT32_MAX ? UINT32_MAX : (uint32_t)age);
    if (c->run && c->order.any)
        sm_cell_store(SM_U32, address_of(net, c->run->offset), c->order.last.run);
}

static SmResult store_received(SmNet *net, uint64_t now)
{
    const SmResult r = sm_enter(net->sv);

    if (r != SM_OK)
        return r;
    for (uint8_t i = 0; i < net->channels; i++) {
        store_fields(net, &net->channel[i], now);
        store_statistics(net, &net->channel[i], now);
    }
    sm_leave(net->sv);
    return SM_OK;
}

SmResult sm_receive_init(void *context)
{
    SmNet *net = (SmNet *)context;
    SmResult r = open_channels(net, false);

    if (r == SM_OK)
        r = read_runs(net);
    return r == SM_OK ? store_received(net, 0) : r;
}

SmResult sm_receive_step(void *context, const SmTick *tick)
{
    SmNet *net = (SmNet *)context;
    SmResult result = SM_OK, r;

    for (uint8_t i = 0; i < net->channels; i++) {
        r = receive_channel(&net->channel[i], tick->time);
        if (r != SM_OK)
            net->failed = i;
        result = first_error(result, r);
    }
    r = store_received(net, tick->time);
    return r != SM_OK ? r : result;
}

// ---- sending ----

// Whether a message of this channel is due: the first in each of its periods.
static bool is_due(const SmNetChannel *c, uint64_t now) { return !c->sent_any || now / c->period != c->slot; }

// Loads the values of all messages that are due, and stores the counts.
static SmResult load_due(SmNet *net, uint64_t now)
{
    const SmResult r = sm_enter(net->sv);

    if (r != SM_OK)
        return r;
    for (uint8_t i = 0; i < net->channels; i++) {
        SmNetChannel *c = &net->channel[i];
        for (uint16_t k = 0; k < c->message.fields && is_due(c, now); k++)
            c->value[k] = sm_cell_load((SmType)c->message.field[k].type, address_of(net, c->message.field[k].offset));
        store_statistics(net, c, now);
    }
    sm_leave(net->sv);
    return SM_OK;
}

static SmResult send_message(SmNetChannel *c, uint64_t now)
{
    SmResult r;

    sm_net_encode(&c->message, c->value, c->next, c->bytes);
    c->next.number++;
    c->slot = now / c->period;
    c->sent_any = true;
    if (c->transport != SM_NET_UDP) {
        sm_stream_send(c, now);
        return SM_OK;
    }
    r = pal_socket_send_to(c->socket, &c->address, c->bytes, c->message.size);
    add(&c->count[r == SM_OK ? SM_NET_sent : SM_NET_lost]);
    return r;
}

SmResult sm_send_init(void *context)
{
    SmNet *net = (SmNet *)context;
    const SmResult r = open_channels(net, true);

    return r == SM_OK ? read_runs(net) : r;
}

SmResult sm_send_step(void *context, const SmTick *tick)
{
    SmNet *net = (SmNet *)context;
    SmResult result = load_due(net, tick->time), r;

    if (result != SM_OK)
        return result;
    for (uint8_t i = 0; i < net->channels; i++) {
        SmNetChannel *c = &net->channel[i];
        r = c->transport == SM_NET_UDP ? SM_OK : sm_stream_update(c, tick->time);
        if (is_due(c, tick->time))
            r = first_error(r, send_message(c, tick->time));
        if (r != SM_OK)
            net->failed = i;
        result = first_error(result, r);
    }
    return result;
}

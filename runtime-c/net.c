// SPDX-License-Identifier: Apache-2.0
// The tasks that receive and send messages (config.md 11).  Values wait in SmNetChannel.value, so that sockets and checks stay outside the
// single critical section.
#include "runtime-c/net.h"

#include <string.h>

#include "runtime-c/net_stream.h"
#include "runtime-c/pal/clock.h"
#include "stdlib/convert.h"

static bool is_group(const uint8_t *ip) { return ip[0] >= 224 && ip[0] <= 239; }
static void increment(uint32_t *count) { (*count)++; }

// ---- the state vector ----

static bool is_signed(uint8_t type) { return type <= SM_I64; }

static uint8_t *address_of(const SmNet *net, uint32_t offset) { return (uint8_t *)net->sv->at + offset; }

// Stores a count in an element of an integer type, up to the largest value of the type.
static void store_count(const SmNet *net, const SmNetPlace *p, uint32_t count)
{
    const unsigned bits = 8u * sm_type_bytes[p->type] - is_signed(p->type);
    const uint32_t most = bits < 32 ? (1u << bits) - 1 : UINT32_MAX;

    sm_cell_store((SmType)p->type, address_of(net, p->offset), count < most ? count : most);
}

// Returns the bits of an element without a valid value: NaN if the type has one, else 0.
static uint64_t unknown_cell(SmType type)
{
    return type == SM_F64 ? 0x7FF8000000000000u : type == SM_F32 ? 0x7FC00000u : 0;
}

// ---- opening ----

static bool is_inside_vector(const SmNet *net, uint32_t offset, uint8_t type)
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
        if (!is_inside_vector(net, m->field[i].offset, m->field[i].type))
            return false;
        size += sm_type_bytes[m->field[i].type];
    }
    for (uint8_t i = 0; i < c->statistics; i++)
        if (!is_inside_vector(net, c->statistic[i].offset, c->statistic[i].type) || c->statistic[i].count >= SM_NET_COUNTS)
            return false;
    return size == m->size && (!c->age || is_inside_vector(net, c->age->offset, c->age->type)) &&
           (!c->run || (c->run->type == SM_U32 && is_inside_vector(net, c->run->offset, SM_U32)));
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

// Checks the row of a channel and opens its socket. `sends`: the task of the channel sends messages.
static SmResult open_channel(SmNet *net, SmNetChannel *c, bool sends)
{
    if (!is_row_valid(net, c) || sends != (c->period != 0))
        return SM_E_ARGUMENT;
    return c->stream ? c->stream->open(c) : open_udp(c, sends);
}

static void close_channel(SmNetChannel *c)
{
    if (c->stream)
        c->stream->close(c);
    else
        pal_socket_close(c->socket);
}

void sm_net_close(SmNet *net)
{
    for (uint8_t i = 0; i < net->channels; i++) {
        if (net->channel[i].open)
            close_channel(&net->channel[i]);
        net->channel[i].open = false;
    }
}

// Opens all channels. After a failure, none is open, and net->failed is the index of the one that failed.
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

// Sets the run number of each channel, which tells receivers that the sender was restarted: the value of its element, or the clock at the start.
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

// ---- every step ----

// Calls `serve` for all channels, even if one fails.  Returns the error of the first one that failed.
static SmResult serve_channels(SmNet *net, uint64_t now, SmResult (*serve)(SmNetChannel *c, uint64_t now))
{
    SmResult result = SM_OK;

    for (uint8_t i = 0; i < net->channels; i++) {
        const SmResult r = serve(&net->channel[i], now);
        if (r != SM_OK)
            net->failed = i;
        if (result == SM_OK)
            result = r;
    }
    return result;
}

// ---- receiving ----

// Whether the last message was accepted longer ago than the timeout of the channel.
static bool is_silent(const SmNetChannel *c, uint64_t now)
{
    const uint64_t restart = 1000000000u;         // without a timeout, a sender that was restarted is accepted after a second

    return now - c->accepted_at > (c->timeout ? c->timeout : restart);
}

// Checks and counts a received message. If it is accepted, c->value has its values.
SmNetCount sm_net_accept(SmNetChannel *c, const uint8_t *bytes, size_t n, uint64_t now)
{
    SmNetStamp stamp;
    SmNetCount cause = sm_net_check(&c->message, bytes, n, &stamp);

    if (cause == SM_NET_accepted)
        cause = sm_net_order(&c->order, stamp, c->message.key != NULL, is_silent(c, now));
    increment(&c->count[cause]);
    if (cause != SM_NET_accepted) {
        increment(&c->count[SM_NET_refused]);
        return cause;
    }
    sm_net_values(&c->message, bytes, c->value);
    c->accepted_at = now;
    c->fresh = true;
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
        sm_net_accept(c, c->bytes, r == SM_E_SIZE ? (size_t)c->message.size + 1 : n, now);
    }
    return SM_OK;
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

// Stores the counters of a channel, the age of its last message in milliseconds, and the run number of the sender if messages are authenticated.
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

// Stores the values and the counters of all channels in the state vector, in one critical section.
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

static SmResult receive_channel(SmNetChannel *c, uint64_t now) { return c->stream ? c->stream->receive(c, now) : receive_packets(c, now); }

SmResult sm_receive_step(void *context, const SmTick *tick)
{
    SmNet *net = (SmNet *)context;
    const SmResult result = serve_channels(net, tick->time, receive_channel), stored = store_received(net, tick->time);

    return stored != SM_OK ? stored : result;
}

// ---- sending ----

// Sets c->due if a message of this channel is to be sent: in the first step of each of its periods.
static void update_channel_due(SmNetChannel *c, uint64_t now)
{
    const uint64_t slot = now / c->period;

    c->due = !c->sent_any || slot != c->slot;
    c->slot = slot;
    c->sent_any = true;
}

// Loads the values of all messages that are due from the state vector, and stores the counts of errors in it.
static SmResult load_due(SmNet *net, uint64_t now)
{
    const SmResult r = sm_enter(net->sv);

    if (r != SM_OK)
        return r;
    for (uint8_t i = 0; i < net->channels; i++) {
        SmNetChannel *c = &net->channel[i];
        update_channel_due(c, now);
        for (uint16_t k = 0; k < c->message.fields && c->due; k++)
            c->value[k] = sm_cell_load((SmType)c->message.field[k].type, address_of(net, c->message.field[k].offset));
        store_statistics(net, c, now);
    }
    sm_leave(net->sv);
    return SM_OK;
}

// Sends the encoded message as a datagram, and counts it as sent or lost.
static SmResult send_message(SmNetChannel *c)
{
    const SmResult r = pal_socket_send_to(c->socket, &c->address, c->bytes, c->message.size);

    increment(&c->count[r == SM_OK ? SM_NET_sent : SM_NET_lost]);
    return r;
}

// Encodes and sends the message of a channel, if it is due. A TCP channel also serves its connections.
static SmResult send_channel(SmNetChannel *c, uint64_t now)
{
    if (c->due) {
        sm_net_encode(&c->message, c->value, c->next, c->bytes);
        c->next.number++;
    }
    if (c->stream)
        return c->stream->send(c, now);
    return c->due ? send_message(c) : SM_OK;
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
    const SmResult r = load_due(net, tick->time);

    return r == SM_OK ? serve_channels(net, tick->time, send_channel) : r;
}

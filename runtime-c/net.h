// SPDX-License-Identifier: Apache-2.0
// Messages between computers: their wire form, and the two tasks that receive and send them.  The tables come from a .net file
// (docs/config.md 11).
//
//     SmResult r = sm_receive_init(&rocket_receive);                // once; likewise for rocket_send
//     r = sm_receive_step(&rocket_receive, &tick);                  // then in every tick: receive, tasks, send
//
// Wire form, all numbers little-endian and without gaps.  A message has a fixed size, which no byte of it can change:
//
//     offset  bytes  content
//     0       2      0x4D53, "SM"
//     2       1      1, the version of this form
//     3       1      1 if the message is sealed with a key, else 0
//     4       4      layout hash: of the message's name and of its elements' names, types and order
//     8       4      run: the same in all messages of one run of the sender, different in the next
//     12      4      number: by 1 larger in each message of a run, modulo 2^32
//     16      …      the elements, in the order of the .net
//     …       16     only if sealed: Chaskey-12 over all bytes before, with the key (bytecode-vm/auth.h)
//     …       4      CRC-32 over all bytes before (stdlib/crc32.h)
//
// A message that is refused changes no element, is counted under its cause, and does not refresh the age.  All elements that a step
// receives are stored in one critical section; no socket is accessed while the lock is held.  A step accepts or refuses at most
// SM_NET_BURST packets for each channel, so a flood delays no step; what is left waits in the platform's buffer or is lost there.
//
// Over TCP, a connection carries messages of one channel in one direction, one after the other without gaps.  A receiver closes a connection
// whose bytes are not messages of its channel, and counts why.  A client connects again after a pause that doubles from SM_NET_RETRY_LEAST
// to SM_NET_RETRY_MOST.  Connecting, accepting, sending and receiving never wait: a message that a peer does not receive in time is dropped
// and counted.  A message that has arrived in part changes nothing; only a whole one is checked and stored.
#ifndef SM_NET_H
#define SM_NET_H

#include "runtime-c/pal/socket.h"
#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    SM_NET_HEADER = 16, SM_NET_CODE = 16, SM_NET_CRC = 4,     // bytes of the parts of a message
    SM_NET_KEY = 16,                                          // bytes of a key
    SM_NET_BURST = 8                                          // the most packets that one step reads from a channel or connection
};

#define SM_NET_RETRY_LEAST ((uint64_t)100 * PAL_MILLISECOND)  // pauses before a client connects again
#define SM_NET_RETRY_MOST  ((uint64_t)2 * PAL_SECOND)         // also how long it waits for the answer

typedef enum SmNetCount {
#define SM_NET_COUNT(name, word, text) SM_NET_##name,
#include "stdlib/net_counts.def"
#undef SM_NET_COUNT
    SM_NET_COUNTS
} SmNetCount;

// ---- the wire form: no socket, no clock, no state ----

// What becomes of an element while no message comes (docs/config.md 11.9).
typedef enum SmNetSilent { SM_NET_HOLD, SM_NET_UNKNOWN, SM_NET_DEFAULT, SM_NET_SAFE } SmNetSilent;

typedef struct SmNetField {
    uint32_t offset;          // in the state vector, in bytes
    uint8_t type;             // SmType
    uint8_t silent;           // SmNetSilent
    uint64_t value;           // DEFAULT, SAFE: the bits of the value, in the element's type
    uint64_t least, most;     // values outside are refused: bits of two binary64
} SmNetField;

// Computes the code of n bytes: smvm_seal of bytecode-vm/target/seal.h.
typedef void SmNetSeal(const uint8_t *bytes, size_t n, const uint8_t *key, uint8_t *code);

typedef struct SmNetMessage {
    uint32_t hash;
    uint16_t size, fields;    // size: bytes of the whole message
    const SmNetField *field;
    const uint8_t *key;       // SM_NET_KEY bytes, or NULL
    SmNetSeal *seal;          // NULL without a key, so that a program without keys does not link it
} SmNetMessage;

typedef struct SmNetStamp { uint32_t run, number; } SmNetStamp;       // the fields `run` and `number` of the wire form

// Writes m->size bytes.  `value` has the bits of each element.  A NaN is sent as 0, an infinity as the largest finite number.
void sm_net_encode(const SmNetMessage *m, const uint64_t *value, SmNetStamp stamp, uint8_t *bytes);

// Checks n bytes, which may be any.  SM_NET_accepted: *stamp is filled in.  Any other result is the cause for which the message is refused.
// Takes time in proportion to m->size, and reads no byte if n differs from it.
SmNetCount sm_net_check(const SmNetMessage *m, const uint8_t *bytes, size_t n, SmNetStamp *stamp);

// Checks the first SM_NET_HEADER bytes of a message: SM_NET_accepted, SM_NET_damaged or SM_NET_hash.
SmNetCount sm_net_check_header(const SmNetMessage *m, const uint8_t *bytes);

// Reads the bits of each element from bytes that sm_net_check has accepted.
void sm_net_values(const SmNetMessage *m, const uint8_t *bytes, uint64_t *value);

// What has been accepted from a sender.  Initially all zero; for sealed messages `last.run` is the run that was accepted last.
typedef struct SmNetOrder {
    bool any;
    SmNetStamp last;          // run and number of the newest message that was accepted
    uint64_t seen;            // bit i: last.number - i was accepted
} SmNetOrder;

// Decides whether a message with this stamp is new, and records it if it is.  Results: SM_NET_accepted, SM_NET_repeated, SM_NET_late.
// Another run of the sender is accepted if the message is sealed and the run is larger, or if it is not sealed and the channel is silent:
// the sender was restarted.
SmNetCount sm_net_order(SmNetOrder *o, SmNetStamp stamp, bool sealed, bool silent);

// ---- the tasks ----

typedef struct SmNetPlace {       // an element of an integer type that the runtime writes or reads
    uint32_t offset;
    uint8_t type;             // SmType
    uint8_t count;            // SmNetCount; only in SmNetChannel.statistic
} SmNetPlace;

// The functions of messages over TCP (net_stream.c).  Channels name them, so that a program without TCP does not link them.
typedef struct SmNetStream SmNetStream;
extern const SmNetStream sm_net_tcp;

// A connection over TCP.
typedef struct SmNetPeer {
    uint8_t *bytes;           // message.size bytes: the message that is being received or sent
    // The fields below belong to the runtime; initially all zero.
    PalSocket socket;
    uint8_t state;            // FREE, CONNECTING or OPEN (net_stream.c)
    uint16_t n, sent;         // bytes that `bytes` contains; how many of them have been sent
    uint64_t since;           // tick time at which the connection, or the attempt to connect, began
    uint64_t used;            // tick time of the last message; before the first one, the same as `since`
} SmNetPeer;

typedef struct SmNetChannel {
    const char *name;
    SmNetMessage message;
    const SmNetStream *stream;        // &sm_net_tcp; NULL for UDP, and then the next three are zero, too
    bool is_server;           // waits for connections, instead of making one
    uint8_t peers;            // rows of `peer`: 1 for a client, 1 or more for a server
    SmNetPeer *peer;
    PalAddress address;       // UDP: where to send, or the local address or group that receives; client: the server's; server: its local address
    uint8_t interface[4];     // address of the network interface for multicast; 0.0.0.0: the platform chooses
    uint64_t period, timeout; // nanoseconds; period: only of messages that are sent; timeout 0: none
    const SmNetPlace *statistic, *age, *run;      // elements for counts, age of the last message, sender's run (U32); or NULL
    uint8_t statistics;
    uint64_t *value;          // by field: the value in the message
    uint8_t *bytes;           // message.size bytes
    // The fields below belong to the runtime; initially all zero.
    uint32_t count[SM_NET_COUNTS];    // by SmNetCount, modulo 2^32; other threads read them with sm_shared_read (shared.h)
    PalSocket socket;
    SmNetOrder order;
    SmNetStamp next;          // run and number of the next message that is sent
    uint64_t accepted_at, slot;       // tick time of the last accepted message; number of the last period in which a message was due
    bool fresh;               // `value` has a message that is not stored yet
    bool open, sent_any;
    bool due;                 // a message is sent in this step
    uint64_t retry, pause;    // of a client: the tick time at which it connects again, and how long it waits before that attempt
} SmNetChannel;

typedef struct SmNet {
    SmNetChannel *channel;
    uint8_t channels;
    SmStateVec *sv;
    // The field below belongs to the runtime.
    uint8_t failed;           // index into `channel`: the one that could not be opened, or that failed last
} SmNet;

// Compatible with SmTaskInit and SmTaskStep; the context is an SmNet.

// Open all sockets.  sm_receive_init also stores the values of @safe.  If a channel fails, the result is its error and the sockets opened so
// far are closed.  SM_E_ARGUMENT: a row is invalid.
SmResult sm_receive_init(void *net);
SmResult sm_send_init(void *net);

// Never wait.  Return SM_OK, or the error of the first channel that failed; the other ones are still served.  A peer that is not connected,
// or does not receive, is no failure: it is counted.  SM_E_TIMEOUT: the lock of the
// state vector timed out: no element was changed, and what has arrived is stored in the next step.
SmResult sm_receive_step(void *net, const SmTick *tick);
SmResult sm_send_step(void *net, const SmTick *tick);

void sm_net_close(SmNet *net);        // closes all sockets

#ifdef __cplusplus
}
#endif
#endif

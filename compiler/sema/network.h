// SPDX-License-Identifier: Apache-2.0
// The typed .net (config.md 11): which messages are sent and received, and what they contain.  The checker's output for a tree without
// errors.  The emitters read it; no code changes it after the check.
#ifndef SMC_NETWORK_H
#define SMC_NETWORK_H

#include "compiler/sema/program.h"

// Bytes of the header, authentication code and CRC of a message (docs/config.md 11.14), and the most bytes of a whole message.
enum { NET_HEADER = 16, NET_CODE = 16, NET_CRC = 4, NET_MOST = 1472 };

typedef enum NetCount {
#define SM_NET_COUNT(name, word, text) NET_COUNT_##name,
#include "stdlib/net_counts.def"
#undef SM_NET_COUNT
    NET_COUNTS
} NetCount;

extern const char *const net_count_words[NET_COUNTS];     // the word after @count that selects the counter
extern const char *const net_count_texts[NET_COUNTS];     // what the counter counts, for messages

// The value of an element while no message arrives: the last one, NaN, or one that the user gave with @default or @safe.  Ordered as SmNetSilent
// of runtime-c/net.h.
typedef enum NetSilent { NET_HOLD, NET_UNKNOWN, NET_DEFAULT, NET_SAFE } NetSilent;

typedef struct NetField {
    const Element *element;
    NetSilent silent;
    uint64_t cell;            // DEFAULT, SAFE: the value, as a bit cell of the element's type (convert.h)
    Span span;
} NetField;

typedef struct NetStatistic { NetCount count; const Element *element; } NetStatistic;

typedef enum NetTransport { NET_UDP, NET_TCP_CLIENT, NET_TCP_SERVER } NetTransport;

typedef struct NetChannel {
    bool is_send;
    NetTransport transport;
    uint32_t peers;           // the most connections at once: 0 for UDP, 1 for a TCP client
    Str name;
    Span span, where;         // positions of the channel's name and of its address
    uint8_t ip[4];            // UDP: the receiver, a multicast group, or the local address (0.0.0.0: any); client: the server; server: local address
    uint16_t port;
    uint8_t interface[4];     // address of the local network interface for multicast; 0.0.0.0: the system chooses
    uint64_t period, timeout; // in nanoseconds: the time between two sends; the argument of @timeout, 0: none
    Str key;                  // the argument of @key; or NULL
    const Element *run;       // @run: the element with the number of starts of the sender; or NULL
    const Element *age;       // @age: the element that receives the milliseconds since the last message; or NULL
    VEC(NetField) field;
    VEC(NetStatistic) statistic;
    uint32_t hash;            // hash of the message's name and of the names, types and order of its elements
    uint32_t size;            // bytes of the whole message
} NetChannel;

typedef struct Network {
    Str name;                 // the file's stem
    const Source *src;
    const StateVec *sv;
    VEC(NetChannel *) channel;        // in file order
} Network;

static inline bool net_is_tcp(const NetChannel *c) { return c->transport != NET_UDP; }
// Whether this computer waits for messages or connections from another one: it receives by UDP, or is a server.
static inline bool net_listens(const NetChannel *c) { return net_is_tcp(c) ? c->transport == NET_TCP_SERVER : !c->is_send; }
uint32_t net_sockets(const Network *net);     // returns the most sockets that all channels need at once
static inline bool net_is_multicast(const uint8_t *ip) { return ip[0] >= 224 && ip[0] <= 239; }
const char *net_address_text(Arena *arena, const NetChannel *c);      // returns the address with its port: "239.1.2.3:5000"

#endif
